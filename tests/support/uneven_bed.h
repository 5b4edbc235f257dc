#pragma once

#include <cstdint>

#include "base/grid.h"
#include "base/random.h"

namespace fumon::test {

/// Heights drawn evenly from 0 … `high`, cell by cell, the same at every call.
inline Grid uneven_bed(int nx, int ny, double high) {
    Grid bed(nx, ny);
    for (int y = 0; y < ny; ++y) {
        RandomStream stream(3, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& height : bed.row(y)) height = high * stream.uniform();
    }
    return bed;
}

}  // namespace fumon::test
