#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/terrain/terrain_file.h"
#include "files/terrain/terrain_format.h"

namespace fumon {

/// Heights from a grey PNG image: `range` holds the metres of black and of white, between which
/// samples are linear (no gamma). The picture's top row is the northernmost. 8-bit images are read,
/// and `note` says how coarse their heights are. Cell sizes stay 0: a PNG does not tell them.
/// Throws InputError "NAME: what; remedy" for a colour image, one with alpha or a transparent
/// colour, fewer than 8 bits, a damaged file, a missing range or one whose ends are equal or not
/// finite.
Terrain parse_png_heights(std::string_view bytes, const std::string& name,
                          const std::vector<double>& range);

/// Grey PNG images as a terrain format.
TerrainFormat png_heights_format();

}  // namespace fumon
