#pragma once

#include "files/terrain/terrain_file.h"
#include "files/text_source.h"

namespace fumon {

/// Reads an ESRI ASCII grid: its header (see esri_header.h), then ncols × nrows heights, the
/// northernmost row first, however they are broken into lines. Cells with the no-data value or
/// "nan" are no-data (a no-data value of 1e30 or more in size is compared in single precision, as
/// programs that print float cells round it differently). Degrees become metres (see geographic.h).
/// Throws InputError "file:line: what is wrong; what would be right".
Terrain parse_esri_ascii(const TextSource& source);

}  // namespace fumon
