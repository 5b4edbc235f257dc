#pragma once

#include <vector>

#include "base/snapshot.h"
#include "scene/view/layers.h"

namespace fumon {

/// A stream from its source, or from where one of higher order begins, down to where it ends.
struct StreamLine {
    std::vector<BedPlace> places;  ///< cell by cell
    int order = 1;                 ///< of Strahler (1957)
};

/// The streams over a snapshot's ground (see channel_network()) through which at least
/// `channel_area` drains, m² or cells of a bed without metres; 0: a 500th of the ground. In the
/// order of their last cells, from the outlets upward. Lines are smoothed within a cell, so that
/// their eight directions do not show.
std::vector<StreamLine> stream_lines(const Snapshot& snapshot, double channel_area);

}  // namespace fumon
