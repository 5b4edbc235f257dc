#include "files/netcdf/netcdf_axis.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "files/unit_conversion.h"

namespace fumon {

namespace {

/// The one-dimensional numeric variable that bears a dimension's name.
std::optional<int> coordinate_variable(const NetcdfInput& input, int dimension) {
    const auto variable = input.find_variable(input.dimension_name(dimension));
    if (!variable || !input.is_numeric(*variable)) return std::nullopt;
    if (input.dimensions(*variable) != std::vector<int>{dimension}) return std::nullopt;
    return variable;
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
    if (unit.empty()) return {};
    if (unit == "1") return {AxisUnit::sites};
    if (is_degrees(unit)) return {AxisUnit::degrees};
    if (const auto metres = metres_per_unit(unit)) return {AxisUnit::metres, *metres};
    input.refuse(fmt::format("the unit of {} is \"{}\"", name, unit),
                 "coordinates are in a unit of length (\"m\") or in degrees");
}

void check_even(const NetcdfInput& input, const NetcdfAxis& axis,
                const std::vector<double>& coordinates, bool single_precision) {
    constexpr double even = 1e-6;  // of the way from first to last
    const double first = coordinates.front();
    const double way = coordinates.back() - first;
    const double largest = std::max(std::abs(first), std::abs(coordinates.back()));
    const double rounding = single_precision ? std::numeric_limits<float>::epsilon() * largest
                                             : std::numeric_limits<double>::epsilon() * largest;
    const double tolerance = even * std::abs(way) + 2.0 * rounding;
    const auto intervals = static_cast<double>(coordinates.size() - 1);
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const double expected = first + way * (static_cast<double>(i) / intervals);
        if (std::abs(coordinates[i] - expected) <= tolerance) continue;
        input.refuse(fmt::format("{} is not evenly spaced: {}[{}] is {:.9g} where even spacing "
                                 "has {:.9g}",
                                 axis.name, axis.name, i, coordinates[i], expected),
                     "put the heights on an even grid first");
    }
}

}  // namespace

NetcdfAxis read_netcdf_axis(const NetcdfInput& input, int dimension) {
    NetcdfAxis axis;
    axis.name = input.dimension_name(dimension);
    axis.count = input.dimension_length(dimension);
    const auto variable = coordinate_variable(input, dimension);
    if (!variable || axis.count == 0) return axis;
    axis.has_coordinates = true;
    const Unit unit = unit_of(input, *variable, axis.name);
    axis.unit = unit.kind;

    std::vector<double> coordinates(axis.count);
    check_netcdf(nc_get_var_double(input.id(), *variable, coordinates.data()));
    const auto scale = input.numbers(*variable, "scale_factor");
    const auto offset = input.numbers(*variable, "add_offset");
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        double& value = coordinates[i];
        if (!scale.empty()) value *= scale.front();
        if (!offset.empty()) value += offset.front();
        value *= unit.metres;
        if (!std::isfinite(value))
            input.refuse(fmt::format("{}[{}] is not a finite number", axis.name, i),
                         "every coordinate must be one");
    }
    axis.lowest = std::min(coordinates.front(), coordinates.back());
    if (axis.count == 1) return axis;

    const double way = coordinates.back() - coordinates.front();
    if (way == 0.0)
        input.refuse(fmt::format("{} begins and ends at {:.9g}", axis.name, coordinates.front()),
                     "coordinates must rise or fall evenly");
    const bool single_precision = input.type(*variable) == NC_FLOAT;
    check_even(input, axis, coordinates, single_precision);
    axis.descending = way < 0.0;
    axis.spacing = std::abs(way) / static_cast<double>(axis.count - 1);
    if (!single_precision) axis.spacing = rounded(axis.spacing);
    return axis;
}

bool says_eastward(const NetcdfInput& input, int dimension) {
    constexpr std::array<std::string_view, 8> names{"x",   "X",         "lon",     "Lon",
                                                    "LON", "longitude", "easting", "east"};
    const std::string standard = coordinate_text(input, dimension, "standard_name");
    return is_among(names, input.dimension_name(dimension)) ||
           coordinate_text(input, dimension, "axis") == "X" || standard == "longitude" ||
           standard == "projection_x_coordinate";
}

bool says_northward(const NetcdfInput& input, int dimension) {
    constexpr std::array<std::string_view, 8> names{"y",   "Y",        "lat",      "Lat",
                                                    "LAT", "latitude", "northing", "north"};
    const std::string standard = coordinate_text(input, dimension, "standard_name");
    return is_among(names, input.dimension_name(dimension)) ||
           coordinate_text(input, dimension, "axis") == "Y" || standard == "latitude" ||
           standard == "projection_y_coordinate";
}

bool says_not_horizontal(const NetcdfInput& input, int dimension) {
    constexpr std::array<std::string_view, 6> names{"time", "Time", "t", "step", "record", "z"};
    const std::string axis = coordinate_text(input, dimension, "axis");
    return is_among(names, input.dimension_name(dimension)) || axis == "T" || axis == "Z" ||
           coordinate_text(input, dimension, "units").find(" since ") != std::string::npos;
}

}  // namespace fumon
