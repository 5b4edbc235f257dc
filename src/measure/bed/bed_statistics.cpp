#include "measure/bed/bed_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "base/compensated_sum.h"
#include "measure/bed/row_pass_vectors.h"

namespace fumon {

namespace {

/// Calls take(heights) with the cells of one row after the other that have data.
template <class Take>
void for_each_row(const Grid& bed, const Mask& nodata, const Take& take) {
    std::vector<double> known;
    for (int y = 0; y < bed.ny(); ++y) {
        const auto row = bed.row(y);
        if (nodata.empty()) {
            take(row);
            continue;
        }
        known.resize(row.size());
        const auto unknown = nodata.row(y);
        std::size_t count = 0;
        for (std::size_t x = 0; x < row.size(); ++x) {
            known[count] = row[x];
            count += static_cast<std::size_t>(unknown[x] == 0);
        }
        take(std::span<const double>(known).first(count));
    }
}

double total_of(const row_passes::Sums& sums) {
    CompensatedSum total;
    for (std::size_t k = 0; k < row_passes::lanes; ++k) {
        total.add(sums.sum[k]);
        total.add(sums.lost[k]);
    }
    return total.value();
}

}  // namespace

BedStatistics bed_statistics(const Grid& bed, const Mask& nodata) {
    BedStatistics result;
    row_passes::Sums heights;
    std::size_t cells = 0;
    for_each_row(bed, nodata, [&](std::span<const double> row) {
        row_passes::add(row, heights);
        cells += row.size();
    });
    if (cells == 0) return result;
    result.minimum = *std::ranges::min_element(heights.lowest);
    result.maximum = *std::ranges::max_element(heights.highest);
    result.total = total_of(heights);
    result.mean = result.total / static_cast<double>(cells);
    row_passes::Sums squares;
    for_each_row(bed, nodata, [&](std::span<const double> row) {
        row_passes::add_squares(row, result.mean, squares);
    });
    result.standard_deviation = std::sqrt(total_of(squares) / static_cast<double>(cells));
    return result;
}

}  // namespace fumon
