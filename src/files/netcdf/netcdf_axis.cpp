#include "files/netcdf/netcdf_axis.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "files/unit_conversion.h"

namespace fumon {

namespace {

bool is_over(const NetcdfInput& input, int variable, int dimension) {
    return input.is_numeric(variable) && input.dimensions(variable) == std::vector<int>{dimension};
}

/// The one-dimensional numeric variable that bears a dimension's name; else one over it that calls
/// itself a coordinate.
std::optional<int> coordinate_variable(const NetcdfInput& input, int dimension) {
    const auto named = input.find_variable(input.dimension_name(dimension));
    if (named && is_over(input, *named, dimension)) return named;
    for (int variable = 0; variable < input.variables(); ++variable) {
        if (!is_over(input, variable, dimension)) continue;
        if (input.text(variable, "axis") || is_eastward_variable(input, variable) ||
            is_northward_variable(input, variable))
            return variable;
    }
    return std::nullopt;
}

std::string coordinate_text(const NetcdfInput& input, int dimension, const char* attribute) {
    const auto variable = coordinate_variable(input, dimension);
    if (!variable) return "";
    return input.text(*variable, attribute).value_or("");
}

template <std::size_t count>
bool is_among(const std::array<std::string_view, count>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// The shortest number of 12 digits near a value.
double rounded(double value) {
    const std::string text = fmt::format("{:.12g}", value);
    double result = value;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

struct Unit {
    AxisUnit kind = AxisUnit::unsaid;
    double metres = 1.0;  ///< per unit
};

Unit unit_of(const NetcdfInput& input, int variable, const std::string& name) {
    const std::string unit = input.text(variable, "units").value_or("");
    if (unit.empty() || unit == "-" || unit == "?") return {};  // as Landlab writes none
    if (unit == "1") return {AxisUnit::sites};
    if (is_degrees(unit)) return {AxisUnit::degrees};
    if (const auto metres = metres_per_unit(unit)) return {AxisUnit::metres, *metres};
    input.refuse(fmt::format("the unit of {} is \"{}\"", name, unit),
                 "coordinates are in a unit of length (\"m\") or in degrees");
}

void check_even(const NetcdfInput& input, const NetcdfAxis& axis,
                const std::vector<double>& coordinates) {
    const double first = coordinates.front();
    const double way = coordinates.back() - first;
    const auto intervals = static_cast<double>(coordinates.size() - 1);
    const double tolerance = evenness * std::abs(way) / intervals;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const double expected = first + way * (static_cast<double>(i) / intervals);
        if (std::abs(coordinates[i] - expected) <= tolerance) continue;
        input.refuse(fmt::format("{} is not evenly spaced: {}[{}] is {:.9g} where even spacing "
                                 "has {:.9g}",
                                 axis.name, axis.name, i, coordinates[i], expected),
                     "interpolate the heights to even spacing first");
    }
}

}  // namespace

NetcdfAxis read_netcdf_axis(const NetcdfInput& input, int dimension) {
    const auto variable = coordinate_variable(input, dimension);
    if (!variable || input.dimension_length(dimension) == 0) {
        NetcdfAxis axis;
        axis.name = input.dimension_name(dimension);
        axis.count = input.dimension_length(dimension);
        return axis;
    }
    std::vector<double> coordinates(input.dimension_length(dimension));
    check_netcdf(nc_get_var_double(input.id(), *variable, coordinates.data()));
    return netcdf_axis(input, *variable, std::move(coordinates));
}

NetcdfAxis netcdf_axis(const NetcdfInput& input, int variable, std::vector<double> coordinates) {
    NetcdfAxis axis;
    axis.name = input.variable_name(variable);
    axis.count = coordinates.size();
    axis.has_coordinates = true;
    const Unit unit = unit_of(input, variable, axis.name);
    axis.unit = unit.kind;
    axis.metres = unit.metres;
    const auto scale = input.numbers(variable, "scale_factor");
    const auto offset = input.numbers(variable, "add_offset");
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        double& value = coordinates[i];
        if (!scale.empty()) value *= scale.front();
        if (!offset.empty()) value += offset.front();
        if (!std::isfinite(value))
            input.refuse(fmt::format("{}[{}] is not a finite number", axis.name, i),
                         "all coordinates must be finite");
    }
    axis.lowest = std::min(coordinates.front(), coordinates.back()) * unit.metres;
    if (axis.count == 1) return axis;

