#include "measure/water/water_relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "measure/bed/bed_statistics.h"
#include "measure/water/downslope_mean.h"

namespace fumon {

namespace {

constexpr double rounding_of_mean = 1e-9;  // of the mean

bool has_data(const Mask& nodata, std::size_t cell) {
    return nodata.empty() || nodata.values()[cell] == 0;
}

}  // namespace

Unevenness unevenness(const Grid& field, const Mask& nodata) {
    bool any = false;
    for (std::size_t cell = 0; cell < field.size() && !any; ++cell) any = has_data(nodata, cell);
    if (!any) return {};
    const BedStatistics all = bed_statistics(field, nodata);
    return {all.mean, all.standard_deviation, all.maximum - all.minimum};
}

Unevenness downslope_unevenness(const Grid& field, const Mask& nodata) {
    const std::vector<double> line = downslope_mean(field, nodata);
    if (line.empty() || std::ranges::any_of(line, [](double v) { return std::isnan(v); }))
        return {};
    Grid row(field.nx(), 1);
    std::ranges::copy(line, row.values().begin());
    return unevenness(row, {});
}

double downslope_invariant_share(const Grid& field, const Mask& nodata) {
    const Unevenness all = unevenness(field, nodata);
    if (!(all.deviation > rounding_of_mean * std::abs(all.mean)))
        return std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> line = downslope_mean(field, nodata);
    double explained = 0.0;
    double total = 0.0;
    const std::size_t nx = line.size();
    for (std::size_t cell = 0; cell < field.size(); ++cell) {
        if (!has_data(nodata, cell)) continue;
        const double of_column = line[cell % nx] - all.mean;
        const double of_cell = field.values()[cell] - all.mean;
        explained += of_column * of_column;
        total += of_cell * of_cell;
    }
    return explained / total;
}

}  // namespace fumon
