#pragma once

#include <cstdint>

#include "base/grid.h"

namespace fumon {

/// The mean distance of the cells with data (0 in `nodata`, which may be empty) from the nearest
/// one that `channels` marks, as the crow flies, 0 in these; in the unit of dx and dy. Not a number
/// without a channel. Exact: the squared distances along x, then the lower envelope of their
/// parabolas along y (Felzenszwalb & Huttenlocher 2012). `wraps_x`: x goes on at the other side.
double mean_channel_distance(const Field<std::uint8_t>& channels, const Mask& nodata, double dx,
                             double dy, bool wraps_x = false);

}  // namespace fumon
