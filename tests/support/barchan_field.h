#pragma once

#include <algorithm>
#include <cmath>

#include "base/snapshot.h"

namespace fumon::test {

/// Nine barchans 3 to 4 m high on level ground of 256 × 256 m, which repeats, moved downwind
/// (eastward) by `shift` metres: windward sides of at most 12°, slip faces of 33° on a twentieth of
/// the ground.
inline Snapshot barchan_field(int cells, double shift) {
    constexpr double side = 256.0;
    constexpr double repose = 0.65;  // slope of slip faces
    constexpr double length = 36.0;  // from a crest to where its windward side begins
    constexpr double width = 28.0;   // half of it
    Snapshot snapshot;
    snapshot.bed = Grid(cells, cells);
    snapshot.scale = {side / cells, side / cells, 1.0, true};
    snapshot.periodic = true;
    const auto nearest_way = [](double way) { return way - side * std::floor(way / side + 0.5); };
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            double highest = 0.0;
            for (int dune = 0; dune < 9; ++dune) {
                const double height = 3.0 + 0.5 * (dune % 3);
                const double aside = side * (dune % 3 + 0.17 * (dune / 3)) / 3.0;
                const double along = side * (dune / 3 + 0.43 * (dune % 2)) / 3.0;
                const double u = nearest_way(side * x / cells - along - shift);
                const double v = nearest_way(side * y / cells - aside);
                const double across = v * v / (width * width);
                const double windward = height * (1.0 - u * u / (length * length) - across);
                const double foot = height / repose + 0.8 * width * across;  // horns reach ahead
                highest = std::max(highest, std::min(windward, repose * (foot - u)));
            }
            snapshot.bed(x, y) = highest;
        }
    }
    return snapshot;
}

}  // namespace fumon::test
