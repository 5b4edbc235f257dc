#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "base/grid.h"
#include "base/random.h"

namespace fumon::test {

inline constexpr double turn = 6.283185307179586;

/// A bed from a height at every cell.
inline Grid bed_of(int nx, int ny, const std::function<double(int, int)>& height) {
    Grid bed(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) bed(x, y) = height(x, y);
    }
    return bed;
}

/// Uniform in [0, 1).
inline Grid noise(int nx, int ny, std::uint64_t seed) {
    Grid bed(nx, ny);
    for (int y = 0; y < ny; ++y) {
        RandomStream stream(seed, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& height : bed.row(y)) height = stream.uniform();
    }
    return bed;
}

/// 5 + sin of `along_x` waves over the bed and, row by row, `along_y` waves.
inline Grid waves(int nx, int ny, double along_x, double along_y = 0.0, double phase = 0.0) {
    return bed_of(nx, ny, [=](int x, int y) {
        return 5.0 + std::sin(turn * (along_x * x / nx + along_y * y / ny) + phase);
    });
}

inline Grid sum(const Grid& a, const Grid& b, double factor = 1.0) {
    return bed_of(a.nx(), a.ny(), [&](int x, int y) { return a(x, y) + factor * b(x, y); });
}

/// Moved `sites` toward +x, round the edge.
inline Grid moved(const Grid& bed, int sites) {
    return bed_of(bed.nx(), bed.ny(), [&](int x, int y) {
        return bed(((x - sites) % bed.nx() + bed.nx()) % bed.nx(), y);
    });
}

}  // namespace fumon::test
