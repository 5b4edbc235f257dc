#pragma once

#include <cstddef>
#include <string_view>

namespace fumon {

/// How many bytes the character at the start of some bytes takes in well-formed UTF-8 (Unicode 15,
/// table 3-7: no overlong forms, no surrogates, nothing beyond U+10FFFF); 0 where none stands
/// there.
std::size_t utf8_length(std::string_view bytes);

/// Whether bytes are well-formed UTF-8.
bool is_utf8(std::string_view bytes);

}  // namespace fumon
