#pragma once

#include "base/snapshot_lookup.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/bed_shading.h"
#include "render/light/light.h"
#include "render/light/repeated_light.h"
#include "render/terrain_layer.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// A periodic bed repeated to the horizon: a fan of rays and rings around the camera, raised by the
/// bed's heights. Wind ripples and tongues of avalanches, for which the grid is too coarse, are
/// drawn where they are seen.
class WorldLayer {
  public:
    WorldLayer(const View& view, const Block& block, const Snapshot& first, int refinement,
               const gl::Constants& fixed);

    void set_bed(const Snapshot& snapshot, const RepeatedLight& light);

    /// Of the bed, block lengths.
    [[nodiscard]] const Field<float>& heights() const { return z_; }

    /// Notes in the bound target (four floats a sample, depths and stencils) how far from the eye
    /// the ground is that each sample sees; colours are found later, once a sample.
    void draw_seen(const Camera& camera, const TileSamples& tile) const;
    /// Colours the samples of the bound target, which has the stencils of draw_seen().
    void colour_seen(const gl::Texture2D& seen, const BedShading& shading, const Light& light,
                     const Camera& camera, const TileSamples& tile) const;

    /// World to clip coordinates of places as offsets from the eye, as draw_seen() draws.
    [[nodiscard]] glm::mat4 clip_from_eye(const Camera& camera) const;
    /// By how much the planet sinks at a distance of 1, block lengths.
    [[nodiscard]] float curvature() const;

  private:
    /// The fan of a camera: radii in block lengths.
    struct Fan {
        glm::dvec2 heading{0.0, 1.0};  ///< of its middle, unit vector
        double half_angle = 0.0;
        double nearest = 0.0;
        double farthest = 0.0;
    };

    void build();
    [[nodiscard]] double ground_under(const glm::dvec3& eye) const;
    [[nodiscard]] Fan fan_of(const Camera& camera) const;
    [[nodiscard]] static glm::mat4 clip_from_eye(const Camera& camera, const Fan& fan);
    void set_fan(const gl::Program& program, const Fan& fan, const Camera& camera,
                 const TileSamples& tile) const;
    void set_eye(const gl::Program& program, const Camera& camera) const;
    void set_detail(const gl::Program& program, const Camera& camera,
                    const TileSamples& tile) const;
    /// Rings before this one show ripples.
    [[nodiscard]] int first_far_ring(const Fan& fan, const Camera& camera,
                                     const TileSamples& tile) const;
    void draw_rings(int first, int last) const;

    View view_;
    Block block_;
    float cell_;            ///< of the drawn bed, block lengths
    double ripple_length_;  ///< block lengths
    Field<float> z_;        ///< of the bed
    double highest_ = 0.0;
    std::int64_t step_ = 0;
    Way way_;
    gl::Program seen_program_;
    gl::Program near_colours_;
    gl::Program far_colours_;
    gl::Texture2D heights_;
    gl::Texture2D wind_;
    gl::VertexArray array_;
    gl::VertexArray no_attributes_;
    gl::Buffer places_;
    gl::Buffer triangles_;
    int rays_ = 0;
};

}  // namespace fumon
