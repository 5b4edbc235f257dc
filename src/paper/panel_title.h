#pragma once

#include <string>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// What a panel's title may name: {step}, {time} of a snapshot, {time:h} in a unit of one's own,
/// and the keys of its scene.
std::string panel_title(const PanelSettings& settings, const Scene& scene,
                        const Snapshot* snapshot);

}  // namespace fumon
