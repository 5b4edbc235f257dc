#pragma once

#include <cstdint>

#include "base/grid.h"

namespace fumon {

/// How many cells a bed has.
struct BedSize {
    int nx = 0;
    int ny = 0;
};

/// Heights that are uniform in [low, high), from the seed's own stream of each row.
Grid noise_bed(BedSize size, std::int64_t seed, double low, double high);

/// A heap in the middle that falls from `height` as the squared cosine to 0 at `radius`, which
/// counts as dx and dy, the cells' sizes, do.
Grid heap_bed(BedSize size, double dx, double dy, double height, double radius);

}  // namespace fumon
