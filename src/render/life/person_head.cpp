#include "render/life/person_head.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

namespace fumon {

namespace {

/// Eyes, brows, nose, mouth and ears on the head of add_head().
void add_face(BodyMesh& mesh, const PersonFigure& figure) {
    const glm::vec3& skin = figure.skin;
    for (const double side : {-1.0, 1.0}) {
        const auto at = [side](double x, double y, double z) { return glm::dvec3(side * x, y, z); };
        add_detail(mesh, at(0.031, 0.0830, 1.622), {0.020, 0.009, 0.0105}, 0.72F * skin);
        add_detail(mesh, at(0.0315, 0.0905, 1.620), {0.0125, 0.008, 0.0058},
                   glm::vec3(0.022F, 0.017F, 0.014F));
        add_detail(mesh, at(0.032, 0.0870, 1.6385), {0.019, 0.0085, 0.0038}, figure.hair);
        add_detail(mesh, at(0.070, 0.000, 1.602), {0.011, 0.020, 0.032}, 0.9F * skin);
    }
    LimbLook look{skin, 12, 2, 0.7, 0.3};
    look.is_detail = true;
    add_limb(mesh,
             {{{0.0, 0.108, 1.583}, 0.017, 0.015, 0.0, 0.8},
              {{0.0, 0.112, 1.592}, 0.016, 0.018},
              {{0.0, 0.106, 1.612}, 0.011, 0.012},
              {{0.0, 0.098, 1.635}, 0.009, 0.008}},
             look);
    add_detail(mesh, {0.0, 0.0965, 1.5545}, {0.025, 0.010, 0.0060},
               skin * glm::vec3(0.72F, 0.52F, 0.52F));
}

void add_hat(BodyMesh& mesh, const PersonFigure& figure) {
    const std::size_t first = mesh.corners.size();
    add_round(mesh, {0.0, 0.006, 1.668}, {0.165, 0.185, 0.010}, figure.on_head, 24);
    move_from(mesh, first, [](const glm::dvec3& p) {
        return p + glm::dvec3(0.0, 0.0, 0.9 * p.x * p.x - 0.5 * p.y * p.y);
    });
    LimbLook look{figure.on_head, 22, 4, 0.0, 0.35};
    add_limb(mesh,
             {{{0.0, 0.006, 1.662}, 0.083, 0.101, 0.0, 0.8},
              {{0.0, 0.006, 1.690}, 0.081, 0.098},
              {{0.0, 0.002, 1.735}, 0.070, 0.086},
              {{0.0, 0.000, 1.765}, 0.052, 0.066}},
             look);
    add_limb(mesh, {{{0.0, 0.006, 1.668}, 0.0845, 0.1025}, {{0.0, 0.006, 1.688}, 0.0830, 0.1005}},
             {0.45F * figure.on_head, 22, 2, 0.0, 0.0});
}

void add_cap(BodyMesh& mesh, const PersonFigure& figure) {
    const std::size_t first = mesh.corners.size();
    add_round(mesh, {0.0, 0.098, 1.662}, {0.068, 0.088, 0.008}, figure.on_head, 18);
    move_from(mesh, first, [](const glm::dvec3& p) {
        const double out = std::max(p.y - 0.09, 0.0);
        return p - glm::dvec3(0.0, 0.0, 0.22 * out + 2.2 * p.x * p.x);
    });
    add_limb(mesh,
             {{{0.0, 0.004, 1.652}, 0.080, 0.101, 0.0, 0.8},
              {{0.0, 0.003, 1.680}, 0.081, 0.101},
              {{0.0, -0.002, 1.715}, 0.068, 0.086},
              {{0.0, -0.006, 1.735}, 0.044, 0.058}},
             {figure.on_head, 20, 4, 0.0, 0.3});
}

void add_hair(BodyMesh& mesh, const PersonFigure& figure) {
    const bool is_covered = figure.headwear != Headwear::hair;
    const double size = is_covered ? 0.97 : 1.0;
    add_round(mesh, {0.0, -0.007, 1.643},
              glm::dvec3(0.081, 0.097, is_covered ? 0.085 : 0.091) * size, figure.hair, 24);
    if (!figure.has_long_hair) return;
    LimbLook look{figure.hair, 18, 4, 0.5, 0.5};
    look.phase = figure.folds;
    add_limb(mesh,
             {{{0.0, -0.070, 1.410}, 0.050, 0.022, 0.003},
              {{0.0, -0.066, 1.480}, 0.068, 0.034, 0.003},
              {{0.0, -0.050, 1.560}, 0.076, 0.052, 0.002},
              {{0.0, -0.030, 1.640}, 0.076, 0.064}},
             look);
}

}  // namespace

void add_head(BodyMesh& mesh, const PersonFigure& figure, const Carriage& carriage) {
    const std::size_t first = mesh.corners.size();
    add_limb(mesh,
             {{{0.0, -0.010, 1.42}, 0.060, 0.060, 0.0, 0.75},
              {{0.0, -0.004, 1.48}, 0.051, 0.054, 0.0, 0.8},
              {{0.0, 0.004, 1.56}, 0.050, 0.054, 0.0, 0.7}},
             {figure.skin, 16, 3, 0.0, 0.3});
    const std::size_t top = mesh.corners.size();
    const LimbLook look{figure.skin, 28, 4, 0.4, 0.35};
    add_limb(mesh,
             {{{0.0, 0.050, 1.503}, 0.022, 0.030, 0.0, 0.8},
              {{0.0, 0.040, 1.520}, 0.044, 0.053, 0.0, 0.9},
              {{0.0, 0.028, 1.550}, 0.058, 0.071},
              {{0.0, 0.020, 1.590}, 0.066, 0.083},
              {{0.0, 0.012, 1.630}, 0.072, 0.090},
              {{0.0, 0.006, 1.665}, 0.070, 0.089},
              {{0.0, 0.002, 1.695}, 0.057, 0.074},
              {{0.0, 0.000, 1.712}, 0.038, 0.050}},
             look);
    add_face(mesh, figure);
    if (figure.headwear != Headwear::scarf) add_hair(mesh, figure);
    switch (figure.headwear) {
        case Headwear::brimmed_hat:
            add_hat(mesh, figure);
            break;
        case Headwear::cap:
            add_cap(mesh, figure);
            break;
        case Headwear::hair:
            break;
        case Headwear::scarf: {
            add_round(mesh, {0.0, -0.013, 1.632}, {0.093, 0.108, 0.104}, figure.on_head, 24);
            add_round(mesh, {0.0, 0.004, 1.672}, {0.081, 0.097, 0.061}, figure.on_head, 24);
            LimbLook cloth{figure.on_head, 24, 5, 0.2, 0.3};
            cloth.phase = figure.folds;
            add_limb(mesh,
                     {{{0.0, -0.012, 1.415}, 0.130, 0.098, 0.004, 0.85},
                      {{0.0, -0.004, 1.455}, 0.106, 0.096, 0.006},
                      {{0.0, 0.000, 1.500}, 0.084, 0.088, 0.005},
                      {{0.0, 0.004, 1.530}, 0.074, 0.082, 0.002}},
                     cloth);
            break;
        }
    }
    turn_from(mesh, top, figure.head_turn * std::numbers::pi / 180.0);
    move_from(mesh, first, [&](const glm::dvec3& p) {
        return p + glm::dvec3(-0.15 * carriage.sway, 1.15 * carriage.lean, 0.0);
    });
}

}  // namespace fumon
