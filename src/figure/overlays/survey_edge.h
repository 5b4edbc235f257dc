#pragma once

#include "base/snapshot.h"
#include "scene/view/layers.h"

namespace fumon {

/// How the line around a survey is drawn.
LayerSettings survey_edge_settings();

/// The line between a bed's cells and all that lies outside: its sides, and the edges of what is
/// masked. A staircase of masked cells is cut at its corners.
PlacedLayer survey_edge(const Snapshot& first);

}  // namespace fumon
