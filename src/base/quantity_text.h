#pragma once

#include <algorithm>
#include <string>

namespace fumon {

/// The name of a column or key in words: "wavelength spectrum" of "wavelength_spectrum".
inline std::string in_words(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// A quantity as an axis names it: "wavelength spectrum (m)"; its name alone without a unit.
inline std::string quantity_text(const std::string& name, const std::string& unit) {
    return unit.empty() ? in_words(name) : in_words(name) + " (" + unit + ")";
}

}  // namespace fumon
