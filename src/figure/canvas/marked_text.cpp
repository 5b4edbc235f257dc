#include "figure/canvas/marked_text.h"

#include <algorithm>
#include <string_view>

namespace fumon {

namespace {

/// The end of a whole number, perhaps with a sign, that begins there; `begin` where there is none.
std::size_t end_of_power(const std::string& text, std::size_t begin) {
    constexpr std::string_view minus = "\u2212";
    std::size_t digits = begin;
    if (text.compare(digits, minus.size(), minus) == 0) {
        digits += minus.size();
    } else if (digits < text.size() && (text[digits] == '-' || text[digits] == '+')) {
        ++digits;
    }
    const std::size_t end = std::min(text.find_first_not_of("0123456789", digits), text.size());
    return end > digits ? end : begin;
}

bool is_base(char letter) {
    return letter == ')' || (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || static_cast<unsigned char>(letter) > 127;
}

}  // namespace

MarkedText read_marked_text(const std::string& text) {
    MarkedText marked;
    std::size_t i = 0;
    while (i < text.size()) {
        if (text[i] == '^' && i > 0 && is_base(text[i - 1])) {
            const std::size_t power = end_of_power(text, i + 1);
            if (power > i + 1) {
                const std::size_t begin = marked.letters.size();
                std::size_t from = i + 1;
                if (text[from] == '-') {
                    marked.letters += "\u2212";
                    ++from;
                }
                marked.letters.append(text, from, power - from);
                marked.parts.push_back({begin, marked.letters.size(), true});
                i = power;
                continue;
            }
        }
        const bool mark =
            (text[i] == '^' || text[i] == '_') && i + 1 < text.size() && text[i + 1] == '{';
        const std::size_t end = mark ? text.find('}', i) : std::string::npos;
        if (end == std::string::npos) {
            marked.letters += text[i++];
            continue;
        }
        const std::size_t begin = marked.letters.size();
        marked.letters.append(text, i + 2, end - i - 2);
        marked.parts.push_back({begin, marked.letters.size(), text[i] == '^'});
        i = end + 1;
    }
    return marked;
}

}  // namespace fumon
