#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "foreign/foreign_run.h"

namespace fumon {

/// The run of other models' NetCDF files, one or several of one run, whose records follow one
/// another by their times. Which variable is what: by the query, by CF standard names, by the names
/// of models (variable_names.h); the only map of lengths is the bed. Triangles and polygons are
/// laid on a grid (mesh_maps.h). Throws InputError, one line, for files that are damaged, hold
/// groups alone or no map; where no variable, or more than one, is known as what is needed, with
/// the candidates; for units that do not fit, times that do not rise, and grids that differ.
ForeignRun read_netcdf_run(const std::string& name, std::vector<std::filesystem::path> files,
                           const ForeignQuery& query);

}  // namespace fumon
