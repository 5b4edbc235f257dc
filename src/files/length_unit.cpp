#include "files/length_unit.h"

#include <array>
#include <string>
#include <utility>

#include "base/find_named.h"

namespace fumon {

namespace {

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

}  // namespace

std::optional<double> metres_per_unit(std::string_view unit) {
    constexpr double foot = 0.3048;  // international
    using Unit = std::pair<std::string_view, double>;
    constexpr std::array<Unit, 24> units{{
        {"m", 1.0},
        {"metre", 1.0},
        {"metres", 1.0},
        {"meter", 1.0},
        {"meters", 1.0},
        {"km", 1000.0},
        {"kilometre", 1000.0},
        {"kilometres", 1000.0},
        {"kilometer", 1000.0},
        {"kilometers", 1000.0},
        {"dm", 0.1},
        {"cm", 0.01},
        {"centimetre", 0.01},
        {"centimetres", 0.01},
        {"centimeter", 0.01},
        {"centimeters", 0.01},
        {"mm", 0.001},
        {"millimetre", 0.001},
        {"millimetres", 0.001},
        {"millimeter", 0.001},
        {"millimeters", 0.001},
        {"ft", foot},
        {"foot", foot},
        {"feet", foot},
    }};
    const std::string lower = lower_case(unit);
    const Unit* found = find_by(units, &Unit::first, lower);
    return found == nullptr ? std::nullopt : std::optional(found->second);
}

bool is_degrees(std::string_view unit) {
    const std::string lower = lower_case(unit);
    return lower.starts_with("degree") || lower == "deg" || lower == "°";
}

}  // namespace fumon
