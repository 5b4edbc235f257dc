#include "foreign/netcdf_times.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <vector>

#include "files/netcdf/netcdf_cells.h"
#include "files/unit_conversion.h"

namespace fumon {

namespace {

constexpr std::string_view since = " since ";

/// AeoLiS writes a list of words: "['2015-01-01' '00:00']".
std::string without_brackets(std::string text) {
    std::erase_if(text,
                  [](char letter) { return letter == '[' || letter == ']' || letter == '\''; });
    return text;
}

}  // namespace

bool is_time(const NetcdfInput& input, int variable) {
    constexpr std::array<std::string_view, 8> names{"time", "Time",       "t",    "times",
                                                    "T",    "globaltime", "TIME", "time_model"};
    const std::string unit = input.text(variable, "units").value_or("");
    return unit.find(since) != std::string::npos ||
           input.text(variable, "standard_name").value_or("") == "time" ||
           input.text(variable, "axis").value_or("") == "T" ||
           std::ranges::find(names, input.variable_name(variable)) != names.end();
}

std::vector<double> values_along(const NetcdfInput& input, int variable, int dimension) {
    std::vector<double> values(input.dimension_length(dimension));
    if (values.empty()) return values;
    check_netcdf(nc_get_var_double(input.id(), variable, values.data()));
    const MissingValues missing = missing_values(input, variable);
    const auto scale = input.numbers(variable, "scale_factor");
    const auto offset = input.numbers(variable, "add_offset");
    for (double& value : values) {
        if (missing.holds(value)) {
            value = std::numeric_limits<double>::quiet_NaN();
            continue;
        }
        if (!scale.empty()) value *= scale.front();
        if (!offset.empty()) value += offset.front();
    }
    return values;
}

std::optional<int> time_variable(const NetcdfInput& input, int dimension) {
    const auto over = [&](int variable) {
        return input.is_numeric(variable) &&
               input.dimensions(variable) == std::vector<int>{dimension};
    };
    const auto named = input.find_variable(input.dimension_name(dimension));
    if (named && over(*named)) return named;
    for (int variable = 0; variable < input.variables(); ++variable)
        if (over(variable) && is_time(input, variable)) return variable;
    return std::nullopt;
}

RawTimes netcdf_times(const NetcdfInput& input, int dimension, const std::string& wanted,
                      const std::string& said) {
    RawTimes times;
    std::optional<int> variable = time_variable(input, dimension);
    const auto named = wanted.empty() ? std::nullopt : input.find_variable(wanted);
    if (named && input.is_numeric(*named) &&
        input.dimensions(*named) == std::vector<int>{dimension})
        variable = named;
    if (!variable) {
        times.counted = true;
        times.note = fmt::format("{} has no variable of times: its records are counted",
                                 input.dimension_name(dimension));
        for (std::size_t i = 0; i < input.dimension_length(dimension); ++i)
            times.values.push_back(static_cast<double>(i));
        return times;
    }
    times.values = values_along(input, *variable, dimension);
    std::string unit = input.text(*variable, "units").value_or("");
    const std::string name = input.variable_name(*variable);
    const std::size_t at = unit.find(since);
    if (at != std::string::npos) {
        const std::string calendar = input.text(*variable, "calendar").value_or("");
        const auto kind = calendar_kind(calendar == "none" ? "" : calendar);
        if (!kind)
            input.refuse(fmt::format("the calendar of {} is \"{}\"", name, calendar),
                         "it takes standard, noleap or 360_day");
        times.calendar = *kind;
        if (const auto date = parse_date(without_brackets(unit.substr(at + since.size())))) {
            times.origin = seconds_of(*date, *kind);
            if (*kind == CalendarKind::gregorian && calendar != "proleptic_gregorian")
                *times.origin += seconds_to_julian(*date);
        }
        unit.resize(at);
    }
    if (unit.empty() || unit == "-" || unit == "1") unit = said;
    const auto seconds = unit_conversion(unit, "s");
    if (!seconds) {
        times.counted = true;
        times.origin.reset();
        times.note =
            unit.empty()
                ? fmt::format(
                      "{} has no unit: its numbers are taken as steps; --time-unit says theirs",
                      name)
                : fmt::format("{} is in \"{}\", not a unit of time: its numbers are taken as steps",
                              name, unit);
        return times;
    }
    for (double& value : times.values) value *= seconds->factor;
    return times;
}

}  // namespace fumon
