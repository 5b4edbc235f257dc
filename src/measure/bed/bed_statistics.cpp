#include "measure/bed/bed_statistics.h"

#include <algorithm>
#include <cmath>

#include "base/compensated_sum.h"

namespace fumon {

namespace {

template <class Body>
void for_each_height(const Grid& bed, const Mask& nodata, Body body) {
    const auto heights = bed.values();
    for (std::size_t cell = 0; cell < heights.size(); ++cell) {
        if (nodata.empty() || nodata.values()[cell] == 0) body(heights[cell]);
    }
}

}  // namespace

BedStatistics bed_statistics(const Grid& bed, const Mask& nodata) {
    BedStatistics result;
    CompensatedSum total;
    std::size_t cells = 0;
    for_each_height(bed, nodata, [&](double height) {
        if (cells++ == 0) result.minimum = result.maximum = height;
        result.minimum = std::min(result.minimum, height);
        result.maximum = std::max(result.maximum, height);
        total.add(height);
    });
    if (cells == 0) return result;
    result.total = total.value();
    result.mean = result.total / static_cast<double>(cells);
    CompensatedSum squares;
    for_each_height(bed, nodata, [&](double height) {
        squares.add((height - result.mean) * (height - result.mean));
    });
    result.standard_deviation = std::sqrt(squares.value() / static_cast<double>(cells));
    return result;
}

}  // namespace fumon
