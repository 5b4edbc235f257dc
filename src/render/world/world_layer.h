#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/snapshot_lookup.h"
#include "gl/dynamic_buffer.h"
#include "gl/mipmaps.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/bed/bed_shading.h"
#include "render/frame/frame_targets.h"
#include "render/frame/tile_frame.h"
#include "render/frame/tile_samples.h"
#include "render/ground/ground_fan.h"
#include "render/ground/height_pyramid.h"
#include "render/ground/skyline.h"
#include "render/light/light.h"
#include "render/light/repeated_light.h"
#include "render/samples/packed_samples.h"
#include "render/samples/visibility_buffer.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/drawn_origin.h"
#include "render/view/tile_warp.h"
#include "scene/scene.h"

namespace fumon {

class StreamerLayer;
class WorkerPool;

/// A periodic bed repeated to the horizon: a fan of rays and rings around the camera, raised by the
/// bed's heights. Wind ripples and tongues of avalanches, for which the grid is too coarse, are
/// drawn where they are seen.
class WorldLayer {
  public:
    /// Light, heights and shading are of the bed as it is drawn from `origin` on. `mipmaps`
    /// outlives it. `has_visibility_buffer`: visibility is rasterised by rasterise_buffer(), not
    /// by rasterise(), and the constant visibility_in_buffer is 1.
    WorldLayer(const View& view, const Block& block, const Snapshot& first, int refinement,
               const DrawnOrigin& origin, const TileWarp& copies, const gl::Constants& fixed,
               const gl::MipmapMaker& mipmaps, bool has_visibility_buffer);

    /// `heights`: of the bed, block lengths.
    void set_bed(const Snapshot& snapshot, const RepeatedLight& light,
                 std::shared_ptr<const HeightPyramid> heights);

    /// The ground of a bed of those heights as a camera sees it. `samples_high`: of the whole
    /// picture. Asks OpenGL for nothing, and reads nothing that drawing changes.
    [[nodiscard]] VisibleGround visible_ground(const Camera& camera, double samples_high,
                                               const HeightPyramid& heights,
                                               WorkerPool& pool) const;
    /// z of ground of those heights at a position from the bed's middle; likewise.
    [[nodiscard]] double ground_at(const glm::dvec2& position, const HeightPyramid& heights) const;
    /// Takes that as the ground to draw, for as long as it lives.
    void look_at(const VisibleGround& ground);

    /// Sets the blown sand in front of the ground, or null, and the sample of the tile's lower
    /// left pixel.
    void set_streamers(const StreamerLayer* streamers, glm::ivec2 first) {
        streamers_ = streamers;
        first_of_tile_ = first;
    }

    /// Where a tile's pixels lie among its samples.
    [[nodiscard]] PixelSamples pixel_samples(const TileFrame& tile) const;

    /// Rasterises visibility without OpenGL, by GroundRasteriser: for pixels that may show ground
    /// and for the samples beside them. Pixels of several samples are also classified for
    /// shading.
    void rasterise_buffer(const TileFrame& tile);
    /// Writes that into the bound and cleared target as rasterise() would.
    void copy_visibility(const TileFrame& tile) const;
    [[nodiscard]] bool has_visibility_buffer() const { return visibility_.has_value(); }
    /// How pixels are shaded, after rasterise_buffer().
    [[nodiscard]] const PixelClasses& kinds() const { return visibility_->kinds(); }

    /// Writes into the bound target (four floats a sample, depths and stencils) how far from the
    /// eye the ground is that each sample sees. `mark_far`: lengths on far ground get a minus sign.
    void rasterise(const Camera& camera, const TileSamples& tile, bool mark_far = true) const;
    /// See rows_below_skyline(): of a picture of so many rows of pixels.
    [[nodiscard]] int ground_rows(const Camera& camera, int rows) const {
        return rows_below_skyline(ground_->mesh.skyline, camera, rows);
    }
    /// In what follows `visibility` is what rasterise() left; not needed after rasterise_buffer().
    ///
    /// Shades, after rasterise_buffer(), the pixels all of whose samples see the same ground into
    /// the target of pixels, whose stencils become their kinds().
    void shade_pixels(const FrameTargets& targets, const BedShading& shading,
                      const TileFrame& tile) const;
    /// Gives the samples of the bound target the colours of their pixels, and the stencil 0, but
    /// not where pixels are transparent.
    void upsample_pixels(const gl::Texture2D& pixels, const TileFrame& tile) const;
    /// Shades the samples of the bound target that have the stencils of rasterise().
    void shade_samples(const gl::Texture2D& visibility, const BedShading& shading,
                       const TileFrame& tile) const;
    /// Shades the samples of the pixels that shade_pixels(), whose target is bound, has left.
    void shade_packed_samples(const gl::Texture2D* visibility, PackedSamples& samples,
                              const BedShading& shading, const TileFrame& tile) const;

