#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "files/netcdf/netcdf_axis.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_variable.h"
#include "files/terrain/terrain_file.h"
#include "files/terrain/terrain_format.h"

namespace fumon {

/// Reads a bed from a NetCDF file, fumon's own or another's.
///
/// The variable is the one named, else bed_height, else the only numeric one over two horizontal
/// dimensions, alone or behind a third (time, step …), of which the last record is taken. It is
/// over (y, x) or (latitude, longitude); coordinates may rise or fall, and must be even (see
/// netcdf_axis.h). Without coordinates row 0 is the southernmost. Cells equal to _FillValue (or the
/// type's default) or missing_value, beyond valid_min, valid_max or valid_range, or NaN hold no
/// data; others are value × scale_factor + add_offset, converted to metres where their unit is
/// another length ("1" and none are taken as they are).
/// `query.any_unit` takes all numbers as they are, in whatever unit.
/// Cell sizes: lengths become metres; degrees become metres at the middle latitude (coordinates
/// without a unit are judged by is_geographic); sites and missing coordinates leave them 0. A grid
/// of a single row or column has square cells. `note` says what was chosen and converted.
///
/// Throws InputError "FILE: what; remedy" for a damaged or truncated file, no or several suitable
/// variables, an unknown name, more than `largest_grid_cells` cells, uneven coordinates, units that
/// are no lengths, infinite heights, and where no cell holds data.
Terrain read_netcdf_bed(const std::filesystem::path& file, const TerrainQuery& query);

/// The same of a file that is open, whose caller holds the NetcdfLock.
Terrain read_netcdf_bed(const NetcdfInput& input, const TerrainQuery& query);

/// The axes x and y of a variable: by coordinates of one dimension, by such of two, or by GDAL's
/// transform. Throws InputError as read_netcdf_bed, NetcdfFault. The caller holds the NetcdfLock.
std::pair<NetcdfAxis, NetcdfAxis> netcdf_axes(const NetcdfInput& input, const BedVariable& bed);

/// NetCDF files as a terrain format.
TerrainFormat netcdf_format();

inline constexpr std::string_view netcdf_name = "netcdf";

}  // namespace fumon
