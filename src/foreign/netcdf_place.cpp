#include "foreign/netcdf_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "files/netcdf/netcdf_axis.h"
#include "files/netcdf/netcdf_cells.h"
#include "files/terrain/ground_lengths.h"
#include "files/terrain/netcdf_bed.h"
#include "files/unit_conversion.h"

namespace fumon {

namespace {

constexpr std::array<std::string_view, 8> eastward_names{"x",  "X",  "globalx", "XZ",
                                                         "xc", "xz", "x_coord", "Xp"};
constexpr std::array<std::string_view, 8> northward_names{"y",  "Y",  "globaly", "YZ",
                                                          "yc", "yz", "y_coord", "Yp"};

bool is_over(const NetcdfInput& input, int variable, const BedVariable& map) {
    const std::vector<int> over = input.dimensions(variable);
    return input.is_numeric(variable) && over.size() == 2 && std::ranges::count(over, map.x) == 1 &&
           std::ranges::count(over, map.y) == 1;
}

/// Coordinates of two dimensions, in metres.
std::optional<Grid> plane_of(const NetcdfInput& input, const BedVariable& map,
                             const std::array<std::string_view, 8>& names,
                             bool (*says)(const NetcdfInput&, int)) {
    std::optional<int> found;
    for (int variable = 0; variable < input.variables(); ++variable) {
        if (!is_over(input, variable, map) || variable == map.variable) continue;
        const std::string name = input.variable_name(variable);
        const bool named = std::ranges::find(names, name) != names.end();
        if (named || (!found && says(input, variable))) found = variable;
    }
    if (!found) return std::nullopt;
    const std::string unit = input.text(*found, "units").value_or("");
    if (is_degrees(unit)) return std::nullopt;
    (void)input.values_over(std::vector<int>{map.y, map.x});
    Grid plane = read_plane(input, *found, map.y, map.x);
    const double metres = metres_per_unit(unit).value_or(1.0);
    for (double& value : plane.values()) value *= metres;
    return plane;
}

struct Vector {
    double x = 0.0;
    double y = 0.0;
};

double length_of(const Vector& vector) {
    return std::hypot(vector.x, vector.y);
}

/// The mean step from one cell to the next along a side, as the coordinates' corners have it.
Vector step_along(const Grid& x, const Grid& y, bool columns) {
    const int count = (columns ? x.nx() : x.ny()) - 1;
    if (count < 1) return {};
    const int i = columns ? count : 0;
    const int j = columns ? 0 : count;
    return {(x(i, j) - x(0, 0)) / count, (y(i, j) - y(0, 0)) / count};
}

void check_straight(const NetcdfInput& input, const BedVariable& map, const Grid& x, const Grid& y,
                    const Vector& a, const Vector& b) {
    const double most = evenness * std::max(length_of(a), length_of(b));
    for (int j = 0; j < x.ny(); ++j) {
        for (int i = 0; i < x.nx(); ++i) {
            const double off = std::hypot(x(i, j) - x(0, 0) - i * a.x - j * b.x,
                                          y(i, j) - y(0, 0) - i * a.y - j * b.y);
            if (off <= most) continue;
            input.refuse(fmt::format("{} lies on a curvilinear or unevenly spaced grid", map.name),
                         "interpolate it to even cells first (cdo remapbil, gdalwarp or xESMF)");
        }
    }
    constexpr double square = 1e-2;
    if (std::abs(a.x * b.x + a.y * b.y) > square * length_of(a) * length_of(b) + 1e-12)
        input.refuse(fmt::format("{} lies on a skewed grid", map.name),
                     "interpolate it to square cells first (cdo remapbil, gdalwarp or xESMF)");
}

/// The shortest number of six digits near a cell's size, if it is as near as single precision is.
double rounded_size(double size) {
    const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(size)));
    const double rounded = std::round(size * scale) / scale;
    return std::abs(rounded / size - 1.0) < 1e-4 ? rounded : size;
}

