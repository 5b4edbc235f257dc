#include "measure/water/channel_bed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "measure/water/downslope_mean.h"

namespace fumon {

namespace {

constexpr int fewest_columns = 8;
constexpr double beyond_noise = 3.0;  // a rim among the far columns, over their lowest's depth
constexpr double rounding_of_height = 1e-9;  // of the largest height

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace

ChannelBed channel_bed(const Grid& bed, const Mask& nodata, double dx, bool periodic) {
    const std::vector<double> line = downslope_mean(bed, nodata);
    const int nx = bed.nx();
    if (nx < fewest_columns || std::ranges::any_of(line, [](double z) { return std::isnan(z); }))
        return {};
    const auto [lowest, highest] = std::ranges::minmax(line);
    if (!(highest - lowest > rounding_of_height * std::max(std::abs(lowest), std::abs(highest))))
        return {};
    const int channel = static_cast<int>(std::ranges::min_element(line) - line.begin());
    std::vector<double> far;
    double rim = lowest;
    for (int x = 0; x < nx; ++x) {
        const int straight = std::abs(x - channel);
        const int distance = periodic ? std::min(straight, nx - straight) : straight;
        const double height = line[static_cast<std::size_t>(x)];
        if (5 * distance > 2 * nx) {
            far.push_back(height);
        } else {
            rim = std::max(rim, height);
        }
    }
    const auto [far_lowest, far_highest] = std::ranges::minmax(far);
    const double far_bed = median(std::move(far));
    if (far_highest - far_bed > beyond_noise * (far_bed - far_lowest))
        rim = std::max(rim, far_highest);
    return {(channel + 0.5) * dx, far_bed, lowest - far_bed, std::max(0.0, rim - far_bed)};
}

}  // namespace fumon
