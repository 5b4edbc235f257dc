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

FaceMeans means_along(double depth, double rise) {
    const double size = std::fabs(rise);
    const double deep = depth + 0.5 * size;
    if (!(deep > 0.0)) return {};
    if (deep >= size) return {depth, depth * depth + size * size / 12.0};
    return {0.5 * (deep * deep) / size, deep * deep * deep / (3.0 * size)};
}

}  // namespace fumon::clipped_plane
