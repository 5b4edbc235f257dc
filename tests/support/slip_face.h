#pragma once

#include <algorithm>

#include "base/snapshot.h"

namespace fumon {

/// A ridge across the wind, 6 m high: a long stoss side, a brink at x = 60 m and a slip face east
/// of it. Cells are metres. The wind drives `flux` of what it does over level ground, everywhere.
inline Snapshot slip_face(double flux) {
    Snapshot bed;
    bed.bed = Grid(128, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 128; ++x) {
            const double stoss = 0.12 * (x - 10.0);
            const double slip = 6.0 - 0.65 * (x - 60.0);
            bed.bed(x, y) = std::max(0.0, x <= 60 ? stoss : slip);
        }
    }
    bed.scale = {1.0, 1.0, 1.0, true, {}};
    bed.periodic = true;
    bed.time_unit = "yr";
    bed.saltation_flux = [flux](const Snapshot& of) {
        return Grid(of.bed.nx(), of.bed.ny(), flux);
    };
    return bed;
}

}  // namespace fumon