    const double way = coordinates.back() - coordinates.front();
    if (way == 0.0)
        input.refuse(fmt::format("{} begins and ends at {:.9g}", axis.name, coordinates.front()),
                     "coordinates must rise or fall evenly");
    check_even(input, axis, coordinates);
    axis.descending = way < 0.0;
    axis.spacing = std::abs(way) / static_cast<double>(axis.count - 1);
    if (input.type(variable) != NC_FLOAT) axis.spacing = rounded(axis.spacing);
    axis.spacing *= unit.metres;
    return axis;
}

bool is_eastward_variable(const NetcdfInput& input, int variable) {
    const std::string standard = input.text(variable, "standard_name").value_or("");
    const std::string unit = input.text(variable, "units").value_or("");
    const std::string name = input.variable_name(variable);
    constexpr std::array<std::string_view, 6> names{"lon",     "longitude", "nav_lon",
                                                    "lon_rho", "XLONG",     "XLONG_M"};
    constexpr std::array<std::string_view, 6> units{"degrees_east", "degree_east", "degrees_E",
                                                    "degree_E",     "degreesE",    "degreeE"};
    return standard == "longitude" || standard == "projection_x_coordinate" ||
           is_among(units, unit) || is_among(names, name);
}

bool is_northward_variable(const NetcdfInput& input, int variable) {
    const std::string standard = input.text(variable, "standard_name").value_or("");
    const std::string unit = input.text(variable, "units").value_or("");
    const std::string name = input.variable_name(variable);
    constexpr std::array<std::string_view, 6> names{"lat",     "latitude", "nav_lat",
                                                    "lat_rho", "XLAT",     "XLAT_M"};
    constexpr std::array<std::string_view, 6> units{"degrees_north", "degree_north", "degrees_N",
                                                    "degree_N",      "degreesN",     "degreeN"};
    return standard == "latitude" || standard == "projection_y_coordinate" ||
           is_among(units, unit) || is_among(names, name);
}

bool is_eastward(const NetcdfInput& input, int dimension) {
    constexpr std::array<std::string_view, 10> names{
        "x", "X", "lon", "Lon", "LON", "longitude", "Longitude", "easting", "east", "west_east"};
    const auto variable = coordinate_variable(input, dimension);
    return is_among(names, input.dimension_name(dimension)) ||
           coordinate_text(input, dimension, "axis") == "X" ||
           (variable && is_eastward_variable(input, *variable));
}

bool is_northward(const NetcdfInput& input, int dimension) {
    constexpr std::array<std::string_view, 10> names{
        "y", "Y", "lat", "Lat", "LAT", "latitude", "Latitude", "northing", "north", "south_north"};
    const auto variable = coordinate_variable(input, dimension);
    return is_among(names, input.dimension_name(dimension)) ||
           coordinate_text(input, dimension, "axis") == "Y" ||
           (variable && is_northward_variable(input, *variable));
}

bool is_not_horizontal(const NetcdfInput& input, int dimension) {
    constexpr std::array<std::string_view, 14> names{"time", "Time",   "t",        "step", "record",
                                                     "z",    "band",   "bnds",     "nbnd", "bnd",
                                                     "nv",   "bounds", "vertices", "nb2"};
    const std::string axis = coordinate_text(input, dimension, "axis");
    return is_among(names, input.dimension_name(dimension)) || axis == "T" || axis == "Z" ||
           coordinate_text(input, dimension, "units").find(" since ") != std::string::npos;
}

}  // namespace fumon
