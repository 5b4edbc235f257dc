#pragma once

#include <optional>
#include <string>

#include "files/terrain/terrain_file.h"
#include "files/terrain/terrain_format.h"
#include "files/text_source.h"

namespace fumon {

/// Reads an ESRI ASCII grid: its header (see esri_header.h), then ncols × nrows heights, the
/// northernmost row first, however they are broken into lines. Cells with the no-data value or
/// "nan" are no-data (a no-data value of 1e30 or more in size is compared in single precision, as
/// programs that print float cells round it differently). Degrees become metres (see geographic.h).
/// Throws InputError "file:line: what is wrong; what would be right".
Terrain parse_esri_ascii(const TextSource& source,
                         const std::optional<TerrainWindow>& window = std::nullopt);

/// Writes heights (metres or model heights) as an ESRI ASCII grid, north row first, with the fewest
/// digits that read back as the same double (17 at most). No-data cells become −9999, or −99999 and
/// so on where that is a height. dx ≠ dy is written as dx and dy lines, as GDAL does; both are
/// greater than 0.
std::string esri_ascii(const Grid& heights, const Mask& nodata, double dx, double dy,
                       double west = 0.0, double south = 0.0);

/// ESRI ASCII grids as a terrain format, every file that is no other. The coordinate reference
/// system stands in a .prj file beside a grid, where there is one. Grids are written in their own
/// coordinates where they would be read back as what they are (metres, or degrees that
/// is_geographic() tells), else in metres from (0, 0).
TerrainFormat esri_ascii_format();

/// −9999, or the first of −99999, −999999 … that is no cell's height.
double unused_height(const Grid& heights);

}  // namespace fumon
