#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fumon {

/// 256 colours (sRGB), from the lowest value to the highest.
using Palette = std::array<std::array<std::uint8_t, 3>, 256>;

/// The palette of that name: assets/palettes/NAME.txt, 256 lines "red green blue" in 0 … 255.
/// Throws InputError where there is none of that name (scene/view/palette_names.h), and one
/// with file and line where its file is malformed.
Palette read_palette(std::string_view name);

/// A palette from the text of such a file; `source` names it in messages. Throws InputError.
Palette parse_palette(std::string_view text, std::string_view source);

}  // namespace fumon
