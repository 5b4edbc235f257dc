#pragma once

#include <array>

#include "base/snapshot.h"
#include "gl/context.h"
#include "scene/scene.h"
#include "web/drawn_run.h"

namespace fumon {

class WorkerPool;

/// The colours of a block's sides, by the compass: east, north, west, south.
struct WallColours {
    std::array<PageColour, 4> ground{};
    std::array<PageColour, 4> water{};
};

/// Of each side the median of its pixels in a picture that looks at it. `surface`: the snapshot as
/// its surface is shown.
WallColours wall_colours(Scene scene, const Snapshot& first, const Snapshot& snapshot,
                         const Snapshot& surface, gl::Backend backend, WorkerPool& pool);

}  // namespace fumon
