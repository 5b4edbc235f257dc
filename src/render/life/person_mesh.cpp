#include "render/life/person_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "base/elementary.h"
#include "base/random.h"

namespace fumon {

namespace {

// Rounded to what photographs show.
const glm::vec3 shoes{0.060F, 0.045F, 0.035F};
const glm::vec3 pack{0.060F, 0.090F, 0.055F};

/// An ellipse of a limb: its middle and half its width and depth.
struct BodyRing {
    glm::dvec3 middle;
    double width;
    double depth;
};

constexpr int sides = 20;   // of a limb, around
constexpr int between = 5;  // rings drawn from one given to the next

/// Through b and c, at t = 0 … 1 (Catmull & Rom 1974).
double between_points(double a, double b, double c, double d, double t) {
    return b +
           0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

BodyRing ring_between(const std::vector<BodyRing>& rings, std::size_t i, double t) {
    const BodyRing& b = rings[i];
    const BodyRing& c = rings[i + 1];
    const BodyRing& a = i > 0 ? rings[i - 1] : b;
    const BodyRing& d = i + 2 < rings.size() ? rings[i + 2] : c;
    BodyRing ring{};
    for (int axis = 0; axis < 3; ++axis)
        ring.middle[axis] =
            between_points(a.middle[axis], b.middle[axis], c.middle[axis], d.middle[axis], t);
    ring.width = std::max(between_points(a.width, b.width, c.width, d.width, t), 0.0);
    ring.depth = std::max(between_points(a.depth, b.depth, c.depth, d.depth, t), 0.0);
    return ring;
}

/// A surface of rows of `sides` points, closed around; normals from its own differences.
void add_surface(std::vector<PersonVertex>& mesh, const std::vector<std::vector<glm::dvec3>>& rows,
                 const glm::vec3& colour) {
    const auto point = [&](std::size_t row, int side) {
        return rows[row][static_cast<std::size_t>((side + sides) % sides)];
    };
    const auto corner = [&](std::size_t row, int side) {
        const std::size_t below = row > 0 ? row - 1 : row;
        const std::size_t above = std::min(row + 1, rows.size() - 1);
        glm::dvec3 around = point(row, side + 1) - point(row, side - 1);
        if (glm::length(around) < 1e-9)  // a pole
            around =
                point(row == 0 ? 1 : row - 1, side + 1) - point(row == 0 ? 1 : row - 1, side - 1);
        const glm::dvec3 along = point(above, side) - point(below, side);
        return PersonVertex{glm::vec3(point(row, side)),
                            glm::vec3(glm::normalize(glm::cross(around, along))), colour};
    };
    for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
        for (int side = 0; side < sides; ++side) {
            const PersonVertex a = corner(row, side);
            const PersonVertex b = corner(row, side + 1);
            const PersonVertex c = corner(row + 1, side);
            const PersonVertex d = corner(row + 1, side + 1);
            mesh.insert(mesh.end(), {a, b, c, b, d, c});
        }
    }
}

/// Level ellipses from below upward, rounded off at both ends.
void add_limb(std::vector<PersonVertex>& mesh, const std::vector<BodyRing>& rings,
              const glm::vec3& colour) {
    std::vector<BodyRing> all;
    const auto add_end = [&](const BodyRing& end, double way) {
        constexpr std::array shares{0.05, 0.45, 0.8};
        for (std::size_t k = 0; k < shares.size(); ++k) {
            const double share = way < 0.0 ? shares.at(k) : shares.at(shares.size() - 1 - k);
            BodyRing round = end;
            round.width *= share;
            round.depth *= share;
            round.middle.z += way * std::sqrt(1.0 - share * share) * std::min(end.width, end.depth);
            all.push_back(round);
        }
    };
    add_end(rings.front(), -1.0);
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
        for (int k = 0; k < between; ++k)
            all.push_back(ring_between(rings, i, static_cast<double>(k) / between));
    }
    all.push_back(rings.back());
    add_end(rings.back(), 1.0);
    std::vector<std::vector<glm::dvec3>> rows;
    rows.reserve(all.size());
    for (const BodyRing& ring : all) {
        std::vector<glm::dvec3>& row = rows.emplace_back();
        for (int side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            row.push_back(ring.middle + glm::dvec3(ring.width * elementary::cos(angle),
                                                   ring.depth * elementary::sin(angle), 0.0));
        }
    }
    add_surface(mesh, rows, colour);
}

/// An ellipsoid.
void add_round(std::vector<PersonVertex>& mesh, const glm::dvec3& middle, const glm::dvec3& radii,
               const glm::vec3& colour) {
    constexpr int steps = 12;
    std::vector<std::vector<glm::dvec3>> rows;
    for (int step = 0; step <= steps; ++step) {
        const double rise = std::numbers::pi * (static_cast<double>(step) / steps - 0.5);
        std::vector<glm::dvec3>& row = rows.emplace_back();
        for (int side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            const double out = step == 0 || step == steps ? 0.0 : elementary::cos(rise);
            row.push_back(middle + radii * glm::dvec3(out * elementary::cos(angle),
                                                      out * elementary::sin(angle),
                                                      elementary::sin(rise)));
        }
    }
    add_surface(mesh, rows, colour);
}

/// A leg in trousers, and its shoe. `before`: how far the foot stands before the hips; the heel of
/// a foot behind them is lifted.
void add_leg(std::vector<PersonVertex>& mesh, const PersonFigure& figure, double side,
             double before) {
    const double lifted = 0.45 * std::max(-before, 0.0);
    const double knee = 0.035 + 0.55 * before + 0.5 * std::max(-before, 0.0);
    const auto at = [side](double x, double y, double z) { return glm::dvec3(side * x, y, z); };
    add_round(mesh, at(0.098, before + 0.045, 0.045 + 0.3 * lifted),
              {0.048, 0.135, 0.048 + 0.3 * lifted}, shoes);
    add_limb(mesh,
             {{at(0.098, before - 0.015, 0.09 + lifted), 0.043, 0.050},
              {at(0.099, 0.7 * before + 0.3 * knee - 0.02, 0.28), 0.058, 0.066},
              {at(0.098, knee, 0.49), 0.061, 0.068},
              {at(0.096, 0.4 * knee, 0.70), 0.079, 0.086},
              {at(0.088, 0.0, 0.88), 0.090, 0.105}},
             figure.trousers);
}

/// An arm, whose sleeve ends at the wrist. `swing`: how far the hand hangs before the shoulder.
void add_arm(std::vector<PersonVertex>& mesh, const PersonFigure& figure, double side,
             double swing) {
    const double bent = figure.elbows;
    const auto at = [side](double x, double y, double z) { return glm::dvec3(side * x, y, z); };
    const glm::dvec3 wrist = at(0.262 - 0.05 * bent, swing + 0.13 * bent, 0.90 + 0.10 * bent);
    add_limb(
        mesh,
        {{at(0.262 - 0.07 * bent, swing + 0.03 + 0.19 * bent, 0.80 + 0.15 * bent), 0.034, 0.040},
         {wrist, 0.030, 0.034}},
        figure.skin);
    add_limb(mesh,
             {{wrist, 0.033, 0.036},
              {at(0.258, 0.4 * swing - 0.03 - 0.02 * bent, 1.10), 0.040, 0.044},
              {at(0.224, -0.01, 1.27), 0.046, 0.052},
              {at(0.183, 0.0, 1.375), 0.048, 0.056}},
             figure.shirt);
}

void add_trunk(std::vector<PersonVertex>& mesh, const PersonFigure& figure) {
    add_limb(mesh, {{{0.0, 0.0, 0.87}, 0.160, 0.105}, {{0.0, 0.0, 0.96}, 0.165, 0.112}},
             figure.trousers);
    add_limb(mesh,
             {{{0.0, 0.0, 0.97}, 0.158, 0.110},
              {{0.0, 0.0, 1.08}, 0.150, 0.106},
              {{0.0, 0.005, 1.24}, 0.172, 0.116},
              {{0.0, 0.0, 1.36}, 0.188, 0.104},
              {{0.0, -0.005, 1.42}, 0.150, 0.082},
              {{0.0, -0.005, 1.46}, 0.078, 0.066}},
             figure.shirt);
    if (!figure.pack) return;
    add_limb(mesh,
             {{{0.0, -0.155, 1.02}, 0.115, 0.060},
              {{0.0, -0.170, 1.20}, 0.130, 0.078},
              {{0.0, -0.150, 1.36}, 0.105, 0.060}},
             pack);
}

void add_head(std::vector<PersonVertex>& mesh, const PersonFigure& figure) {
    const std::size_t first = mesh.size();
    add_limb(mesh, {{{0.0, 0.0, 1.45}, 0.054, 0.056}, {{0.0, 0.01, 1.55}, 0.052, 0.054}},
             figure.skin);
    add_round(mesh, {0.0, 0.018, 1.605}, {0.074, 0.092, 0.108}, figure.skin);
    switch (figure.headwear) {
        case Headwear::brimmed_hat:
            add_round(mesh, {0.0, 0.012, 1.652}, {0.185, 0.205, 0.014}, figure.on_head);
            add_limb(mesh,
                     {{{0.0, 0.012, 1.652}, 0.092, 0.108}, {{0.0, 0.012, 1.700}, 0.080, 0.094}},
                     figure.on_head);
            break;
        case Headwear::cap:
            add_round(mesh, {0.0, 0.115, 1.648}, {0.070, 0.085, 0.012}, figure.on_head);
            add_round(mesh, {0.0, 0.012, 1.650}, {0.084, 0.102, 0.075}, figure.on_head);
            break;
        case Headwear::hair:
            add_round(mesh, {0.0, -0.004, 1.638}, {0.086, 0.094, 0.092}, figure.on_head);
            break;
        case Headwear::scarf:
            add_round(mesh, {0.0, -0.018, 1.622}, {0.094, 0.106, 0.114}, figure.on_head);
            add_limb(mesh, {{{0.0, -0.01, 1.43}, 0.110, 0.092}, {{0.0, 0.0, 1.51}, 0.090, 0.086}},
                     figure.on_head);
            break;
    }
    const double angle = figure.head_turn * std::numbers::pi / 180.0;
    const auto c = static_cast<float>(elementary::cos(angle));
    const auto s = static_cast<float>(elementary::sin(angle));
    const auto turned = [&](const glm::vec3& v) {
        return glm::vec3(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
    };
    for (std::size_t i = first; i < mesh.size(); ++i) {
        mesh[i].position = turned(mesh[i].position);
        mesh[i].normal = turned(mesh[i].normal);
    }
}

}  // namespace

PersonFigure person_figure(std::size_t number) {
    PersonFigure figure;
    if (number == 0) return figure;
    const std::array<glm::vec3, 9> shirts{{{0.55F, 0.53F, 0.48F},
                                           {0.10F, 0.16F, 0.28F},
                                           {0.30F, 0.24F, 0.14F},
                                           {0.12F, 0.20F, 0.14F},
                                           {0.50F, 0.22F, 0.05F},
                                           {0.055F, 0.060F, 0.070F},
                                           {0.42F, 0.36F, 0.10F},
                                           {0.20F, 0.27F, 0.34F},
                                           {0.26F, 0.06F, 0.11F}}};
    const std::array<glm::vec3, 5> trousers{{{0.060F, 0.075F, 0.120F},
                                             {0.23F, 0.185F, 0.120F},
                                             {0.055F, 0.055F, 0.055F},
                                             {0.13F, 0.13F, 0.095F},
                                             {0.34F, 0.30F, 0.23F}}};
    const std::array<glm::vec3, 4> skins{{{0.45F, 0.28F, 0.19F},
                                          {0.34F, 0.20F, 0.13F},
                                          {0.21F, 0.115F, 0.070F},
                                          {0.095F, 0.055F, 0.038F}}};
    const std::array<glm::vec3, 4> cloths{{{0.42F, 0.37F, 0.28F},
                                           {0.60F, 0.58F, 0.53F},
                                           {0.10F, 0.14F, 0.24F},
                                           {0.22F, 0.15F, 0.08F}}};
    const std::array<glm::vec3, 3> hairs{
        {{0.022F, 0.018F, 0.015F}, {0.070F, 0.042F, 0.024F}, {0.21F, 0.15F, 0.085F}}};
    RandomStream stream(number, 0, 0, Purpose::persons);
    const auto uniform_in = [&](double low, double high) {
        return low + (high - low) * stream.uniform();
    };
    const auto one_of = [&](const auto& choices) {
        return choices.at(stream.below(static_cast<std::uint32_t>(choices.size())));
    };
    figure.height = 0.5 * (uniform_in(1.58, 1.90) + uniform_in(1.58, 1.90));
    figure.girth = uniform_in(0.90, 1.16);
    const bool walks = stream.uniform() < 0.55;
    figure.stride = walks ? uniform_in(0.09, 0.17) : uniform_in(0.0, 0.035);
    figure.leading = stream.uniform() < 0.5 ? -1.0 : 1.0;
    figure.elbows = walks ? uniform_in(0.0, 0.4) : uniform_in(0.0, 1.0);
    figure.head_turn = uniform_in(-40.0, 40.0);
    figure.pack = stream.uniform() < 0.5;
    figure.headwear = static_cast<Headwear>(stream.below(4));
    figure.trousers = one_of(trousers);
    figure.shirt = one_of(shirts);
    figure.skin = one_of(skins);
    figure.on_head = figure.headwear == Headwear::hair ? one_of(hairs) : one_of(cloths);
    return figure;
}

double person_facing(std::size_t number) {
    constexpr double south = 180.0;
    constexpr double farthest = 120.0;
    if (number == 0) return south;
    RandomStream stream(number, 1, 0, Purpose::persons);
    return south + farthest * (2.0 * stream.uniform() - 1.0);
}

std::vector<PersonVertex> person_mesh(const PersonFigure& figure) {
    std::vector<PersonVertex> mesh;
    for (const double side : {-1.0, 1.0}) {
        const double before = figure.stride * figure.leading * side;
        add_leg(mesh, figure, side, before);
        add_arm(mesh, figure, side, -0.77 * before);  // arms go with the other foot
    }
    add_trunk(mesh, figure);
    add_head(mesh, figure);
    // To its height: hat and soles round it off.
    float lowest = mesh.front().position.z;
    float highest = lowest;
    for (const PersonVertex& corner : mesh) {
        lowest = std::min(lowest, corner.position.z);
        highest = std::max(highest, corner.position.z);
    }
    const float scale = static_cast<float>(figure.height) / (highest - lowest);
    const glm::vec3 size(glm::vec2(scale * static_cast<float>(figure.girth)), scale);
    for (PersonVertex& corner : mesh) {
        corner.position.z -= lowest;
        corner.position *= size;
        corner.normal = glm::normalize(corner.normal / size);
    }
    return mesh;
}

}  // namespace fumon
