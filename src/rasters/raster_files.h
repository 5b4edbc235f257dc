#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "files/terrain/terrain_format.h"
#include "measure/raster/raster_quantity.h"

namespace fumon {

/// What `fumon export --field` asks for.
struct RasterRequest {
    std::string input;  ///< a terrain file or a fields.nc
    std::string field;  ///< its name; empty: the heights, and in NetCDF all fields
    HillLight light{};  ///< of a hillshade
};

/// The names that --field takes of any input, in the order of raster_quantities().
std::vector<std::string> raster_names();

/// A line for each of them, for the help of the command.
std::string raster_help();

/// The files of a field of what the input holds, `snapshot`, in a terrain format. Throws InputError
/// "INPUT: …" for one that the input does not have, with the list of those that it has.
std::vector<TerrainBytes> raster_files(const RasterRequest& request, const Snapshot& snapshot,
                                       std::string_view format);

/// Writes the bed and the field as a NetCDF file of one record, see FieldsFile. Throws as above.
void write_raster_netcdf(const RasterRequest& request, Snapshot snapshot,
                         const std::filesystem::path& file);

}  // namespace fumon
