#pragma once

#include <algorithm>
#include <string>

namespace fumon {

/// The name of a column or key in words: "wavelength spectrum" of "wavelength_spectrum".
inline std::string in_words(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// A quantity as an axis names it: "wavelength spectrum (m)"; its name alone without a unit. A name
/// that ends in its unit says it once: "mill discharge (m3/s)" of "mill_discharge_m3s".
inline std::string quantity_text(const std::string& name, const std::string& unit) {
    if (unit.empty()) return in_words(name);
    std::string ending = "_" + unit;
    std::erase(ending, '/');
    const bool twice = name.size() > ending.size() && name.ends_with(ending);
    return in_words(twice ? name.substr(0, name.size() - ending.size()) : name) + " (" + unit + ")";
}

/// A label of one's own, in which {unit} stands for what the usual one has in its last parentheses;
/// the usual one where there is none.
inline std::string label_or(const std::string& own, const std::string& usual) {
    if (own.empty()) return usual;
    constexpr const char* mark = "{unit}";
    const std::size_t at = own.find(mark);
    const std::size_t open = usual.rfind('(');
    if (at == std::string::npos || open == std::string::npos) return own;
    const std::string unit = usual.substr(open + 1, usual.rfind(')') - open - 1);
    return std::string(own).replace(at, std::string(mark).size(), unit);
}

}  // namespace fumon
