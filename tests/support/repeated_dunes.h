#pragma once

#include <cmath>
#include <numbers>

#include "base/snapshot.h"

namespace fumon {

/// Dunes of a periodic bed, shifted by whole cells.
inline Snapshot repeated_dunes(int nx, int ny, int east = 0, int north = 0) {
    Snapshot snapshot;
    snapshot.periodic = true;
    snapshot.bed = Grid(nx, ny);
    const double turn = 2.0 * std::numbers::pi;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double u = turn * ((x - east + nx) % nx) / nx;
            const double v = turn * ((y - north + ny) % ny) / ny;
            snapshot.bed(x, y) =
                3.0 * std::sin(5.0 * u + std::sin(2.0 * v)) + std::sin(3.0 * v - u);
        }
    }
    return snapshot;
}

}  // namespace fumon
