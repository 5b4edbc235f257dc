#pragma once

#include <cstdint>
#include <optional>

#include "base/snapshot.h"
#include "gl/program.h"
#include "render/colour/pixel_format.h"
#include "render/light/floor_map.h"
#include "render/renderer.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/drawn_origin.h"
#include "render/view/surrounding_plain.h"
#include "render/view/tile_warp.h"
#include "render/view/tiles.h"
#include "scene/scene.h"

namespace fumon {

class WorkerPool;

/// What all pictures of a renderer share: its view, its first snapshot, and what follows from
/// these.
struct FrameSetting {
    /// As Renderer().
    FrameSetting(const View& view_, const Snapshot& first_, std::int64_t last_step_,
                 const RenderLimits& limits, PixelFormat wanted_, WorkerPool& pool);

    /// The first snapshot as it is shown.
    [[nodiscard]] static Snapshot shown_first(const Snapshot& first, const View& view);
    /// The first snapshot as the ground's maps hold it.
    [[nodiscard]] const Snapshot& first_ground() const {
        return first_in_plain ? *first_in_plain : first;
    }
    [[nodiscard]] Camera camera_at(std::int64_t step) const;
    [[nodiscard]] bool endless() const { return view.look.ground == Ground::endless; }
    [[nodiscard]] bool open() const { return view.look.background == Background::transparent; }
    [[nodiscard]] bool lens() const { return view.camera.has_lens(); }
    /// Whether vector code, not OpenGL, rasterises the visibility of endless ground.
    [[nodiscard]] bool rasterises_in_buffer() const;
    /// Whether its pixels that see one ground are shaded as wholes.
    [[nodiscard]] bool shades_single_surface_pixels() const {
        return rasterises_in_buffer() && plan.factor > 1;
    }
    /// What lies dark on the plain around the block; nothing where no plain is drawn.
    [[nodiscard]] FloorMap floor(WorkerPool& pool) const;
    /// Samples along the picture's longer side.
    [[nodiscard]] int samples_across() const;

    View view;  ///< whose sun is that of the last picture
    Snapshot first;
    std::int64_t last_step;
    PixelFormat wanted;
    PixelFormat kind;  ///< in which samples are drawn
    Block block;
    std::optional<SurroundingPlain>
        plain;  ///< of endless ground that is not the bed's own repetition
    std::optional<Snapshot> first_in_plain;
    Block ground;  ///< the block of its maps
    bool water;    ///< whether it is drawn
    int refinement;
    DrawnOrigin origin;  ///< of endless ground
    TileWarp copies;     ///< likewise
    TilePlan plan;
};

}  // namespace fumon
