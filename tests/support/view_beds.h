#pragma once

#include <cmath>

#include "base/snapshot.h"

namespace fumon {

/// A smooth bed of ripples and a long wave, nx × ny.
inline Snapshot wavy_bed(int nx, int ny) {
    Snapshot snapshot;
    snapshot.bed = Grid(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            snapshot.bed(x, y) = 2.0 + 1.3 * std::sin(0.55 * x + 0.8 * std::sin(0.13 * y)) +
                                 0.02 * nx * std::sin(0.07 * x + 0.05 * y);
        }
    }
    return snapshot;
}

/// The same with everything outside an ellipse left out.
inline Snapshot masked_bed(int nx, int ny) {
    Snapshot snapshot = wavy_bed(nx, ny);
    snapshot.nodata = Mask(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double u = 2.2 * (x + 0.5) / nx - 1.1;
            const double v = 2.6 * (y + 0.5) / ny - 1.3;
            if (u * u + v * v > 1.0) {
                snapshot.nodata(x, y) = 1;
                snapshot.bed(x, y) = -9999.0;
            }
        }
    }
    return snapshot;
}

}  // namespace fumon
