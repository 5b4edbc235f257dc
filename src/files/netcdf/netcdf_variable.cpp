#include "files/netcdf/netcdf_variable.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <set>
#include <sstream>

#include "base/nearest_name.h"
#include "files/netcdf/netcdf_axis.h"

namespace fumon {

namespace {

/// Why a variable is no bed; empty where it may be one.
std::string obstacle(const NetcdfInput& input, int variable) {
    if (!input.is_numeric(variable)) return "does not hold numbers";
    const std::vector<int> over = input.dimensions(variable);
    if (over.size() < 2 || over.size() > 3) return fmt::format("has {} dimensions", over.size());
    const int x = over[over.size() - 1];
    const int y = over[over.size() - 2];
    if (x == y || says_not_horizontal(input, x) || says_not_horizontal(input, y))
        return fmt::format("is over {} and {}, which is no map", input.dimension_name(y),
                           input.dimension_name(x));
    if (says_northward(input, x) || says_eastward(input, y))
        return fmt::format("is over ({}, {}), columns before rows", input.dimension_name(y),
                           input.dimension_name(x));
    return "";
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
        if (!not_these.contains(input.variable_name(variable)) && obstacle(input, variable).empty())
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

constexpr std::string_view what_fits =
    "a bed is a numeric variable over (y, x), or over (time, y, x)";

int choose(const NetcdfInput& input, const std::string& wanted) {
    if (!wanted.empty()) {
        if (const auto named = input.find_variable(wanted)) return *named;
        const auto known = candidates(input);
        input.refuse(
            fmt::format("has no variable \"{}\"", wanted),
            known.empty() ? std::string(what_fits) : suggestion(wanted, names_of(input, known)));
    }
    if (const auto own = input.find_variable("bed_height")) return *own;
    const auto known = candidates(input);
    if (known.empty()) input.refuse("holds no bed", what_fits);
    if (known.size() > 1)
        input.refuse(fmt::format("holds {} variables that may be the bed", known.size()),
                     fmt::format("name one by bed.variable: {}", listed(names_of(input, known))));
    return known.front();
}

}  // namespace

BedVariable choose_bed_variable(const NetcdfInput& input, const std::string& wanted,
                                const WantedRecord& record) {
    BedVariable bed;
    bed.variable = choose(input, wanted);
    bed.name = input.variable_name(bed.variable);
    if (const std::string why = obstacle(input, bed.variable); !why.empty())
        input.refuse(fmt::format("{} {}", bed.name, why), what_fits);
    const std::vector<int> over = input.dimensions(bed.variable);
    bed.x = over[over.size() - 1];
    bed.y = over[over.size() - 2];
    bed.has_records = over.size() == 3;
    if (!bed.has_records && record.number > 0)
        input.refuse(fmt::format("{} has no records", bed.name), "leave bed.record out");
    if (!bed.has_records) return bed;
    const std::size_t records = input.dimension_length(over.front());
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
