#pragma once

#include <optional>
#include <string>
#include <utility>

#include "figure/panels/colour_bar.h"
#include "figure/panels/ground_arrow.h"
#include "render/colour/colouring.h"
#include "scene/scene.h"

namespace fumon {

/// The look of a panel's picture: that of its scene, with what the panel says.
LookSettings look_of(const PanelSettings& panel, const Scene& scene);

/// The colouring that shows a field; nothing where it is none of the renderer's.
std::optional<Colouring> colouring_of(const std::string& field);

/// What share of a panel's values may lie beyond the ends of its colours, where low and high are
/// words: `former` of a figure that earlier versions made.
RangeTails tails_of(const PanelSettings& panel, double previous = RangeTails{}.low);

/// Whether a figure of today shows a panel's colours, whose bar tells its ends and what lies beyond
/// them.
bool labels_range_ends(const PanelSettings& panel);

/// Notes in a picture's colours what their bar tells of these values.
void mark_range_ends(ColourScale& colours, const std::optional<std::pair<double, double>>& values);

/// The ends of a panel's colours for its caption: "Colours run from 0 m to 3 m; …".
std::string range_sentence(const ColourScale& colours,
                           const std::optional<std::pair<double, double>>& values);

/// Whether a compass stands in the corner of a map or view.
bool has_compass(PanelArrow arrow);

/// What the arrow in the corner of a map or view shows; nothing where there is none.
std::optional<GroundDirection> direction_of(PanelArrow arrow, const Snapshot& first);

/// The row that a profile or time-space panel shows; none: the mean over all.
std::optional<int> row_of(const PanelSettings& panel, const Grid& bed);

/// What tells that two maps of snapshots have the same axes.
std::string ground_range(const PanelSettings& panel, const Snapshot& snapshot);

/// Whether two beds have as many cells of the same size, so that one may be taken from the other.
bool same_ground(const Snapshot& a, const Snapshot& b);

/// The heading of the places along x in the data behind a panel.
const char* x_column(bool in_metres);

}  // namespace fumon