/// By coordinates of two dimensions in lengths.
NetcdfPlace place_by_planes(const NetcdfInput& input, const BedVariable& map, const Grid& x,
                            const Grid& y) {
    const Vector a = step_along(x, y, true);
    const Vector b = step_along(x, y, false);
    check_straight(input, map, x, y, a, b);
    NetcdfPlace place;
    place.swapped = std::abs(a.x) < std::abs(a.y) && x.nx() > 1;
    const Vector& east = place.swapped ? b : a;
    const Vector& north = place.swapped ? a : b;
    const double dx = length_of(east);
    const double dy = length_of(north);
    if (dx == 0.0 && dy == 0.0)
        input.refuse(fmt::format("the coordinates of {} are one point", map.name),
                     "write the coordinates of its cells");
    place.scale.dx = rounded_size(dx > 0.0 ? dx : dy);
    place.scale.dy = rounded_size(dy > 0.0 ? dy : dx);
    place.scale.in_metres = true;
    place.columns_fall = east.x < 0.0;
    place.rows_fall =
        dy > 0.0 &&
        (dx > 0.0 ? (east.x * north.y - east.y * north.x) * (place.columns_fall ? -1.0 : 1.0) < 0.0
                  : north.y < 0.0);
    constexpr double level = 1e-3;
    if (std::abs(east.y) > level * dx || std::abs(north.x) > level * dy) {
        constexpr double degrees_per_radian = 57.29577951308232;
        const double turn = std::atan2(place.columns_fall ? -east.y : east.y,
                                       place.columns_fall ? -east.x : east.x);
        place.note = fmt::format(
            "its grid is turned by {:.3g} degrees against the east: it is drawn along its own "
            "sides",
            turn * degrees_per_radian);
        return place;
    }
    double west = x(0, 0);
    double south = y(0, 0);
    for (const double value : x.values()) west = std::min(west, value);
    for (const double value : y.values()) south = std::min(south, value);
    place.scale.place = GeoReference{west - 0.5 * place.scale.dx, south - 0.5 * place.scale.dy,
                                     place.scale.dx, place.scale.dy};
    return place;
}

}  // namespace

bool is_place_variable(const std::string& name) {
    return std::ranges::find(eastward_names, name) != eastward_names.end() ||
           std::ranges::find(northward_names, name) != northward_names.end();
}

NetcdfPlace place_of_maps(const NetcdfInput& input, const BedVariable& map) {
    const auto x = plane_of(input, map, eastward_names, is_eastward_variable);
    const auto y = plane_of(input, map, northward_names, is_northward_variable);
    if (x && y) return place_by_planes(input, map, *x, *y);
    NetcdfPlace place;
    const auto [across, along] = netcdf_axes(input, map);
    place.columns_fall = across.descending;
    place.rows_fall = along.descending;
    TerrainQuery query;
    query.variable = map.name;
    query.record = map.has_records ? static_cast<std::int64_t>(map.record) + 1 : 0;
    query.any_unit = true;
    Terrain terrain = read_netcdf_bed(input, query);
    make_true_lengths(terrain, false, input.name());
    if (terrain.dx > 0.0) {
        place.scale.dx = terrain.dx;
        place.scale.dy = terrain.dy;
        place.scale.in_metres = true;
    }
    place.scale.place = terrain.place;
    place.note = terrain.note;
    return place;
}

Grid read_map(const NetcdfInput& input, BedVariable map, const NetcdfPlace& place) {
    if (place.swapped) std::swap(map.x, map.y);
    Grid values = read_cells(input, map);
    const MissingValues missing = missing_values(input, map.variable);
    const auto scales = input.numbers(map.variable, "scale_factor");
    const auto offsets = input.numbers(map.variable, "add_offset");
    const double scale = scales.empty() ? 1.0 : scales.front();
    const double offset = offsets.empty() ? 0.0 : offsets.front();
    for (double& value : values.values())
        value = missing.holds(value) ? std::numeric_limits<double>::quiet_NaN()
                                     : value * scale + offset;
    for (int y = 0; place.rows_fall && y < values.ny() / 2; ++y)
        std::ranges::swap_ranges(values.row(y), values.row(values.ny() - 1 - y));
    for (int y = 0; place.columns_fall && y < values.ny(); ++y) std::ranges::reverse(values.row(y));
    return values;
}

}  // namespace fumon
