#include "base/utf8.h"

#include <cstddef>

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

bool is_utf8(std::string_view bytes) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    for (std::size_t start = 0; start < bytes.size();) {
        const Form form = form_of(at(start));
        if (form.length == 0 || bytes.size() - start < form.length) return false;
        if (form.length > 1 &&
            (at(start + 1) < form.second_low || at(start + 1) > form.second_high))
            return false;
        for (std::size_t i = start + 2; i < start + form.length; ++i) {
            if (at(i) < 0x80 || at(i) > 0xBF) return false;
        }
        start += form.length;
    }
    return true;
}

}  // namespace fumon
