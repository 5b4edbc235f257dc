#pragma once

#include <string>

#include "files/terrain/terrain_file.h"

namespace fumon {

/// Makes true metres of a terrain's cell sizes, which stand in the unit of its coordinate
/// reference system: for degrees at the middle latitude (see geographic.h); for a projected system
/// by its unit of length, and, where one of its lengths on the ground differs by more than 1 % at
/// the middle of the grid, by the scale of the projection there (Mercator at 40° stretches lengths
/// by 1.3). From .1 % on the note says it. A system overrules what the heights suggest (degrees or
/// metres). `unit_counts`: false for a file that gives its axes a unit of their own, in which the
/// cells stand already.
/// Nothing changes without a system, and for UTM inside its zone, whose scale is within .1 %.
/// Throws InputError "FILE: what; remedy" for a middle latitude beyond the poles, and where the
/// projection must be known but GDAL is not installed (Mercator).
void make_true_lengths(Terrain& terrain, bool unit_counts, const std::string& file);

}  // namespace fumon
