#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "base/snapshot.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/bed/bed_shading.h"
#include "render/block/terrain_layer.h"
#include "render/colour/pixel_format.h"
#include "render/frame/tile_samples.h"
#include "render/light/light.h"
#include "render/samples/g_buffer.h"
#include "render/view/camera.h"
#include "render/view/tiles.h"
#include "scene/scene.h"

namespace fumon {

/// Colours of the surface of a block with water by the pixels of a tile, of
/// shades_water_by_pixel().
class WaterPixels {
  public:
    /// `fixed`: see fixed_uniforms(). `alike`: each pixel by the program that shades any, at some
    /// cost, but for those that see two points.
    WaterPixels(const TilePlan& plan, const gl::Constants& fixed, PixelFormat kind,
                bool alike = false);

    /// Between the samples of a pixel: up to there, in cells of the maps or in widths of a pixel,
    /// one point stands for all.
    static constexpr float split_distance_cells = 1.25F;
    static constexpr float split_distance_pixels = 14.0F;

    /// A bed that both have taken, in this light.
    struct Shaded {
        const BedShading& shading;
        const TerrainLayer& terrain;
        const Light& light;
        const Camera& camera;
    };
    /// Shades, into a target of its own, what the samples `visibility` (see
    /// block/visibility_surface.frag.glsl) show; pixels begin at the sample `offset`, see
    /// pixel_offset(). Needs a bound vertex array without attributes.
    void shade(const gl::Texture2D& visibility, const glm::ivec2& offset, const Shaded& shaded,
               const TileSamples& tile);

    /// The same of points that are known, of pixels of display_8, and reads their colours.
    void shade(GBuffer& known, const Shaded& shaded);

    /// Whether all kinds are shaded as if they might show anything.
    [[nodiscard]] bool alike() const { return alike_; }

    /// One texel to a pixel: what BedShading::colours() has for a point.
    [[nodiscard]] const gl::Texture2D& colours() const { return target_.colour(); }

  private:
    int factor_;
    bool alike_;
    gl::Constants fixed_;
    /// Of samples in a texture, made as it is needed.
    struct BySamples {
        gl::Program kinds;
        gl::Program split;
    };
    const BySamples& by_samples();
    /// Of points that are known.
    struct ByPositions {
        gl::Program depths;
        gl::Texture2D kinds;
    };
    const ByPositions& by_positions();
    /// Draws what passes a test of the depth.
    void draw(const gl::Program& program, GLenum passes, double depth, const Shaded& shaded);
    void begin_shading();
    static void end_shading();
    std::optional<BySamples> by_samples_;
    std::optional<ByPositions> by_positions_;
    gl::Program dry_;
    gl::Program thin_;
    gl::Program deep_;
    gl::DepthBuffer depths_;  ///< separates kinds of pixels
    gl::RenderTarget positions_;
    gl::RenderTarget target_;
};

/// Where the first pixel's samples begin, from the target's lower left corner: at most 0, so that
/// pixels lie as those of the tile whose first sample is `first`.
glm::ivec2 pixel_offset(const glm::ivec2& first, int factor);

}  // namespace fumon
