#pragma once

#include <array>
#include <cstdint>

#include "base/grid.h"
#include "base/snapshot.h"
#include "gl/mipmaps.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/water.h"
#include "scene/scene.h"

namespace fumon {

/// Whether the ground of a block with water is shaded for each pixel that shows it, so that it is
/// as sharp near the camera as far away and has no size of its own that a film could see change.
/// Maps, whose points are all as large, and views through a lens, which look at shaded ground many
/// times, have it as a texture over the bed instead.
bool shades_water_by_pixel(const View& view, const Snapshot& first);

/// What shaders/bed/water.glsl and shaders/bed/soil.glsl need to know of a snapshot's water and the
/// ground that it works on.
class WaterShading {
  public:
    /// For a display bed of nx × ny cells, `refinement` to each of the grid's along both axes.
    /// `mipmaps`, which outlives it, where cells are seen that are smaller than a pixel, or null.
    WaterShading(const View& view, const Block& block, int nx, int ny, int refinement,
                 const gl::MipmapMaker* mipmaps);

    /// Takes the water of a snapshot, and the change of the bed since `first`. `values`: see
    /// palette_coordinates().
    void upload(const Snapshot& snapshot, const Snapshot& first, const DisplayWater& water,
                const Field<std::uint16_t>& values);

    /// Sets the uniforms of the program in use; its textures take five units, and 14 for the rings
    /// of drops. `texel` is that of what is shaded, in block lengths; 0 where that is pixels.
    void set_uniforms(const gl::Program& program, const std::array<int, 5>& units,
                      const Camera& camera, double texel) const;

    /// The depth at which the bed is half hidden in what was taken last, metres.
    [[nodiscard]] double clarity() const { return clarity_; }

    /// Of all the water in what was taken last, as mean_turbidity() has it.
    [[nodiscard]] double turbidity() const { return turbidity_; }

  private:
    View view_;
    Block block_;
    int refinement_;
    const gl::MipmapMaker* mipmaps_;
    double cell_x_;  ///< of the display bed, block lengths
    double cell_y_;
    gl::Texture2D ground_;
    gl::Texture2D water_;
    gl::Texture2D surface_;
    gl::Texture2D streaks_;
    gl::Texture2D rills_;
    gl::Texture2D rings_;  ///< of drops, while it rains
    bool rains_ = false;
    float ring_mean_ = 0.0F;  ///< their mean square slope, in parts of max_ring_mean_square_slope
    double clarity_ = 1.0;
    double turbidity_ = 0.0;
    double usual_froude_ = 0.0;
    double closed_depth_ = 1.0;  ///< m
};

}  // namespace fumon
