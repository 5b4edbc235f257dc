#pragma once

#include <glm/glm.hpp>
#include <utility>

#include "base/grid.h"
#include "base/snapshot.h"
#include "render/view/block.h"
#include "scene/view/view.h"

namespace fumon {

/// The range of heights over which natural sand goes from trough to crest.
std::pair<double, double> natural_range(const Snapshot& snapshot, const Block& block);

/// Palette places from which the grains of a pile begin to hide the board under it, and hide it;
/// 0 where no board is seen.
glm::vec2 bare_board(const Snapshot& snapshot, const LookSettings& look,
                     std::pair<double, double> range);

/// Palette places up to which ground between dunes is bare floor, and from which it is sand alone:
/// by the heights that a twentieth of the bed is below and above; and how far there is such ground
/// at all, since a bed that is nearly flat is all alike.
glm::vec3 floor_coordinates(const Field<float>& values, std::pair<double, double> range);

}  // namespace fumon
