#pragma once

#include <filesystem>
#include <string_view>

namespace fumon {

/// Whether a file is a VRT of GDAL's, which names the parts of a raster and their files.
inline bool is_vrt(const std::filesystem::path& file, std::string_view start) {
    return start.starts_with("<VRTData") || file.extension() == ".vrt";
}

/// Whether a file's first bytes or its ending are those of a VRT, or of a TIFF (of either byte
/// order, of 32 or 64 bits).
inline bool is_geotiff(const std::filesystem::path& file, std::string_view start) {
    using namespace std::string_view_literals;
    for (const std::string_view signature : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
        if (start.starts_with(signature)) return true;
    }
    const auto ending = file.extension();
    return ending == ".tif" || ending == ".tiff" || is_vrt(file, start);
}

}  // namespace fumon
