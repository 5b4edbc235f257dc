#pragma once

#include <filesystem>
#include <string>

namespace fumon {

/// Why a raster of unknown origin is opened only by its user's word, "a VRT names other files":
/// its format may name other files, or files beside it count (grid_parts), which GDAL opens; empty
/// where it is read as it is. A file of no kind that GDAL reads needs no trust.
std::string why_trust_is_needed(const std::filesystem::path& file);

/// The same by the name's ending alone, which tells nothing of what is there.
std::string why_trust_is_needed_by_name(const std::filesystem::path& file);

}  // namespace fumon
