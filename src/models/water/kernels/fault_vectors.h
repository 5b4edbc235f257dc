#pragma once

namespace fumon {

/// A row of depths, velocities and bed heights.
struct WaterRow {
    const double* depth;
    const double* velocity_x;
    const double* velocity_y;
    const double* bed;
};

/// 0, or not a number where one of the row's values is not finite; below 0 where a depth is.
double fault_of_row(const WaterRow& row, int count);

/// The largest |a − b|; what is not a number is passed over.
double largest_difference_of_row(const double* a, const double* b, int count);

}  // namespace fumon
