#include "measure/network/polyline_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/truncation.h"

namespace fumon {

std::vector<PolylinePoint> sample_polyline(const std::vector<std::array<double, 2>>& corners,
                                           double dx, double dy) {
    constexpr std::size_t most_places = std::size_t{1} << 24;  // of one line
    const double apart = 0.5 * std::min(dx, dy);
    std::vector<PolylinePoint> places{{0.0, corners.front()[0], corners.front()[1]}};
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const double across = corners[k][0] - corners[k - 1][0];
        const double up = corners[k][1] - corners[k - 1][1];
        const double length = std::sqrt(across * across * dx * dx + up * up * dy * dy);
        const double begin = places.back().distance;
        const auto pieces =
            truncated_within(std::ceil(length / apart), std::size_t{0}, most_places);
        for (std::size_t n = 1; n <= pieces; ++n) {
            const double share = static_cast<double>(n) / static_cast<double>(pieces);
            places.push_back({begin + share * length, corners[k - 1][0] + share * across,
                              corners[k - 1][1] + share * up});
        }
    }
    return places;
}

double value_between(const Grid& values, const Mask& nodata, double x, double y) {
    const auto has_data = [&](int column, int row) {
        return nodata.empty() || nodata(column, row) == 0;
    };
    const auto cell = [](double place, int count) {
        return truncated_within(std::floor(place), 0, count - 1);
    };
    const int nx = values.nx();
    const int ny = values.ny();
    const double left = std::clamp(x - 0.5, 0.0, nx - 1.0);
    const double below = std::clamp(y - 0.5, 0.0, ny - 1.0);
    const int west = cell(left, nx);
    const int south = cell(below, ny);
    const int east = std::min(west + 1, nx - 1);
    const int north = std::min(south + 1, ny - 1);
    const bool whole = has_data(west, south) && has_data(east, south) && has_data(west, north) &&
                       has_data(east, north);
    if (!whole) {
        const int column = cell(x, nx);
        const int row = cell(y, ny);
        return has_data(column, row) ? values(column, row)
                                     : std::numeric_limits<double>::quiet_NaN();
    }
    const double u = left - west;
    const double v = below - south;
    return (1.0 - v) * ((1.0 - u) * values(west, south) + u * values(east, south)) +
           v * ((1.0 - u) * values(west, north) + u * values(east, north));
}

}  // namespace fumon
