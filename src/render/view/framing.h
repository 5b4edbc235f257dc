#pragma once

#include <cstdint>

#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/tile_warp.h"
#include "scene/scene.h"

namespace fumon {

/// The block of a view, fixed by the run's first snapshot as it is shown.
Block framed_block(const View& view, const Snapshot& first);

/// Whether heights count from the mean of each frame's own bed: by look.datum, whose "auto" does so
/// under a model's water. The sea of look.sea_level stays where it is, so land sinks and rises.
bool counts_from_own_mean(const LookSettings& look, const Snapshot& first);

/// The block of one frame: heights count from the mean of the run's first bed (as it is shown) or,
/// by counts_from_own_mean(), from that of the frame's own bed.
Block block_of_frame(const Block& block, const LookSettings& look, const Snapshot& first,
                     const Snapshot& snapshot);

/// The camera of a view at a step of a run of `last_step` steps, over which it turns.
Camera camera_at_step(const View& view, const Block& block, std::int64_t step,
                      std::int64_t last_step);

/// A camera that stands at a point, raised where the ground of a frame has risen.
Camera above_ground(Camera camera, const Block& block, const Snapshot& snapshot,
                    const TileWarp& copies = {});

/// The view whose camera.at and camera.look_at count from the ground of a picture's snapshot, where
/// those of `view` count from that of the run's first, as all framing does: the same points, with
/// heights over the first bed. Both snapshots as they are shown.
View standing_on(View view, const Snapshot& first, const Snapshot& drawn);

/// Pixels that one length of the block spans across the picture at the block's middle.
double pixels_per_length(const Camera& camera, const View& view);

}  // namespace fumon
