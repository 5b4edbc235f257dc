#include "files/netcdf/netcdf_variable.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

#include "base/nearest_name.h"
#include "files/netcdf/netcdf_axis.h"

namespace fumon {

namespace {

/// The dimensions of a variable that are a map's sides, and the one along which it has records.
struct Sides {
    int y = -1;
    int x = -1;
    std::optional<int> records{};
    std::string obstacle{};  ///< why it is no bed; or empty
};

/// The last of some dimensions but one that has more than one cell, else the last but it.
int last_but(const NetcdfInput& input, const std::vector<int>& dimensions, int other) {
    int found = -1;
    for (const int dimension : dimensions) {
        const bool is_longer = input.dimension_length(dimension) != 1 || found < 0 ||
                               input.dimension_length(found) == 1;
        if (dimension != other && is_longer) found = dimension;
    }
    return found;
}

/// By what names and attributes say, else by their order: rows before columns. Dimensions of length
/// 1 are passed over where there are others.
Sides sides_of(const NetcdfInput& input, int variable) {
    Sides sides;
    const std::vector<int> over = input.dimensions(variable);
    std::vector<int> level;  // the horizontal ones
    for (const int dimension : over) {
        if (!is_not_horizontal(input, dimension)) level.push_back(dimension);
    }
    for (const int dimension : level) {
        const bool east = is_eastward(input, dimension);
        const bool north = is_northward(input, dimension);
        if (east && !north) sides.x = dimension;
        if (north && !east) sides.y = dimension;
    }
    if (sides.x < 0) sides.x = last_but(input, level, sides.y);
    if (sides.y < 0) sides.y = last_but(input, level, sides.x);
    if (over.size() < 2) {
        sides.obstacle = fmt::format("has {} dimensions", over.size());
        return sides;
    }
    if (sides.x < 0 || sides.y < 0 || std::ranges::count(over, sides.x) > 1 ||
        std::ranges::count(over, sides.y) > 1) {
        sides.obstacle = fmt::format("has the dimensions {} and {}, which do not form a map",
                                     input.dimension_name(over[over.size() - 2]),
                                     input.dimension_name(over.back()));
        return sides;
    }
    for (const int dimension : over) {
        if (dimension == sides.x || dimension == sides.y) continue;
        const bool is_long = input.dimension_length(dimension) != 1;
        const bool has_long = sides.records && input.dimension_length(*sides.records) != 1;
        if (is_long && has_long) {
            sides.obstacle = fmt::format(
                "has records along {} ({}) and {} ({})", input.dimension_name(*sides.records),
                input.dimension_length(*sides.records), input.dimension_name(dimension),
                input.dimension_length(dimension));
        }
        if (is_long || !sides.records) sides.records = dimension;
    }
    return sides;
}

/// Why a variable is no bed; empty where it may be one.
std::string obstacle(const NetcdfInput& input, int variable) {
    if (!input.is_numeric(variable)) return "does not hold numbers";
    return sides_of(input, variable).obstacle;
}

/// Variables that only say where others lie.
std::set<std::string> helpers(const NetcdfInput& input) {
    std::set<std::string> names;
    for (int variable = 0; variable < input.variables(); ++variable) {
        for (const char* attribute : {"bounds", "coordinates"}) {
            std::istringstream words(input.text(variable, attribute).value_or(""));
            for (std::string word; words >> word;) names.insert(word);
        }
    }
    return names;
}

/// The variables that may be the bed. A file may bear names by which the library does not find
/// them, so they are known by number.
std::vector<int> candidates(const NetcdfInput& input) {
    const std::set<std::string> not_these = helpers(input);
    std::vector<int> found;
    for (int variable = 0; variable < input.variables(); ++variable) {
        const bool has_location =
            is_eastward_variable(input, variable) || is_northward_variable(input, variable);
        if (!has_location && !not_these.contains(input.variable_name(variable)) &&
            obstacle(input, variable).empty())
            found.push_back(variable);
    }
    return found;
}

std::vector<std::string> names_of(const NetcdfInput& input, const std::vector<int>& variables) {
    std::vector<std::string> names;
    names.reserve(variables.size());
    for (const int variable : variables) names.push_back(input.variable_name(variable));
    return names;
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most; ++i)
        text += (i == 0 ? "" : ", ") + names[i];
    return names.size() > most ? text + " …" : text;
}

constexpr std::string_view layout_help =
    "a bed is a numeric variable over y and x, or over these and one of time, band or the like";

int choose(const NetcdfInput& input, const std::string& wanted) {
    if (!wanted.empty()) {
        if (const auto named = input.find_variable(wanted)) return *named;
        const auto known = candidates(input);
        input.refuse(
            fmt::format("has no variable \"{}\"", wanted),
            known.empty() ? std::string(layout_help) : suggestion(wanted, names_of(input, known)));
    }
    if (const auto own = input.find_variable("bed_height")) return *own;
    const auto known = candidates(input);
    if (known.empty()) input.refuse("holds no bed", layout_help);
    if (known.size() > 1)
        input.refuse(fmt::format("holds {} variables that may be the bed", known.size()),
                     fmt::format("name one by bed.variable: {}", listed(names_of(input, known))));
    return known.front();
}

}  // namespace

namespace {

/// A variable without its record.
BedVariable bed_variable(const NetcdfInput& input, int variable) {
    BedVariable bed;
    bed.variable = variable;
    bed.name = input.variable_name(variable);
    const Sides sides = sides_of(input, variable);
    bed.x = sides.x;
    bed.y = sides.y;
    bed.has_records = sides.records.has_value();
    bed.records = sides.records.value_or(-1);
    return bed;
}

}  // namespace

std::vector<BedVariable> map_variables(const NetcdfInput& input) {
    std::vector<BedVariable> maps;
    for (const int variable : candidates(input)) {
        maps.push_back(bed_variable(input, variable));
        BedVariable& map = maps.back();
        if (map.has_records)
            map.record = std::max<std::size_t>(1, input.dimension_length(map.records)) - 1;
    }
    return maps;
}

BedVariable choose_bed_variable(const NetcdfInput& input, const std::string& wanted,
                                const WantedRecord& record) {
    const int variable = choose(input, wanted);
    if (const std::string why = obstacle(input, variable); !why.empty())
        input.refuse(fmt::format("{} {}", input.variable_name(variable), why), layout_help);
    BedVariable bed = bed_variable(input, variable);
    if (!bed.has_records && record.number > 0)
        input.refuse(fmt::format("{} has no records", bed.name), "leave bed.record out");
    if (!bed.has_records) return bed;
    const std::size_t records = input.dimension_length(bed.records);
    if (records == 0)
        input.refuse(fmt::format("{} has no record yet", bed.name), "let the run write one first");
    const auto number = static_cast<std::size_t>(record.number);
    if (number > records || (number == 0 && records > 1 && record.must_name)) {
        input.refuse(fmt::format("{} has {} records", bed.name, records),
                     fmt::format("name one of them by bed.record, 1 to {}", records));
    }
    bed.record = number > 0 ? number - 1 : records - 1;
    if (records > 1 && number == 0)
        bed.note = fmt::format("the last of {} records of {} is read", records, bed.name);
    return bed;
}

}  // namespace fumon
