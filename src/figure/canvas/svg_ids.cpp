#include "figure/canvas/svg_ids.h"

#include <cctype>
#include <cstddef>
#include <map>
#include <string_view>

namespace fumon {

namespace {

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// How many letters and digits of letters followed by digits, and by nothing else of a name, a text
/// starts with; both 0 if it does not. Since Cairo 1.17 a hyphen stands between them.
struct NumberedName {
    std::size_t letters = 0;  ///< with the hyphen
    std::size_t length = 0;
};

NumberedName numbered_name(std::string_view text) {
    NumberedName name;
    while (name.letters < text.size() && is_letter(text[name.letters])) ++name.letters;
    if (name.letters > 0 && name.letters < text.size() && text[name.letters] == '-') ++name.letters;
    name.length = name.letters;
    while (name.length < text.size() && is_digit(text[name.length])) ++name.length;
    const bool ended =
        name.length < text.size() && (text[name.length] == '"' || text[name.length] == ')');
    if (name.letters == 0 || name.length == name.letters || !ended) return {};
    return name;
}

}  // namespace

std::string with_counted_ids(const std::string& svg) {
    constexpr std::string_view declared = " id=\"";
    std::map<std::string, std::string, std::less<>> counted;  // per id
    std::map<std::string, int, std::less<>> count;            // per name without number
    std::string out;
    out.reserve(svg.size());
    const std::string_view text(svg);
    for (std::size_t i = 0; i < text.size();) {
        const bool is_id = text.substr(i).starts_with(declared);
        if (!is_id && text[i] != '#') {
            out += text[i++];
            continue;
        }
        const std::size_t start = i + (is_id ? declared.size() : 1);
        out += text.substr(i, start - i);
        i = start;
        const NumberedName name = numbered_name(text.substr(start));
        if (name.length == 0) continue;
        const std::string id(text.substr(start, name.length));
        std::string& renamed = counted[id];
        if (renamed.empty()) {
            renamed = id.substr(0, name.letters);
            const int number = ++count[renamed];
            renamed += std::to_string(number);
        }
        out += renamed;
        i += name.length;
    }
    return out;
}

}  // namespace fumon