    /// Sets what a program that includes world/world.glsl needs to colour samples, but not pixels.
    void bind(const gl::Program& program, const gl::Texture2D* visibility,
              const BedShading& shading, const Light& light, const Camera& camera) const;

    /// World to clip coordinates of points as offsets from the eye, as rasterise() draws.
    [[nodiscard]] glm::mat4 clip_from_eye(const Camera& camera) const;
    /// By how much the planet sinks at a distance of 1, block lengths.
    [[nodiscard]] float curvature() const;
    /// From the middle of what TileWarp leaves as it is, periods.
    [[nodiscard]] glm::dvec2 eye_from_middle(const Camera& camera) const;

  private:
    static constexpr int visibility_unit = 10;  // of textures
    static constexpr GLint near_stencil = 1;
    static constexpr GLint far_stencil = 2;
    // Of ground that is true to nature: on none that falls less sand slid.
    static constexpr double least_slip_slope = 0.3;
    static constexpr glm::vec2 slip_size{12.0F, 36.0F};       // metres
    static constexpr double wander_features_per_side = 64.0;  // of the texture

    /// What shades near and far ground.
    struct GroundPrograms {
        GroundPrograms(const gl::Constants& fixed, bool wet);

        gl::Program near;
        gl::Program far;
    };
    struct PixelPrograms {
        gl::Program smooth;  ///< of near ground, plain ones
        gl::Program slid;
        GroundPrograms others;
    };

    [[nodiscard]] static gl::Program near_program(gl::Constants fixed, bool wet);
    [[nodiscard]] static gl::Program far_program(gl::Constants fixed, bool wet);
    void build();
    void draw_relief();
    void draw_wander();
    void fill(const gl::RenderTarget& target) const;
    void draw_slip_face();
    [[nodiscard]] double ground_under(const Camera& camera, const HeightPyramid& heights) const;
    [[nodiscard]] GroundFan fan_of(const Camera& camera, const HeightPyramid& heights) const;
    /// At the offsets' origin, with depths that hold the fan.
    [[nodiscard]] static Camera at_origin(const Camera& camera, const GroundFan& fan);
    void bind_visibility(const gl::Program& program, const gl::Texture2D* visibility) const;
    void bind_map_levels(const BedShading& shading, bool alone) const;
    void upload_mesh() const;
    [[nodiscard]] pixel_class_vectors::ClassBounds pixel_bounds(const Camera& camera) const;
    /// From the middle of the drawn bed, at most half of it away along each side.
    [[nodiscard]] glm::dvec3 reduced_eye(const Camera& camera) const;
    void set_eye(const gl::Program& program, const Camera& camera) const;
    void set_detail(const gl::Program& program, const Camera& camera) const;

    const gl::MipmapMaker& mipmaps_;
    View view_;
    Block block_;
    float cell_;                ///< of the drawn bed, block lengths
    double ripple_wavelength_;  ///< block lengths
    DrawnOrigin origin_;
    TileWarp copies_;
    bool wet_;  ///< whether the bed's water is drawn
    std::shared_ptr<const HeightPyramid> heights_;
    AvalancheCells slid_;
    std::int64_t step_ = 0;
    HorizontalDirection way_;
    double sample_angle_ = 0.0;  ///< between two samples in the middle of the picture
    double near_limit_ = 0.0;    ///< a ripple is not seen beyond, block lengths
    gl::Program visibility_program_;
    std::optional<gl::Program> copy_program_;  // after rasterise_buffer()
    gl::Program upsample_program_;
    std::optional<PixelPrograms> pixel_programs_;  // after rasterise_buffer()
    GroundPrograms sample_programs_;
    GroundPrograms packed_programs_;
    gl::Texture2D surface_;
    gl::RenderTarget relief_;
    gl::RenderTarget wander_;
    gl::RenderTarget slip_;
    gl::VertexArray array_;
    gl::VertexArray no_attributes_;
    mutable gl::DynamicBuffer positions_{GL_ARRAY_BUFFER};
    mutable gl::DynamicBuffer triangles_{GL_ELEMENT_ARRAY_BUFFER};
    mutable bool uploaded_ = false;  // with the ground of now
    std::optional<VisibilityBuffer> visibility_;
    const VisibleGround* ground_ = nullptr;
    const StreamerLayer* streamers_ = nullptr;
    glm::ivec2 first_of_tile_{0};
};

}  // namespace fumon
