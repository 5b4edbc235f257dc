#include "base/utf8.h"

namespace fumon {

namespace {

/// What the bytes of a character are by its first: how many, and the range of the second.
struct Form {
    std::size_t length = 0;  ///< 0: no character starts so
    unsigned char second_low = 0x80;
    unsigned char second_high = 0xBF;
};

Form form_of(unsigned char first) {
    if (first < 0x80) return {1};
    if (first >= 0xC2 && first <= 0xDF) return {2};
    if (first == 0xE0) return {3, 0xA0, 0xBF};
    if (first == 0xED) return {3, 0x80, 0x9F};
    if (first >= 0xE1 && first <= 0xEF) return {3};
    if (first == 0xF0) return {4, 0x90, 0xBF};
    if (first >= 0xF1 && first <= 0xF3) return {4};
    if (first == 0xF4) return {4, 0x80, 0x8F};
    return {};
}

}  // namespace

std::size_t utf8_length(std::string_view bytes) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    if (bytes.empty()) return 0;
    const Form form = form_of(at(0));
    if (bytes.size() < form.length) return 0;
    if (form.length > 1 && (at(1) < form.second_low || at(1) > form.second_high)) return 0;
    for (std::size_t i = 2; i < form.length; ++i) {
        if (at(i) < 0x80 || at(i) > 0xBF) return 0;
    }
    return form.length;
}

bool is_utf8(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::size_t length = utf8_length(bytes);
        if (length == 0) return false;
        bytes.remove_prefix(length);
    }
    return true;
}

}  // namespace fumon
