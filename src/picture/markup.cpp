#include "picture/markup.h"

#include <algorithm>
#include <cstddef>

namespace fumon {

namespace {

/// How many bytes the UTF-8 character at the start of a text takes; 0: it is none that may stand in
/// XML (RFC 3629; no overlong forms, surrogates or noncharacters U+FFFE and U+FFFF).
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const unsigned lead = byte(0);
    if (lead < 0x80) return lead >= 0x20 && lead != 0x7F ? 1 : 0;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) return 0;
    }
    const unsigned second = byte(1);
    const bool bad = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
                     (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F) ||
                     text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF");
    return bad ? 0 : length;
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
        const std::size_t length = character_length(text);
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
