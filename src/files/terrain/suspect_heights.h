#pragma once

#include <string>

#include "files/terrain/terrain_file.h"

namespace fumon {

/// One line on heights that no ground has and that the file has not declared as no data, or empty:
/// those beyond 30 km in size, and those of the numbers that are customary for no data (−9999,
/// 9999, −32768, 32767 … in the file's own unit) that lie more than 1 km from all other heights.
/// Throws InputError "FILE: …" for heights beyond `largest_height` (base/limits.h). Both say how
/// bed.nodata_value takes them out.
std::string suspect_heights(const Terrain& terrain, const std::string& file);

}  // namespace fumon
