#pragma once

#include "base/snapshot.h"

namespace fumon {

/// Throws Error "NAME became nan at cell (x, y), step N (time), …" for the first value that is not
/// finite or beyond what ground has (largest_height, largest_field_value): of the bed, then of the
/// other fields in their order, then of the section's, whose places are nodes (i, k). The time is
/// told where it is not counted in steps.
void check_finite(const Snapshot& snapshot);

}  // namespace fumon
