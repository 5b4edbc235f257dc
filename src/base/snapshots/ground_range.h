#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/grid.h"
#include "base/snapshot.h"

namespace fumon {

/// What is out of the ranges of base/limits.h in a bed of model heights and in its scale, in one
/// line with the first cell that is ("the height of cell (3, 0) is 1e+300 m; …"), or empty: a
/// height beyond ±`largest_height` metres or not finite, also in cells without data, and cells or a
/// unit of height of a size that no ground has.
std::string beyond_ground(const Grid& bed, const WorldScale& scale);

/// The same of all that a snapshot holds: its bed and scale, its time, and its other fields, whose
/// values are finite and at most `largest_field_value` in size but for cells without data.
std::string beyond_ground(const Snapshot& snapshot);

/// Whether a field of this name may lack a value (NaN) in some cells: all but those that are drawn
/// as water, sand, rock and plants.
bool may_have_gaps(std::string_view field);

/// The cell of the first value that is not finite or larger in size than `most`, or the number of
/// values where there is none.
std::size_t first_beyond(const Grid& field, double most);

}  // namespace fumon
