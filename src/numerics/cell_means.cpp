#include "numerics/cell_means.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fumon::cell_means {

namespace {

constexpr int rounds = 2;  // the slopes that velocities have, by those that carried ones have
constexpr double steepest = 2.0;  // of linear depth over its mean, where all of a cell is wet

/// A twelfth of the depth's slope over the depth, along x and along y.
struct Lean {
    double x;
    double y;
};

/// The depth's parabola.
struct Parabola {
    double x;
    double y;
    double xx;
    double xy;
    double yy;

    explicit Parabola(const Patch& h)
        : x(0.5 * (h[5] - h[3])),
          y(0.5 * (h[7] - h[1])),
          xx((h[5] - h[4]) - (h[4] - h[3])),
          xy(0.25 * ((h[8] + h[0]) - (h[6] + h[2]))),
          yy((h[7] - h[4]) - (h[4] - h[1])) {}

    [[nodiscard]] Lean lean(int dx, int dy, double depth) const {
        const auto of = [&](double slope) {
            return std::clamp(slope / depth, 0.0 - steepest, steepest) / 12.0;
        };
        return {of(x + (xx * dx + xy * dy)), of(y + (xy * dx + yy * dy))};
    }
};

}  // namespace

double limited_slope(double back, double forward, double steepness) {
    if (!(back * forward > 0.0)) return 0.0;
    const double middle = 0.5 * (back + forward);
    const double most = steepness * std::min(std::fabs(back), std::fabs(forward));
    return std::fabs(middle) < most ? middle : std::copysign(most, middle);
}

Linear velocity_of(const Patch& depth, const Patch& carried, double steepness) {
    constexpr std::size_t south = 1;
    constexpr std::size_t west = 3;
    constexpr std::size_t here = 4;
    constexpr std::size_t east = 5;
    constexpr std::size_t north = 7;
    const Parabola parabola(depth);
    const Lean lean = parabola.lean(0, 0, depth[here]);
    const Lean lean_south = parabola.lean(0, -1, depth[south]);
    const Lean lean_west = parabola.lean(-1, 0, depth[west]);
    const Lean lean_east = parabola.lean(1, 0, depth[east]);
    const Lean lean_north = parabola.lean(0, 1, depth[north]);
    Linear u{carried[here], 0.0, 0.0};
    for (int round = 0; round <= rounds; ++round) {
        const auto middle = [&](std::size_t cell, const Lean& at) {
            return carried[cell] - (u.along_x * at.x + u.along_y * at.y);
        };
        const double value = middle(here, lean);
        const double along_x = limited_slope(value - middle(west, lean_west),
                                             middle(east, lean_east) - value, steepness);
        const double along_y = limited_slope(value - middle(south, lean_south),
                                             middle(north, lean_north) - value, steepness);
        u.along_x = along_x;
        u.along_y = along_y;
    }
    u.middle = carried[here] - (u.along_x * lean.x + u.along_y * lean.y);
    return u;
}

}  // namespace fumon::cell_means
