#pragma once

#include <limits>

#include "base/grid.h"

namespace fumon {

/// The slopes of a bed along the wind, in heights a site (magnitudes). With the wind toward +x the
/// stoss side, which faces it, rises and the lee side falls. NaN where there is no such side.
struct BedSlopes {
    double stoss = std::numeric_limits<double>::quiet_NaN();  ///< total rise over rising sites
    double lee = std::numeric_limits<double>::quiet_NaN();    ///< total fall over falling sites
    double steep_stoss = std::numeric_limits<double>::quiet_NaN();  ///< 90th percentile of rises
    double steep_lee = std::numeric_limits<double>::quiet_NaN();    ///< 90th percentile of falls
    /// stoss / lee: above 1 the side that faces the wind is the steeper and shorter one, below 1 it
    /// is the lee side, as on real dunes and ripples.
    double stoss_to_lee = std::numeric_limits<double>::quiet_NaN();
};

/// From the forward differences h(x + 1) − h(x) of every row; in a periodic bed, those round the
/// edge too. Percentiles are of the nearest rank. Differences below 1e-12 of the highest |h| are
/// level ground and count on neither side. Noise from site to site raises both sides alike and
/// draws the ratio toward 1; so does a forward difference where a side is shorter than a few sites.
/// A difference to or from a cell without data (`nodata`, empty for none) does not count.
BedSlopes bed_slopes(const Grid& bed, bool periodic, const Mask& nodata = {});

}  // namespace fumon
