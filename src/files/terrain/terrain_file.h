#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// Heights as a file holds them: metres, row 0 southernmost, with the cells that hold no data.
struct Terrain {
    Grid heights;     ///< metres; 0 in no-data cells
    Mask nodata;      ///< empty when every cell has data
    double dx = 0.0;  ///< metres; 0 when the file does not say (PNG, NetCDF in sites)
    double dy = 0.0;
    std::string
        note;  ///< what was converted and the user should hear ("degrees to metres at …"); or empty
};

/// Reads an ESRI ASCII grid (see esri_ascii.h) or, by its signature, a 16-bit (or 8-bit) grey PNG
/// (see png_heights.h) or a NetCDF file (see netcdf_bed.h). `png_heights` are the metres of black
/// and of white, {} for other files; `variable` is the NetCDF variable to read, "" for what the
/// file itself suggests and for other files.
/// Cell sizes in degrees are recognised (see geographic.h for the rule) and converted at the
/// mid-latitude (dx ≠ dy), which `note` says. At most 2^27 cells are read. Throws InputError
/// "file:line: what is wrong; what would be right" for every malformed file ("file: …" where there
/// are no lines).
Terrain read_terrain(const std::filesystem::path& file, const std::vector<double>& png_heights,
                     const std::string& variable = {});

/// Writes heights (metres or model heights) as an ESRI ASCII grid, north row first, with the fewest
/// digits that read back as the same double (17 at most) and the origin (0, 0). No-data cells
/// become −9999, or −99999 and so on where that is a height. dx ≠ dy is written as dx and dy lines,
/// as GDAL does; both are greater than 0.
std::string esri_ascii(const Grid& heights, const Mask& nodata, double dx, double dy);

/// Fills no-data cells smoothly from their rim: the discrete Laplace equation on the holes, with no
/// slope across the grid's edge; the other cells stay as they are. Exact for up to 300,000 hole
/// cells; beyond, an iteration that starts from the filling of a grid half as fine stops within
/// about 0.1 % of the relief. Throws InputError when all is hole.
Grid fill_nodata(const Grid& heights, const Mask& nodata);

}  // namespace fumon
