#pragma once

#include <filesystem>
#include <string>

#include "base/grid.h"
#include "foreign/quantity.h"

namespace fumon {

/// Whether a text file is numbers alone, without the header of a grid.
bool is_bare_matrix(const std::filesystem::path& file);

/// A field as a file holds it.
struct RasterFile {
    Grid values;  ///< row 0 southernmost; NaN where there are none
    WorldScale scale;
    std::string note;
};

/// Any terrain file, or a matrix of numbers in text alone, a row a line, the northernmost first.
/// Numbers become those of a quantity's unit where the file names theirs. `cell_size`: metres, of a
/// file that does not say its own; 0: unknown. Throws InputError.
RasterFile read_raster_file(const std::filesystem::path& file, const std::string& variable,
                            Quantity quantity, double cell_size);

}  // namespace fumon
