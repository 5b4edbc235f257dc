#include "foreign/netcdf_place.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/elementary_angle.h"
#include "base/elementary_power.h"
#include "base/limits.h"
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
    const MissingValues missing = missing_values(input, *found);
    if (!std::ranges::all_of(plane.values(), [&](double value) {
            return std::isfinite(value) && !missing.holds(value);
        }))
        input.refuse(fmt::format("{} has no value in some cells", input.variable_name(*found)),
                     "write the coordinates of all cells");
    const double metres = metres_per_unit(unit).value_or(1.0);
    for (double& value : plane.values()) value *= metres;
    return plane;
}

struct Vector {
    double x = 0.0;
    double y = 0.0;
};

double length_of(const Vector& vector) {
    return elementary::hypot(vector.x, vector.y);
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
            const double off = elementary::hypot(x(i, j) - x(0, 0) - i * a.x - j * b.x,
                                                 y(i, j) - y(0, 0) - i * a.y - j * b.y);
            if (off <= most) continue;
            input.refuse(fmt::format("{} lies on a curvilinear grid", map.name),
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
    const double scale = elementary::pow(10.0, 5.0 - std::floor(elementary::log10(size)));
    const double rounded = std::round(size * scale) / scale;
    return std::abs(rounded / size - 1.0) < 1e-4 ? rounded : size;
}

/// The columns' x or the rows' y, where all rows or columns have the same; else nothing.
std::optional<std::vector<double>> positions_along(const Grid& plane, bool columns) {
    const int count = columns ? plane.nx() : plane.ny();
    const int others = columns ? plane.ny() : plane.nx();
    std::vector<double> positions;
    double smallest = std::numeric_limits<double>::max();
    for (int k = 0; k < count; ++k) {
        positions.push_back(columns ? plane(k, 0) : plane(0, k));
        if (k > 0)
            smallest = std::min(smallest, std::abs(positions[static_cast<std::size_t>(k)] -
                                                   positions[static_cast<std::size_t>(k - 1)]));
    }
    const bool falls = positions.back() < positions.front();
    for (int k = 0; k < count; ++k) {
        if (k > 0 && (positions[static_cast<std::size_t>(k)] <
                      positions[static_cast<std::size_t>(k - 1)]) != falls)
            return std::nullopt;
        for (int other = 0; other < others; ++other) {
            const double value = columns ? plane(k, other) : plane(other, k);
            if (std::abs(value - positions[static_cast<std::size_t>(k)]) > evenness * smallest)
                return std::nullopt;
        }
    }
    if (count > 1 && !(smallest > 0.0)) return std::nullopt;
    return positions;
}

/// Cells of one size over uneven positions: as small as the smallest spacing, and at most eight
/// times as many as there are positions.
struct EvenAxis {
    std::vector<double> places;  ///< of the positions, in cells, rising
    double size = 0.0;
    double lowest = 0.0;  ///< the first cell's centre
    int count = 1;
};

EvenAxis even_axis(std::vector<double> positions) {
    std::ranges::sort(positions);
    EvenAxis axis;
    axis.lowest = positions.front();
    const double span = positions.back() - positions.front();
    if (span == 0.0) {
        axis.places = {0.0};
        return axis;
    }
    double smallest = span;
    for (std::size_t k = 1; k < positions.size(); ++k)
        smallest = std::min(smallest, positions[k] - positions[k - 1]);
    constexpr double most_per_position = 8.0;
    const double most = most_per_position * static_cast<double>(positions.size());
    axis.count = static_cast<int>(std::min(std::round(span / smallest), most)) + 1;
    axis.size = span / (axis.count - 1);
    for (const double position : positions)
        axis.places.push_back((position - axis.lowest) / axis.size);
    return axis;
}

bool is_even(const std::vector<double>& positions) {
    const double step =
        (positions.back() - positions.front()) / static_cast<double>(positions.size() - 1);
    for (std::size_t k = 0; k < positions.size(); ++k) {
        const double expected = positions.front() + step * static_cast<double>(k);
        if (std::abs(positions[k] - expected) > evenness * std::abs(step)) return false;
    }
    return true;
}

/// Of columns and rows along x and y that are not evenly spaced; else nothing.
std::optional<NetcdfPlace> uneven_place(const NetcdfInput& input, const Grid& x, const Grid& y) {
    constexpr double farthest = 1e9;  // metres; beyond are fill values, which other checks name
    const auto is_place = [](double value) { return std::abs(value) <= farthest; };
    if (!std::ranges::all_of(x.values(), is_place) || !std::ranges::all_of(y.values(), is_place))
        return std::nullopt;
    const auto columns = positions_along(x, true);
    const auto rows = positions_along(y, false);
    if (!columns || !rows || (is_even(*columns) && is_even(*rows))) return std::nullopt;
    const EvenAxis across = even_axis(*columns);
    const EvenAxis along = even_axis(*rows);
    NetcdfPlace place;
    place.columns_fall = columns->back() < columns->front();
    place.rows_fall = rows->back() < rows->front();
    place.columns = across.places;
    place.rows = along.places;
    place.nx = across.count;
    place.ny = along.count;
    if (std::int64_t{place.nx} * place.ny > largest_grid_cells)
        input.refuse(fmt::format("its {} x {} unevenly spaced points need {} x {} even cells, more "
                                 "than {}",
                                 x.nx(), x.ny(), place.nx, place.ny, largest_grid_cells),
                     "interpolate it to fewer cells first");
    const double dx = across.size > 0.0 ? across.size : along.size;
    const double dy = along.size > 0.0 ? along.size : across.size;
    place.scale = {dx, dy, 1.0, true};
    place.scale.place = GeoReference{across.lowest - 0.5 * dx, along.lowest - 0.5 * dy, dx, dy};
    place.note = fmt::format(
        "its {} x {} points are unevenly spaced: they are laid on {} x {} "
        "cells, linearly between them",
        x.nx(), x.ny(), place.nx, place.ny);
    return place;
}

/// A value between two, or the one that there is.
double between(double low, double high, double share) {
    if (std::isnan(low)) return share > 0.5 ? high : low;
    if (std::isnan(high)) return share < 0.5 ? low : high;
    return (1.0 - share) * low + share * high;
}

/// The number of the position at or before a cell, of at least two, and the cell's share of the way
/// to the next.
std::pair<int, double> share_of(const std::vector<double>& places, int cell) {
    const auto after = std::ranges::upper_bound(places, cell + 1e-9);
    const auto last = static_cast<std::ptrdiff_t>(places.size()) - 2;
    const std::ptrdiff_t k = std::clamp<std::ptrdiff_t>(after - places.begin() - 1, 0, last);
    const auto at = static_cast<std::size_t>(k);
    return {static_cast<int>(k),
            std::clamp((cell - places[at]) / (places[at + 1] - places[at]), 0.0, 1.0)};
}

/// Values at uneven columns and rows on even cells.
Grid on_even_cells(const Grid& values, const NetcdfPlace& place) {
    Grid across(place.nx, values.ny());
    for (int i = 0; i < place.nx; ++i) {
        if (place.columns.size() < 2) {
            for (int j = 0; j < values.ny(); ++j) across(i, j) = values(0, j);
            continue;
        }
        const auto [k, share] = share_of(place.columns, i);
        for (int j = 0; j < values.ny(); ++j)
            across(i, j) = between(values(k, j), values(k + 1, j), share);
    }
    if (place.rows.size() < 2) return across;
    Grid even(place.nx, place.ny);
    for (int j = 0; j < place.ny; ++j) {
        const auto [k, share] = share_of(place.rows, j);
        for (int i = 0; i < place.nx; ++i)
            even(i, j) = between(across(i, k), across(i, k + 1), share);
    }
    return even;
}

/// Coordinates of one dimension in a length, as planes; nothing where there are none.
std::optional<Grid> plane_of_axis(const NetcdfInput& input, const BedVariable& map, bool columns) {
    const int dimension = columns ? map.x : map.y;
    const auto variable = input.find_variable(input.dimension_name(dimension));
    if (!variable || !input.is_numeric(*variable) ||
        input.dimensions(*variable) != std::vector<int>{dimension})
        return std::nullopt;
    const auto metres = metres_per_unit(input.text(*variable, "units").value_or(""));
    if (!metres) return std::nullopt;
    std::vector<double> values(input.dimension_length(dimension));
    check_netcdf(nc_get_var_double(input.id(), *variable, values.data()));
    (void)input.values_over(std::vector<int>{map.y, map.x});
    Grid plane(static_cast<int>(input.dimension_length(map.x)),
               static_cast<int>(input.dimension_length(map.y)));
    for (int j = 0; j < plane.ny(); ++j) {
        for (int i = 0; i < plane.nx(); ++i)
            plane(i, j) = *metres * values[static_cast<std::size_t>(columns ? i : j)];
    }
    return plane;
}

/// By coordinates of two dimensions in lengths.
NetcdfPlace place_by_planes(const NetcdfInput& input, const BedVariable& map, const Grid& x,
                            const Grid& y) {
    if (auto uneven = uneven_place(input, x, y)) return *std::move(uneven);
    const Vector a = step_along(x, y, true);
    const Vector b = step_along(x, y, false);
    check_straight(input, map, x, y, a, b);
    NetcdfPlace place;
    place.swapped = std::abs(a.x) < std::abs(a.y) && x.nx() > 1;
    place.nx = place.swapped ? x.ny() : x.nx();
    place.ny = place.swapped ? x.nx() : x.ny();
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
        place.turn = elementary::atan2(place.columns_fall ? -east.y : east.y,
                                       place.columns_fall ? -east.x : east.x);
        place.note = fmt::format(
            "its grid is turned by {:.3g} degrees against the east: it is drawn along its own "
            "sides",
            place.turn * degrees_per_radian);
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
    const auto columns = plane_of_axis(input, map, true);
    const auto rows = columns ? plane_of_axis(input, map, false) : std::nullopt;
    if (rows) {
        if (auto uneven = uneven_place(input, *columns, *rows)) return *std::move(uneven);
    }
    NetcdfPlace place;
    place.nx = static_cast<int>(input.dimension_length(map.x));
    place.ny = static_cast<int>(input.dimension_length(map.y));
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

Grid read_map(const NetcdfInput& input, BedVariable map, const NetcdfPlace& place,
              const ValuesReader& reader) {
    if (place.swapped) std::swap(map.x, map.y);
    Grid values = read_cells(input, map, reader);
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
    if (place.columns.empty()) return values;
    if (std::cmp_not_equal(values.nx(), place.columns.size()) ||
        std::cmp_not_equal(values.ny(), place.rows.size()))
        input.refuse(fmt::format("{} has {} x {} points, those of the first file {} x {}", map.name,
                                 values.nx(), values.ny(), place.columns.size(), place.rows.size()),
                     "all files of a run need the same grid");
    return on_even_cells(values, place);
}

}  // namespace fumon
