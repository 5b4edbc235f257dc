#include "files/terrain/geographic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "base/elementary.h"

namespace fumon {

bool is_geographic(const GridExtent& extent) {
    constexpr double widest_cell = 5.0;  // degrees; coarser global grids are not terrain
    constexpr double steepest_in_metres =
        2.0;  // relief / longer side; no heightfield in use reaches it
    const double east = extent.west + extent.width;
    const double north = extent.south + extent.height;
    const bool on_globe = extent.west >= -180.0 - extent.dx && east <= 360.0 + extent.dx &&
                          extent.width <= 360.0 + extent.dx && extent.south >= -90.0 - extent.dy &&
                          north <= 90.0 + extent.dy;
    const bool local_origin = extent.west == 0.0 && extent.south == 0.0;
    const bool small_cells = extent.dx <= widest_cell && extent.dy <= widest_cell;
    const bool needle = extent.relief > steepest_in_metres * std::max(extent.width, extent.height);
    return on_globe && !local_origin && small_cells && needle;
}

DegreeLengths degree_lengths(double latitude) {
    constexpr double semi_major_axis = 6378137.0;       // metres, WGS84
    constexpr double flattening = 1.0 / 298.257223563;  // WGS84
    constexpr double eccentricity_squared = flattening * (2.0 - flattening);
    constexpr double radians_per_degree = std::numbers::pi / 180.0;
    const double sine = elementary::sin(latitude * radians_per_degree);
    const double cosine = elementary::cos(latitude * radians_per_degree);
    const double w_squared = 1.0 - eccentricity_squared * sine * sine;
    const double prime_vertical = semi_major_axis / std::sqrt(w_squared);
    const double meridian = prime_vertical * (1.0 - eccentricity_squared) / w_squared;
    return {prime_vertical * cosine * radians_per_degree, meridian * radians_per_degree};
}

MetricCells cells_from_degrees(double dx, double dy, double middle_latitude) {
    const DegreeLengths lengths = degree_lengths(middle_latitude);
    MetricCells cells{dx * lengths.east, dy * lengths.north, ""};
    const std::string degrees =
        dx == dy ? fmt::format("{:.6g}°", dx) : fmt::format("{:.6g}° × {:.6g}°", dx, dy);
    cells.note = fmt::format(
        "cell size {} read as degrees and converted to metres at the middle latitude {:.4f}°: "
        "dx = {:.2f} m, dy = {:.2f} m",
        degrees, middle_latitude, cells.dx, cells.dy);
    return cells;
}

double relief(const Grid& heights, const Mask& nodata) {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (!nodata.empty() && nodata.values()[i] != 0) continue;
        lowest = std::min(lowest, heights.values()[i]);
        highest = std::max(highest, heights.values()[i]);
    }
    return highest >= lowest ? highest - lowest : -1.0;
}

}  // namespace fumon
