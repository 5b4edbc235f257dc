#pragma once

#include <optional>
#include <string>

#include "figure/panels/ground_arrow.h"
#include "scene/scene.h"

namespace fumon {

/// The look of a panel's picture: that of its scene, with what the panel says.
LookSettings look_of(const PanelSettings& panel, const Scene& scene);

/// The colouring that shows a field; nothing where it is none of the renderer's.
std::optional<Colouring> colouring_of(const std::string& field);

/// What the arrow in the corner of a map or view shows; nothing where there is none.
std::optional<GroundDirection> direction_of(PanelArrow arrow, const Snapshot& first);

/// The row that a profile or time-space panel shows; none: the mean over all.
std::optional<int> row_of(const PanelSettings& panel, const Grid& bed);

/// The heading of the places along x in the data behind a panel.
const char* x_column(bool in_metres);

}  // namespace fumon
