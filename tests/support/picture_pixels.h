#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "base/image.h"
#include "base/snapshot.h"

namespace fumon::test {

using Pixel = std::array<int, 3>;

/// The colour of a picture at a place in pixels from its upper left corner.
inline Pixel pixel_at(const Image& image, double x, double y) {
    const std::uint8_t* pixel = image.row(static_cast<int>(y)) + 3 * static_cast<int>(x);
    return {pixel[0], pixel[1], pixel[2]};
}

/// A snapshot of so many steps, each of which is a unit of time.
inline Snapshot at_step(Snapshot snapshot, int step) {
    snapshot.step = step;
    snapshot.time = step;
    snapshot.time_unit = std::string("steps");
    return snapshot;
}

}  // namespace fumon::test
