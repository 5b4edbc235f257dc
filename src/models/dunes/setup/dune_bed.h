#pragma once

#include <cstdint>

#include "models/shared/fixed_point_lengths.h"

namespace fumon {

/// What dunes are made of, in units of whole_lengths.h. The sum of sand at rest and moving, plus
/// outflow, less inflow and worn rock, never changes.
struct DuneBed {
    FixedPointGrid surface;  ///< height of rock and sand
    FixedPointGrid rock;     ///< height of the hard floor
    FixedPointGrid moving;   ///< sand in the air, as a thickness
    std::int64_t inflow =
        0;  ///< over open edges and of sources since the start, as a thickness of one cell
    std::int64_t outflow = 0;  ///< likewise
    std::int64_t worn = 0;     ///< rock that has become sand since the start, likewise
};

/// The mean height of a surface, metres.
inline double mean_height(const FixedPointGrid& surface) {
    double sum = 0.0;
    for (int y = 0; y < surface.ny(); ++y) {
        double of_row = 0.0;
        for (const std::int64_t height : surface.row(y)) of_row += to_metres(height);
        sum += of_row / surface.nx();
    }
    return sum / surface.ny();
}

}  // namespace fumon
