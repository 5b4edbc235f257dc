#include "measure/bed/bed_waves.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "measure/bed/row_batch.h"

namespace fumon {

BedWaves bed_waves(const Grid& bed, bool periodic) {
    BedWaves result;
    constexpr int rows = RowBatch::rows;
    RowBatch batch(static_cast<std::size_t>(bed.nx()));
    std::array<RowWaves, RowBatch::rows> waves;
    for (int first = 0; first < bed.ny(); first += rows) {
        const int count = std::min(rows, bed.ny() - first);
        batch.take(bed, first, count);
        batch.detrend(periodic);
        find_waves(batch, periodic, waves);
        for (int k = 0; k < count; ++k) {
            const RowWaves& row = waves[static_cast<std::size_t>(k)];
            if (periodic) {
                result.length += bed.nx();
                result.count += row.crossings;
            } else if (row.crossings > 1) {
                result.length += row.last - row.first;
                result.count += row.crossings - 1;
            }
            for (const double relief : row.reliefs) result.relief += relief;
            result.reliefs += static_cast<std::int64_t>(row.reliefs.size());
        }
    }
    return result;
}

}  // namespace fumon
