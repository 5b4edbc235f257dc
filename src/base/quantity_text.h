#pragma once

#include <algorithm>
#include <string>
#include <string_view>

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

/// What a label has in its last parentheses: "m" of "height (m)"; empty where it has none.
inline std::string unit_of(const std::string& label) {
    const std::size_t open = label.rfind('(');
    if (open == std::string::npos) return {};
    return label.substr(open + 1, label.rfind(')') - open - 1);
}

/// A label of one's own, in which {unit} stands for the unit of the usual one; the usual one where
/// there is none; "{{" and "}}" are braces. Of what has no unit, {unit} goes with the brackets and
/// the blank before it, and alone it is 1.
inline std::string label_or(const std::string& own, const std::string& usual) {
    if (own.empty()) return usual;
    constexpr std::string_view mark = "{unit}";
    const std::string unit = unit_of(usual);
    std::string label = own;
    for (std::size_t at = label.find(mark); at != std::string::npos; at = label.find(mark, at)) {
        std::size_t begin = at;
        std::size_t end = at + mark.size();
        const bool in_brackets = begin > 0 && end < label.size() &&
                                 ((label[begin - 1] == '(' && label[end] == ')') ||
                                  (label[begin - 1] == '[' && label[end] == ']'));
        if (!unit.empty() || !in_brackets) {
            label.replace(at, mark.size(), unit.empty() ? "1" : unit);
            continue;
        }
        --begin;
        ++end;
        if (begin > 0 && label[begin - 1] == ' ') --begin;
        label.erase(begin, end - begin);
        at = begin;
    }
    for (const char* brace : {"{{", "}}"}) {
        for (std::size_t at = label.find(brace); at != std::string::npos;
             at = label.find(brace, at + 1))
            label.erase(at, 1);
    }
    return label;
}

}  // namespace fumon
