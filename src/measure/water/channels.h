#pragma once

#include <limits>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// The channels that water has gathered in, on a slope toward −y.
struct Channels {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::vector<int> sites;         ///< the columns of the maxima, ascending
    std::vector<double> positions;  ///< their x, refined by a parabola, metres from the west edge
    double width = 0.0;             ///< of the slope, metres

    double count = none;    ///< of them; NaN where it cannot be told
    double spacing = none;  ///< the width of the slope over their number, metres; NaN without any
    /// Metres from a channel to the next, on a periodic slope round its edge: the mean, and the
    /// standard deviation over it (0 for evenly spaced ones). NaN for fewer than two.
    double mean_distance = none;
    double distance_variation = none;
};

/// The maxima of the depth's mean down the slope (downslope_mean), smoothed by a Gaussian of 2
/// cells, that stand out by 25 % of the smoothed line's range or more: by their topographic
/// prominence, see prominent_maxima. None where that range is below 1e-9 of the largest depth,
/// which is rounding.
///
/// It sees channels that run straight down; one that swings by more than its own width is smeared
/// out by the mean, and channels that lie askew come out as none or at random. Cells without data
/// do not count; where a column has no other the count is NaN. `dx` in metres.
Channels find_channels(const Grid& depth, const Mask& nodata, double dx, bool periodic);

}  // namespace fumon
