#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/worker_pool.h"
#include "models/shared/fixed_point_lengths.h"

namespace fumon {

/// The lowest and the highest of each 64 cells of a row of a floor, which tell its height where it
/// is level, and whether it is near, without a look at the floor.
struct FloorRange {
    static constexpr int cells = 64;

    FixedPointGrid lowest;
    FixedPointGrid highest;

    void find(const FixedPointGrid& floor, WorkerPool& pool) {
        if (lowest.empty())
            lowest = highest = FixedPointGrid((floor.nx() + cells - 1) / cells, floor.ny());
        pool.for_ranges(floor.ny(), [&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                const auto row = floor.row(y);
                for (int n = 0; n < lowest.nx(); ++n) {
                    const auto first = static_cast<std::size_t>(n) * cells;
                    const auto size = std::min<std::size_t>(cells, row.size() - first);
                    const auto [low, high] = std::ranges::minmax(row.subspan(first, size));
                    lowest(n, y) = low;
                    highest(n, y) = high;
                }
            }
        });
    }

    [[nodiscard]] bool is_level(int x, int y) const {
        return lowest(x / cells, y) == highest(x / cells, y);
    }
    [[nodiscard]] std::int64_t at(const FixedPointGrid& floor, int x, int y) const {
        return is_level(x, y) ? lowest(x / cells, y) : floor(x, y);
    }
};

/// What lies under loose ground and does not slide, with its range where that is known.
struct AvalancheFloor {
    // NOLINTNEXTLINE(google-explicit-constructor): a grid is a floor
    AvalancheFloor(const FixedPointGrid& cells, const FloorRange* range = nullptr)
        : cells(cells), range(range) {}

    const FixedPointGrid& cells;
    const FloorRange* range;
};

}  // namespace fumon
