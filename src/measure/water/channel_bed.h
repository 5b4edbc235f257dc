#pragma once

#include <limits>

#include "base/grid.h"

namespace fumon {

/// How deep a channel has cut itself into its bed.
struct ChannelBed {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    double position = none;  ///< x of the lowest column's middle, metres from the west edge
    double far_bed = none;   ///< the height of the bed far away, metres
    double lowest = none;    ///< of the channel, above the far bed (below it: negative), metres
    double rim = none;       ///< the highest beside the channel, above the far bed; 0 without any
};

/// Of the bed's mean down the slope (downslope_mean): the channel is its lowest column; far away is
/// what lies farther from that than two fifths of the width, and its height is the median of those
/// columns, since the bed there may sink as a whole. The rim is the highest of the columns nearer
/// than that, since rims may lie some ten widths of the channel away from it, or of those far away
/// where one of them rises above that height over three times as far as any falls below it.
///
/// Made for a single channel that runs straight down; among many, "far away" is no bed at rest. NaN
/// throughout for fewer than 8 columns, where a column has no data, and where the line's range is
/// below 1e-9 of its largest height. `bed` and `dx` in metres.
ChannelBed channel_bed(const Grid& bed, const Mask& nodata, double dx, bool periodic);

}  // namespace fumon
