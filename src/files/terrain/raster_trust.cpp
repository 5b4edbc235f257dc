#include "files/terrain/raster_trust.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/gdal/raster_kinds.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "files/terrain/grid_hash.h"
#include "files/terrain/terrain_format.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

/// Whether one of the drivers for files of unknown origin takes it.
bool is_read_untrusted(const fs::path& file) {
    const GdalSession session(GdalSession::Siblings::none);
    return gdal().GDALIdentifyDriverEx(fs::absolute(file).c_str(), GDAL_OF_RASTER,
                                       raster_drivers(false).data(), nullptr) != nullptr;
}

}  // namespace

std::string why_trust_is_needed_by_name(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& letter : ending)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    if (ending == ".vrt") return "a VRT names other files";
    if (ending == ".zarr") return "a Zarr store is a folder of files";
    constexpr std::array many{".img"sv, ".gpkg"sv, ".bil"sv,  ".bip"sv,  ".bsq"sv, ".flt"sv,
                              ".ers"sv, ".rst"sv,  ".sdat"sv, ".sgrd"sv, ".ddf"sv, ".shp"sv};
    if (std::ranges::find(many, ending) == many.end()) return {};
    return fmt::format("its format ({}) may name other files", ending);
}

std::string why_trust_is_needed(const fs::path& file) {
    std::string why = why_trust_is_needed_by_name(file);
    if (!why.empty() || is_zarr(file) || !has_gdal()) return why;
    const std::string start = start_of_input_file(file, TerrainFormat::signature_length);
    if (is_vrt(file, start)) return "a VRT names other files";
    const auto formats = terrain_formats();
    const auto format = std::ranges::find_if(
        formats, [&](const TerrainFormat& one) { return one.is_one(file, start); });
    const bool png = format->name == "png";  // whose place as a drape is beside it
    if (!png && format->name != "geotiff" && format->name != "raster") return {};
    if (!png && !is_read_untrusted(file)) return "its format may name other files";
    const std::vector<GridPart> parts = grid_parts(file);
    if (parts.empty()) return {};
    return fmt::format("{} beside it belongs to it", parts.front().file.filename().string());
}

}  // namespace fumon
