#pragma once

#include <cstdint>

#include "base/grid.h"

namespace fumon {

/// The waves of a bed's rows, counted and summed (see find_waves).
struct BedWaves {
    std::int64_t length = 0;  ///< sites that waves were looked for over
    std::int64_t count = 0;   ///< waves on these
    double relief = 0.0;      ///< sum over the waves, heights
    std::int64_t reliefs = 0;
};

/// In one pass over the bed.
BedWaves bed_waves(const Grid& bed, bool periodic);

}  // namespace fumon
