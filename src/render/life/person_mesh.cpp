#include "render/life/person_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"
#include "render/life/person_head.h"

namespace fumon {

namespace {

// Rounded to what photographs show.
const glm::vec3 shoes{0.060F, 0.045F, 0.035F};
const glm::vec3 soles{0.030F, 0.028F, 0.026F};
constexpr double ankle_height = 0.09;

double smooth(double from, double to, double value) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double mixed(double from, double to, double share) {
    return from + share * (to - from);
}

Carriage carriage_of(const PersonFigure& figure) {
    return {0.030 * figure.weight, -0.07 * figure.weight, 0.55 * figure.stride * figure.leading,
            figure.lean};
}

/// A boot about (x, before), its heel lifted by an angle about the ball of the foot.
void add_shoe(BodyMesh& mesh, double side, double before, double x, double pitch) {
    const std::size_t first = mesh.corners.size();
    const auto ring = [&](double y, double z, double width, double depth) {
        return BodyRing{{0.0, y, z}, width, depth};
    };
    LimbLook sole{soles, 18, 2, 0.05, 0.0};
    sole.box = 0.06;
    add_limb(mesh, {ring(0.055, 0.0, 0.046, 0.137), ring(0.055, 0.028, 0.048, 0.140)}, sole);
    LimbLook upper{shoes, 18, 3, 0.0, 0.0};
    upper.box = 0.05;
    add_limb(mesh,
             {ring(0.055, 0.026, 0.046, 0.136), ring(0.048, 0.050, 0.046, 0.126),
              ring(0.018, 0.078, 0.043, 0.088), ring(-0.018, 0.102, 0.040, 0.052),
              ring(-0.020, 0.115, 0.038, 0.038)},
             upper);
    const double c = elementary::cos(pitch);
    const double s = elementary::sin(pitch);
    constexpr double ball = 0.10;
    move_from(mesh, first, [&](const glm::dvec3& p) {
        if (p.y >= ball) return p;
        return glm::dvec3(p.x, ball + (p.y - ball) * c + p.z * s, (ball - p.y) * s + p.z * c);
    });
    turn_from(mesh, first, -0.14 * side);
    move_from(mesh, first,
              [&](const glm::dvec3& p) { return p + glm::dvec3(side * x, before, 0.0); });
}

/// A leg in trousers, and its shoe. `before`: how far the foot stands before the hips; the heel of
/// a foot behind them is lifted.
void add_leg(BodyMesh& mesh, const PersonFigure& figure, double side, double before) {
    const double behind = std::max(-before, 0.0);
    const bool is_free = figure.weight * side < 0.0;  // the other one carries
    const double pitch = 2.6 * behind;
    const double x = is_free ? 0.125 : 0.103;
    add_shoe(mesh, side, before, x, pitch);
    constexpr double from_ball = 0.12;
    const double ankle =
        before + 0.10 - from_ball * elementary::cos(pitch) + ankle_height * elementary::sin(pitch);
    const double height =
        from_ball * elementary::sin(pitch) + ankle_height * elementary::cos(pitch);
    const double knee = (is_free ? 0.060 : 0.022) + 0.55 * before + 0.50 * behind;
    const auto at = [&](double aside, double y, double z) {
        return glm::dvec3(side * aside, y, z);
    };
    LimbLook look{figure.trousers, 20, 6, 0.05, 0.5};
    look.phase = figure.folds + 1.7 * side;
    add_limb(mesh,
             {{at(x, ankle, height - 0.045), 0.055, 0.071, 0.0040, 0.8},
              {at(x, mixed(ankle, knee, 0.15), height + 0.04), 0.053, 0.064, 0.0050},
              {at(mixed(x, 0.099, 0.6), mixed(ankle, knee, 0.5) - 0.012, mixed(height, 0.49, 0.5)),
               0.059, 0.068, 0.0015},
              {at(0.099, knee, 0.49), 0.061, 0.069, 0.0040},
              {at(0.094, 0.4 * knee, 0.70), 0.076, 0.087, 0.0020},
              {at(0.081, 0.0, 0.845), 0.080, 0.104, 0.0030, 0.75},
              {at(0.078, 0.0, 0.92), 0.070, 0.095}},
             look);
}

/// A hand from the wrist along a direction.
void add_hand(BodyMesh& mesh, const PersonFigure& figure, double side, const glm::dvec3& wrist,
              const glm::dvec3& along) {
    const auto ring = [&](double way, double forward, double thick, double broad) {
        return BodyRing{wrist + way * along + glm::dvec3(-0.09 * way * side, forward, 0.0), thick,
                        broad};
    };
    LimbLook look{figure.skin, 14, 3, 0.8, 0.5};
    add_limb(mesh,
             {ring(0.172, 0.022, 0.009, 0.020), ring(0.145, 0.016, 0.013, 0.034),
              ring(0.100, 0.006, 0.015, 0.042), ring(0.055, 0.003, 0.017, 0.040),
              ring(0.015, 0.0, 0.023, 0.029), ring(-0.05, 0.0, 0.026, 0.032)},
             look);
    look.sides = 9;
    look.is_detail = true;
    add_limb(mesh,
             {ring(0.105, 0.052, 0.009, 0.011), ring(0.075, 0.048, 0.011, 0.013),
              ring(0.035, 0.024, 0.013, 0.017)},
             look);
}

/// An arm, whose sleeve ends at the wrist or above the elbow. `swing`: how far the hand hangs
/// before the shoulder.
void add_arm(BodyMesh& mesh, const PersonFigure& figure, double side, double swing,
             const Carriage& carriage) {
    const std::size_t first = mesh.corners.size();
    const double bent = figure.elbows + 0.8 * std::max(swing, 0.0);
    const auto at = [side](double x, double y, double z) { return glm::dvec3(side * x, y, z); };
    const glm::dvec3 wrist =
        at(0.232 - 0.04 * bent, swing + 0.015 + 0.13 * bent, 0.90 + 0.10 * bent);
    const glm::dvec3 elbow = at(0.236, 0.4 * swing - 0.03 - 0.02 * bent, 1.12);
    const auto below = [&](double share) { return elbow + share * (wrist - elbow); };
    add_hand(mesh, figure, side, wrist, glm::normalize(wrist - elbow));
    std::vector<BodyRing> sleeve;
    if (figure.has_short_sleeves) {
        add_limb(mesh,
                 {{wrist, 0.0225, 0.0285},
                  {below(0.85), 0.029, 0.035},
                  {below(0.5), 0.035, 0.041},
                  {elbow, 0.036, 0.042},
                  {at(0.220, -0.02, 1.19), 0.033, 0.038}},
                 {figure.skin, 18, 4, 0.3, 0.3});
        sleeve = {{at(0.234, 0.2 * swing - 0.022, 1.15), 0.050, 0.056, 0.0020, 0.85}};
    } else {
        sleeve = {{wrist, 0.033, 0.037, 0.0010, 0.85},
                  {below(0.85), 0.037, 0.041, 0.0020},
                  {below(0.5), 0.039, 0.045, 0.0020},
                  {elbow, 0.041, 0.047, 0.0050}};
    }
    sleeve.insert(sleeve.end(), {{at(0.214, -0.016, 1.225), 0.044, 0.052, 0.0025, 0.9},
                                 {at(0.195, -0.008, 1.325), 0.050, 0.061, 0.0005},
                                 {at(0.160, -0.008, 1.373), 0.046, 0.056}});
    LimbLook look{figure.shirt, 18, 5, 0.05, 0.5};
    look.phase = figure.folds + 2.3 * side;
    add_limb(mesh, sleeve, look);
    move_from(mesh, first, [&](const glm::dvec3& p) {
        return p + glm::dvec3(-0.2 * carriage.sway, carriage.lean, 0.18 * side * carriage.drop);
    });
    turn_from(mesh, first, carriage.twist);
}

void add_pack(BodyMesh& mesh, const PersonFigure& figure) {
    const glm::vec3& colour = figure.pack_colour;
    LimbLook look{colour, 20, 4, 0.35, 0.45};
    look.box = 0.10;
    look.phase = figure.folds;
    add_limb(mesh,
             {{{0.0, -0.165, 0.98}, 0.120, 0.062, 0.002, 0.8},
              {{0.0, -0.178, 1.10}, 0.132, 0.080, 0.003},
              {{0.0, -0.182, 1.25}, 0.135, 0.084, 0.003},
              {{0.0, -0.168, 1.38}, 0.122, 0.072, 0.002},
              {{0.0, -0.158, 1.42}, 0.112, 0.062}},
             look);
    look.box = 0.0;
    look.below = 0.2;
    look.sides = 9;
    look.between = 3;
    look.is_detail = true;
    for (const double side : {-1.0, 1.0}) {
        const auto ring = [&](double x, double y, double z) {
            return BodyRing{{side * x, y, z}, 0.021, 0.011};
        };
        add_limb(mesh,
                 {ring(0.158, -0.040, 1.03), ring(0.146, 0.055, 1.10), ring(0.118, 0.104, 1.18),
                  ring(0.105, 0.116, 1.28), ring(0.100, 0.100, 1.36), ring(0.098, 0.060, 1.415),
                  ring(0.098, -0.02, 1.440), ring(0.098, -0.10, 1.43)},
                 look);
    }
}

void add_trunk(BodyMesh& mesh, const PersonFigure& figure, const Carriage& carriage) {
    const std::size_t first = mesh.corners.size();
    const double hem = figure.hem;
    const double below = std::max(0.85 - hem, 0.0);  // long shirts hang wider, over strides too
    const double wide = 0.12 * below;
    const double deep = (0.12 + 0.9 * figure.stride) * below;
    LimbLook look{figure.shirt, 26, 4, 0.05, 0.0};
    look.box = 0.035;
    look.phase = figure.folds;
    std::vector<BodyRing> rings{{{0.0, 0.0, hem}, 0.178 + wide, 0.130 + deep, 0.0025, 0.75},
                                {{0.0, 0.0, hem + 0.03}, 0.178 + wide, 0.130 + deep, 0.0030}};
    if (hem < 0.8) rings.push_back({{0.0, 0.0, 0.86}, 0.178, 0.128, 0.0030});
    rings.insert(rings.end(), {{{0.0, 0.0, 0.96}, 0.166, 0.118, 0.0030},
                               {{0.0, 0.0, 1.06}, 0.156, 0.112, 0.0045},
                               {{0.0, 0.006, 1.20}, 0.166, 0.118, 0.0025},
                               {{0.0, 0.003, 1.31}, 0.179, 0.114, 0.0010},
                               {{0.0, -0.006, 1.385}, 0.172, 0.094},
                               {{0.0, -0.008, 1.415}, 0.140, 0.082},
                               {{0.0, -0.007, 1.438}, 0.096, 0.071},
                               {{0.0, -0.004, 1.460}, 0.066, 0.063}});
    add_limb(mesh, rings, look);
    LimbLook collar{0.9F * figure.shirt, 20, 2, 0.0, 0.0};
    collar.is_detail = true;
    add_limb(mesh,
             {{{0.0, -0.006, 1.438}, 0.078, 0.071}, {{0.0, -0.010, 1.474}, 0.067, 0.068, 0.0, 0.8}},
             collar);
    LimbLook placket{0.72F * figure.shirt, 8, 3, 0.0, 0.0};
    placket.is_detail = true;
    add_limb(mesh,
             {{{0.0, 0.130 + deep, hem + 0.005}, 0.011, 0.006},
              {{0.0, 0.131 + deep, hem + 0.04}, 0.011, 0.006},
              {{0.0, 0.119, 0.96}, 0.011, 0.005},
              {{0.0, 0.114, 1.06}, 0.011, 0.005},
              {{0.0, 0.126, 1.20}, 0.011, 0.004},
              {{0.0, 0.118, 1.31}, 0.011, 0.004},
              {{0.0, 0.090, 1.385}, 0.011, 0.004},
              {{0.0, 0.062, 1.45}, 0.011, 0.004}},
             placket);
    if (figure.pack) add_pack(mesh, figure);
    for (std::size_t i = first; i < mesh.corners.size(); ++i) {
        glm::vec3& p = mesh.corners[i].position;
        const double z = p.z;
        const double angle = carriage.twist * smooth(0.95, 1.30, z);
        const double c = elementary::cos(angle);
        const double s = elementary::sin(angle);
        const double x = p.x * c - p.y * s + carriage.sway * (1.0 - 1.2 * smooth(0.95, 1.4, z));
        const double y = p.x * s + p.y * c + carriage.lean * smooth(0.9, 1.4, z);
        p = glm::vec3(glm::dvec3(x, y, z + carriage.drop * p.x * smooth(1.05, 1.35, z)));
    }
}

}  // namespace

BodyMesh person_mesh(const PersonFigure& figure) {
    BodyMesh mesh;
    const Carriage carriage = carriage_of(figure);
    for (const double side : {-1.0, 1.0}) {
        const double before = figure.stride * figure.leading * side;
        const std::size_t first = mesh.corners.size();
        add_leg(mesh, figure, side, before);
        move_from(mesh, first, [&](const glm::dvec3& p) {
            return p + glm::dvec3(carriage.sway * smooth(0.1, 0.85, p.z), 0.0, 0.0);
        });
        add_arm(mesh, figure, side, -0.85 * before, carriage);  // arms go with the other foot
    }
    add_trunk(mesh, figure, carriage);
    add_head(mesh, figure, carriage);
    // To its height: hat and soles round it off.
    float lowest = mesh.corners.front().position.z;
    float highest = lowest;
    for (const BodyCorner& corner : mesh.corners) {
        lowest = std::min(lowest, corner.position.z);
        highest = std::max(highest, corner.position.z);
    }
    const float scale = static_cast<float>(figure.height) / (highest - lowest);
    const glm::vec3 size(glm::vec2(scale * static_cast<float>(figure.girth)), scale);
    for (BodyCorner& corner : mesh.corners) {
        corner.position.z -= lowest;
        corner.position *= size;
        corner.normal = glm::normalize(corner.normal / size);
    }
    return mesh;
}

}  // namespace fumon
