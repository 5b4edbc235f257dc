#pragma once

#include <algorithm>
#include <cmath>

#include "base/snapshot.h"
#include "support/water_beds.h"

namespace fumon::test {

/// A gully that winds through 128 × 256 m of ground, whose walls fail at `shift` of a meander.
inline Snapshot dry_gully(double shift) {
    Snapshot snapshot;
    snapshot.bed = Grid(128, 256);
    snapshot.scale = {1.0, 1.0, 1.0, true};
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 128; ++x) {
            const double middle = 64.0 + 14.0 * std::sin(0.045 * y + shift) + 0.05 * y;
            const double off = std::abs(x - middle);
            const double width = 5.0 + 9.0 * std::exp(-0.012 * y);
            const double wall = 1.0 / (1.0 + std::exp((width - off) / 1.6));
            const double spurs = std::sin(0.31 * y + 0.09 * x) * std::exp(-0.03 * off);
            const double rough = 0.12 * std::sin(0.9 * x + 0.4 * y) * std::sin(0.7 * y - 0.2 * x);
            snapshot.bed(x, y) =
                0.035 * y + wall * (6.0 + 0.9 * spurs) + 0.06 * std::max(off - width, 0.0) + rough;
        }
    }
    return snapshot;
}

/// The same in rain: a film of some millimetres on its slopes, thicker and thinner, and a stream
/// (m/s) at its bottom.
inline Snapshot rained_gully(double shift, double speed = 1.5) {
    Snapshot snapshot = dry_gully(shift);
    const Grid bed = snapshot.bed;
    snapshot = under_water(std::move(snapshot), 0.0, 0.0);
    for (int y = 0; y < bed.ny(); ++y) {
        const double level = 0.035 * y + 0.35;
        for (int x = 0; x < bed.nx(); ++x) {
            const double film = 0.0022 * (1.0 + std::sin(0.5 * x + 0.2 * y));
            const double depth = std::max(level - bed(x, y), film);
            snapshot.fields[0].values(x, y) = depth;
            snapshot.fields[1].values(x, y) = 0.1;
            snapshot.fields[2].values(x, y) = depth > film ? -speed : -0.1;
        }
    }
    return snapshot;
}

}  // namespace fumon::test
