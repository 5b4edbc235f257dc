#pragma once

#include <cmath>

#include "base/snapshot.h"

namespace fumon::test {

/// Transverse dunes that carry ripples, moved downwind by `shift` of a wavelength.
inline Snapshot dune_field(int cells, double shift) {
    Snapshot snapshot;
    snapshot.bed = Grid(cells, cells);
    const double wavelength = cells / 7.0;
    const double ripple = cells / 85.0;
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            const double u = static_cast<double>(x) / cells;
            const double v = static_cast<double>(y) / cells;
            const double bend =
                0.5 * std::sin(5.0 * v + 2.0 * u) + 0.2 * std::sin(13.0 * v - 3.0 * u);
            const double phase = x / wavelength + bend - shift;
            const double share = phase - std::floor(phase);
            const double dune = share < 0.72
                                    ? std::pow(std::sin(1.5708 * share / 0.72), 1.5)
                                    : 0.5 + 0.5 * std::cos(3.14159 * (share - 0.72) / 0.28);
            const double small =
                std::sin(6.28319 * (x / ripple + 0.8 * std::sin(9.0 * v + 4.0 * u)));
            snapshot.bed(x, y) =
                cells * (0.025 * dune * (1.0 + 0.4 * std::sin(7.0 * v)) + 0.0006 * small);
        }
    }
    return snapshot;
}

}  // namespace fumon::test
