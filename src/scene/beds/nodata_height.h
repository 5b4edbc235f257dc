#pragma once

#include <cstdint>

#include "files/terrain/terrain_file.h"

namespace fumon {

/// Takes the cells of a height, in metres or as the file has it, out of a terrain. How many.
std::int64_t take_out_height(Terrain& terrain, double value);

}  // namespace fumon
