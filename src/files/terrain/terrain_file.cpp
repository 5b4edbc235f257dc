#include "files/terrain/terrain_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "files/terrain/ground_lengths.h"
#include "files/terrain/netcdf_bed.h"
#include "files/terrain/terrain_format.h"
#include "files/terrain/wanted_unit.h"

namespace fumon {

void add_note(Terrain& terrain, const std::string& remark) {
    if (remark.empty()) return;
    if (!terrain.note.empty()) terrain.note += "; ";
    terrain.note += remark;
}

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
    if (!format.has_heights && !query.height_unit.empty())
        refuse("a unit of heights was named", "holds shades", "bed.height_unit");
    if (!format.has_bands && query.band != 0) refuse("a band was named", "has none", "bed.band");
}

/// What the scene says of all formats alike, and a unit where the format itself has none.
void apply_to_heights(const TerrainFormat& format, const TerrainQuery& query, Terrain& terrain) {
    double factor = query.height_factor;
    if (!format.has_units && !query.height_unit.empty()) {
        const auto conversion = conversion_for(query, "");
        factor *= conversion->factor;
        add_note(terrain, conversion_note(query, "", *conversion));
    }
    if (query.height_sign == HeightSign::down) factor = -factor;
    if (factor == 1.0) return;
    terrain.metres_per_number *= factor;
    for (std::size_t cell = 0; cell < terrain.heights.size(); ++cell) {
        if (terrain.nodata.empty() || terrain.nodata.values()[cell] == 0)
            terrain.heights.values()[cell] *= factor;
    }
}

}  // namespace

Terrain read_terrain(const std::filesystem::path& file, const TerrainQuery& query) {
    if (!query.any_unit && !conversion_for(query, "")) {
        throw InputError(fmt::format("{}: the unit of heights is given as \"{}\"; {}",
                                     file.string(), query.height_unit,
                                     wanted_units(query, "write bed.height_unit = \"ft\", say")));
    }
    const std::string start =
        is_zarr(file) ? "" : start_of_input_file(file, TerrainFormat::signature_length);
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
    if (!query.any_unit) apply_to_heights(*format, query, terrain);
    make_true_lengths(terrain, format->name != netcdf_name, file.string());
    return terrain;
}

}  // namespace fumon
