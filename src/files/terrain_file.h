#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "terrain/grid.h"

namespace fumon {

/// Heights as a file holds them: metres, row 0 southernmost, with the cells that hold no data.
struct Terrain {
    Grid heights;     ///< metres; 0 in no-data cells
    Mask nodata;      ///< empty when every cell has data
    double dx = 0.0;  ///< metres; 0 when the file does not say (PNG)
    double dy = 0.0;
    std::string
        note;  ///< what was converted and the user should hear ("degrees to metres at …"); or empty
};

/// Reads an ESRI ASCII grid (.asc and any file that starts with a header word) or a 16-bit (or
/// 8-bit) grey PNG. `png_heights` are the metres of black and of white, {} for an ESRI grid. Cell
/// sizes in degrees are recognised and converted at the mid-latitude (dx ≠ dy), which `note` says.
/// Throws InputError "file:line: what is wrong; what would be right" for every malformed file.
Terrain read_terrain(const std::filesystem::path& file, const std::vector<double>& png_heights);

/// Writes heights (metres or model heights) as an ESRI ASCII grid with full precision (17 digits
/// where needed), north row first. dx ≠ dy is written as dx and dy lines, as GDAL does.
std::string esri_ascii(const Grid& heights, const Mask& nodata, double dx, double dy);

/// Fills no-data cells smoothly from their rim (the discrete Laplace equation on the holes),
/// leaving the others as they are. Returns the heights with no hole left; throws InputError when
/// all is hole.
Grid fill_nodata(const Grid& heights, const Mask& nodata);

}  // namespace fumon
