#pragma once

#include <glm/glm.hpp>
#include <string>

#include "base/snapshot.h"
#include "render/view/block.h"
#include "scene/scene.h"

namespace fumon {

/// Throws KeyError for `key` where a view does not show true sizes of things on the bed: without
/// metres, perspective or the scenic look, or with exaggerated heights. `what` begins the message:
/// "a person on the bed".
void check_shows_scale(const View& view, const Block& block, const Snapshot& first,
                       const std::string& key, const std::string& what);

/// Converts a position of the key `key`, metres east and north of the bed's south-western corner,
/// to block lengths from the bed's middle. `said` ("person.0.at") begins the message. Throws
/// KeyError where the position is outside a bed that has an end, or outside the domain.
glm::dvec2 bed_position(const glm::dvec2& metres, const View& view, const Block& block,
                        const Snapshot& first, const std::string& key, const std::string& said);

}  // namespace fumon
