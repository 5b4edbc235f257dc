#pragma once

#include <array>

/// What means over cells tell of flows with linear velocities in water whose depth is a parabola.
/// Lengths are in cells.
namespace fumon::cell_means {

/// Values of a cell and of the eight around it, row by row from the one in the south-west.
using Patch = std::array<double, 9>;

/// A velocity in the cell.
struct Linear {
    double middle = 0.0;
    double along_x = 0.0;
    double along_y = 0.0;
};

/// The velocity in the middle of the patch, whose cells hold their mean `depth` (all > 0) and the
/// velocity at which their water is `carried`, momentum over depth. Of linear velocity u and depth
/// h that has
///
///     (∂h/∂x ∂u/∂x + ∂h/∂y ∂u/∂y) / (12 h)
///
/// more than the middle of the cell: near a shore as much as the middle of the next cell has.
/// Slopes of the velocity are those of a monotonised central limiter, `steepness` times the smaller
/// one-sided difference at most.
Linear velocity_of(const Patch& depth, const Patch& carried, double steepness);

/// The slope of a monotonised central limiter.
double limited_slope(double back, double forward, double steepness);

}  // namespace fumon::cell_means
