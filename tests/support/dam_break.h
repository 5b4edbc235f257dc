#pragma once

#include <cmath>

namespace fumon {

/// Depth and velocity at a place and time of a flow along x.
struct FlowPoint {
    double depth = 0.0;     ///< m
    double velocity = 0.0;  ///< m/s
};

/// A dam at x = 0 breaks at t = 0: `left` metres of still water behind it, `right` metres (maybe 0)
/// before it, a flat bed without friction. The self-similar solutions of Ritter (1892) for a dry
/// bed and of Stoker (1957) for a wet one, whose middle depth comes from bisection between the
/// relations of the rarefaction and of the shock. Needs left > right, t > 0.
inline FlowPoint dam_break(double left, double right, double gravity, double x, double t) {
    const double c_left = std::sqrt(gravity * left);
    const double place = x / t;
    const auto rarefaction_velocity = [&](double h) {
        return 2.0 * (c_left - std::sqrt(gravity * h));
    };
    const auto shock_velocity = [&](double h) {
        return (h - right) * std::sqrt(0.5 * gravity * (1.0 / h + 1.0 / right));
    };
    double middle = 0.0;
    if (right > 0.0) {
        double low = right;
        double high = left;
        for (int halving = 0; halving < 200; ++halving) {
            middle = 0.5 * (low + high);
            (shock_velocity(middle) < rarefaction_velocity(middle) ? low : high) = middle;
        }
    }
    const double velocity = rarefaction_velocity(middle);
    if (place <= -c_left) return {left, 0.0};
    if (place < velocity - std::sqrt(gravity * middle)) {
        const double c = (2.0 * c_left - place) / 3.0;
        return {c * c / gravity, 2.0 / 3.0 * (c_left + place)};
    }
    if (right > 0.0 && place < middle * velocity / (middle - right)) return {middle, velocity};
    return {right, 0.0};
}

}  // namespace fumon
