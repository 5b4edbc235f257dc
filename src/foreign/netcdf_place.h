#pragma once

#include <string>
#include <vector>

#include "base/grid.h"
#include "files/netcdf/netcdf_cells.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_variable.h"

namespace fumon {

/// How the cells of a file's maps lie on the ground, and how to turn their rows right side up.
struct NetcdfPlace {
    WorldScale scale;
    int nx = 0;  ///< of the maps as they are read
    int ny = 0;
    bool swapped = false;  ///< the variable's columns run along its rows' dimension
    bool rows_fall = false;
    bool columns_fall = false;
    /// Of uneven spacing: where the file's columns and rows lie, in cells of the maps as they are
    /// read, from the first one on; else empty.
    std::vector<double> columns{};
    std::vector<double> rows{};
    double turn = 0.0;  ///< radians, of its columns' direction against the east
    std::string note{};
};

/// That of the maps over a variable's two sides: by coordinates of one dimension, or by such of
/// two, which may be turned against north; a turned grid is drawn along its own sides. Columns and
/// rows that are unevenly spaced are laid on even cells, linearly between them. Throws
/// InputError for curvilinear grids, with a remedy, NetcdfFault. The caller holds the
/// NetcdfLock.
NetcdfPlace place_of_maps(const NetcdfInput& input, const BedVariable& map);

/// A record of a map in the file's own numbers, turned by its place; NaN where it has none.
/// `values` as read_cells() takes them.
Grid read_map(const NetcdfInput& input, BedVariable map, const NetcdfPlace& place,
              const ValuesReader& values = {});

/// Whether a variable only says where maps lie: x, y, globalx …
bool is_place_variable(const std::string& name);

}  // namespace fumon
