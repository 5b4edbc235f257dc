#include "numerics/clipped_plane.h"

#include <algorithm>
#include <cmath>

namespace fumon::clipped_plane {

namespace {

/// The plane's rises along the cell's sides, the larger first; of both signs the means are alike.
struct Rises {
    double large;
    double small;

    Rises(double x, double y)
        : large(std::max(std::fabs(x), std::fabs(y))),
          small(std::min(std::fabs(x), std::fabs(y))) {}

    /// The fall from the middle to the lowest corner.
    [[nodiscard]] double half() const { return 0.5 * (large + small); }
};

/// Toward the deepest corner, along the larger and the smaller rise.
struct Centre {
    double large;
    double small;
};

Centre centre_of(const Rises& rise, double depth) {
    const double half = rise.half();
    const double wet = depth + half;
    const double dry = half - depth;
    if (!(wet > 0.0)) return {0.0, 0.0};
    if (!(dry > 0.0)) return {rise.large / (12.0 * depth), rise.small / (12.0 * depth)};
    const double six = 6.0 * rise.large * rise.small;
    if (wet < rise.small) return {0.5 - 0.25 * (wet / rise.large), 0.5 - 0.25 * (wet / rise.small)};
    if (dry < rise.small) {
        const double lacking = dry * dry * dry / six;
        const auto moment = [&](double slope) {
            return slope / 12.0 - lacking * (0.5 - 0.25 * (dry / slope));
        };
        return {moment(rise.large) / (depth + lacking), moment(rise.small) / (depth + lacking)};
    }
    const double a = wet / rise.large;         // the wet length along the side of the larger rise
    const double s = rise.small / rise.large;  // by so much it is shorter along the other side
    const double twice = a * a - a * s + s * s / 3.0;  // of the volume over the larger rise
    return {
        0.5 - (a * a * a - 1.5 * (a * a * s) + a * (s * s) - 0.25 * (s * s * s)) / (3.0 * twice),
        0.5 - (0.5 * (a * a) - 2.0 / 3.0 * (a * s) + 0.25 * (s * s)) / twice};
}

constexpr int most_steps = 80;  // of Newton's method, which needs 60 for the thinnest wedge

/// The root of s³ = cube below `highest`, whose cube is no less.
double cube_root_from(double highest, double cube) {
    double s = highest;
    for (int step = 0; step < most_steps; ++step) {
        const double next = s - (s * s * s - cube) / (3.0 * (s * s));
        if (!(next < s)) break;
        s = next;
    }
    return s;
}

}  // namespace

// From dry to wet the water is a pyramid over a triangle, a wedge over a trapezium, and what is
// left of the whole cell without a pyramid over its dry corner.

double mean_depth(double depth, double rise_x, double rise_y) {
    const Rises rise(rise_x, rise_y);
    const double half = rise.half();
    const double wet = depth + half;  // at the deepest corner
    const double dry = half - depth;  // by so much the bed rises over the water at the highest one
    if (!(dry > 0.0)) return depth;
    if (!(wet > 0.0)) return 0.0;
    const double six = 6.0 * rise.large * rise.small;
    if (wet < rise.small) return wet * wet * wet / six;
    if (dry < rise.small) return depth + dry * dry * dry / six;
    const double deep = depth + 0.5 * rise.large;
    return (deep * deep + rise.small * rise.small / 12.0) / (2.0 * rise.large);
}

double depth_of_mean(double mean, double rise_x, double rise_y) {
    const Rises rise(rise_x, rise_y);
    const double half = rise.half();
    if (mean >= half) return mean;
    const double six = 6.0 * rise.large * rise.small;
    if (six * mean < rise.small * rise.small * rise.small)
        return cube_root_from(rise.small, six * mean) - half;
    const double square = 2.0 * rise.large * mean - rise.small * rise.small / 12.0;
    const double middle = std::sqrt(std::max(square, 0.0)) - 0.5 * rise.large;
    if (half - middle >= rise.small) return middle;
    double dry = half - mean;  // the root of dry − dry³/six = half − mean, from below
    for (int step = 0; step < most_steps; ++step) {
        const double over = half - mean - (dry - dry * dry * dry / six);
        const double next = dry + over / (1.0 - 3.0 * (dry * dry) / six);
        if (!(next > dry)) break;
        dry = next;
    }
    return half - dry;
}

MassCentre centre_of_mass(double depth, double rise_x, double rise_y) {
    const Rises rise(rise_x, rise_y);
    const Centre centre = centre_of(rise, depth);
    const double steep_x = std::fabs(rise_x);
    const double steep_y = std::fabs(rise_y);
    const double middle = 0.5 * (centre.large + centre.small);  // as mirrored at the diagonal
    const auto along = [&](double own, double other) {
        return own == other ? middle : own > other ? centre.large : centre.small;
    };
    return {std::copysign(along(steep_x, steep_y), rise_x),
            std::copysign(along(steep_y, steep_x), rise_y)};
}

FaceMeans means_along(double depth, double rise) {
    const double size = std::fabs(rise);
    const double deep = depth + 0.5 * size;
    if (!(deep > 0.0)) return {};
    if (deep >= size) return {depth, depth * depth + size * size / 12.0, rise / (12.0 * depth)};
    return {0.5 * (deep * deep) / size, deep * deep * deep / (3.0 * size),
            std::copysign(0.5 - deep / (3.0 * size), rise)};
}

}  // namespace fumon::clipped_plane
