#pragma once

#include "base/grid.h"

namespace fumon {

/// The simplest numbers of a bed, in its own height unit; cells without data do not count.
struct BedStatistics {
    double mean = 0.0;
    double standard_deviation = 0.0;  ///< of the population (divided by the number of cells)
    double minimum = 0.0;
    double maximum = 0.0;
    double total = 0.0;  ///< sum of heights over cells: the sand, in heights × cells
};

/// Computed in a fixed order with compensated sums (Neumaier 1974), so that the total of a
/// conserving model changes only by the model's own rounding. All zero when no cell has data.
BedStatistics bed_statistics(const Grid& bed, const Mask& nodata);

}  // namespace fumon
