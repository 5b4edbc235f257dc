#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/snapshot.h"
#include "files/terrain/terrain_file.h"

namespace fumon {

/// Numbers to write: heights in metres, or in model heights where the scale has no metres; or
/// another quantity, which has a description.
struct TerrainOutput {
    const Grid& heights;
    const Mask& nodata;
    const WorldScale& scale;
    std::string description{};  ///< "slope: angle of …"; empty: heights
    std::string unit{};         ///< of another quantity; "1" for pure numbers
};

/// One file of a written terrain.
struct TerrainBytes {
    std::string ending;  ///< of its name, ".asc"
    std::string bytes;
};

/// A kind of terrain file.
struct TerrainFormat {
    std::string_view name;   ///< as output.bed_format has it
    std::string_view title;  ///< "a GeoTIFF"
    /// Whether a file with this name and these first bytes (at most `signature_length`) is one.
    bool (*is_one)(const std::filesystem::path& file, std::string_view start);
    Terrain (*read)(const std::filesystem::path& file, const TerrainQuery& query);
    /// The files of a terrain; nullptr for a format that is only read.
    std::vector<TerrainBytes> (*write)(const TerrainOutput& terrain) = nullptr;
    /// Every ending of a written file; one name takes one place in a folder.
    std::vector<std::string_view> endings{};
    bool has_heights = true;     ///< its numbers are metres: it takes no bed.heights
    bool has_units = false;      ///< it says units, and its reader heeds TerrainQuery::height_unit
    bool has_variables = false;  ///< it takes bed.variable
    bool has_bands = false;      ///< it takes bed.band
    /// What it needs and is not installed, with the remedy; empty where nothing is missing.
    std::string (*missing)() = [] { return std::string(); };

    static constexpr std::size_t signature_length = 8;  // bytes
};

/// Every format, in the order in which a file is tried.
std::span<const TerrainFormat> terrain_formats();

/// "a NetCDF file, a GeoTIFF, a grey PNG or an ESRI ASCII grid".
std::string terrain_titles();

/// The names of the formats that can be written: "geotiff, esri-ascii".
std::string written_terrain_formats();

/// The format of that name that can be written, or nullptr.
const TerrainFormat* find_written_format(std::string_view name);

/// The files of a snapshot's bed in the formats of these names, all of which can be written:
/// heights in metres where there are metres, as terrain files are read.
std::vector<TerrainBytes> bed_files(const Snapshot& snapshot, std::span<const std::string> names);

}  // namespace fumon
