#pragma once

#include <cstddef>

#include "files/text_source.h"

namespace fumon {

/// The header of an ESRI ASCII grid, in the file's own unit of length (metres or degrees).
struct EsriHeader {
    int nx = 0;  ///< ncols
    int ny = 0;  ///< nrows
    double dx = 0.0;
    double dy = 0.0;
    double west = 0.0;   ///< x of the grid's western edge
    double south = 0.0;  ///< y of the grid's southern edge
    double nodata = -9999.0;
    std::size_t end = 0;  ///< offset of the first height
};

/// Reads the header as real files have it: words in any case and order, corner or centre
/// registration (a missing origin is 0), `cellsize` or `dx` and `dy`, NODATA_value (or NODATA) or
/// none, a byte-order mark, LF, CRLF or CR. Source of the format: Esri, "ASCII raster format"; the
/// dx and dy lines are GDAL's. A header may have its numbers first, as GeoClaw writes it ("20 mx";
/// mx, my, xlower, ylower, xll, yll, of which the latter four are the first point, a cell's
/// centre). Source: Clawpack's documentation, "Topography data", topotypes 2 and 3. Throws
/// InputError "file:line: what; remedy" for a missing, doubled, unknown or contradictory word, for
/// a value that is no number or out of range, and for more than `largest_grid_cells` cells.
EsriHeader read_esri_header(const TextSource& source);

}  // namespace fumon
