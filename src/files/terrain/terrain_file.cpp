#include "files/terrain/terrain_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "files/input_file.h"
#include "files/terrain/ground_lengths.h"
#include "files/terrain/netcdf_bed.h"
#include "files/terrain/terrain_format.h"

namespace fumon {

namespace {

/// Refuses what the scene says of another format.
void check_query(const std::filesystem::path& file, const TerrainFormat& format,
                 const TerrainQuery& query) {
    const auto refuse = [&](std::string_view given, std::string_view why, std::string_view key) {
        throw InputError(fmt::format("{}: {} for {}, which {}; leave {} out", file.string(), given,
                                     format.title, why, key));
    };
    if (format.has_heights && !query.png_heights.empty())
        refuse("a height range was given", "holds its own heights", "bed.heights or --heights");
    if (!format.has_variables && !query.variable.empty())
        refuse("a variable was named", "has none", "bed.variable");
    if (!format.has_variables && query.record != 0)
        refuse("a record was named", "has none", "bed.record");
    if (!format.has_bands && query.band != 0) refuse("a band was named", "has none", "bed.band");
}

}  // namespace

void add_note(Terrain& terrain, const std::string& remark) {
    if (remark.empty()) return;
    if (!terrain.note.empty()) terrain.note += "; ";
    terrain.note += remark;
}

Terrain read_terrain(const std::filesystem::path& file, const TerrainQuery& query) {
    const bool folder = std::filesystem::is_directory(file) && file.extension() == ".zarr";
    const std::string start =
        folder ? "" : start_of_input_file(file, TerrainFormat::signature_length);
    const auto formats = terrain_formats();
    const auto format = std::ranges::find_if(
        formats, [&](const TerrainFormat& one) { return one.is_one(file, start); });
    if (query.any_unit && !format->has_heights) {
        throw InputError(fmt::format("{}: {} holds shades, not numbers with a unit; give {}",
                                     file.string(), format->title,
                                     "a GeoTIFF, a NetCDF file or an ESRI ASCII grid"));
    }
    Terrain terrain = format->read(file, query);  // the last format is every other file's
    check_query(file, *format, query);
    make_true_lengths(terrain, format->name != netcdf_name, file.string());
    return terrain;
}

}  // namespace fumon
