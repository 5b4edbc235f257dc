#include "picture/markup.h"

#include <algorithm>
#include <cstddef>

#include "base/utf8.h"

namespace fumon {

namespace {

/// How many bytes the character at the start of a text takes; 0 where none stands there, or one
/// that XML cannot hold: a control character, U+FFFE or U+FFFF.
std::size_t length_in_xml(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    const bool is_control = first < 0x20 || first == 0x7F;
    const bool is_none = text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF");
    return is_control || is_none ? 0 : utf8_length(text);
}

std::string_view entity(char letter) {
    switch (letter) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\'':
            return "&#39;";
        default:
            return {};
    }
}

}  // namespace

std::string markup_text(std::string_view text) {
    std::string marked;
    while (!text.empty()) {
        const std::size_t length = length_in_xml(text);
        if (const auto special = entity(text.front()); !special.empty()) {
            marked += special;
        } else if (length > 0) {
            marked += text.substr(0, length);
        } else {
            marked += '?';
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return marked;
}

}  // namespace fumon
