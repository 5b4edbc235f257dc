#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/grid.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/bed/bed_shading.h"
#include "render/frame/ground_transform.h"
#include "render/frame/tile_samples.h"
#include "render/life/footprints.h"
#include "render/light/light.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/world/world_layer.h"
#include "scene/scene.h"

namespace fumon {

/// Throws KeyError where tracks cannot be shown: as check_shows_scale() says, where a track is not
/// a line of points on the bed or is shorter than a step, or where all together are too long.
void check_tracks(const View& view, const Snapshot& first);

/// Prints in the sand: relief too fine for the bed's cells, which the sun and the sky light. Only
/// samples of the ground near a print are looked at; the ground itself stays as it is.
class TrackLayer {
  public:
    /// Throws as check_tracks().
    TrackLayer(const View& view, const Block& block, const Snapshot& first,
               const gl::Constants& fixed);

    /// `z`: the ground of a frame as it is drawn, block lengths, by the block of its maps, on
    /// `on`; of a block `water`, if given, is how deep it is covered:
    /// no print is seen under water.
    void set_bed(const Field<float>& z, const Block& ground, bool repeats,
                 const GroundTransform& on, const Field<float>* water);

    /// Draws the visible prints over the ground's colours in the bound target, by the samples of
    /// `visibility`: on endless ground, where `world` is given, or on a block.
    void draw(const gl::Texture2D& visibility, const WorldLayer* world,
              const GroundTransform& ground, const BedShading& shading, const Light& light,
              const Camera& camera, const TileSamples& tile) const;

  private:
    /// What one print gives to the box around it.
    struct Instance {
        glm::vec4 root;   ///< from the anchor, height, block lengths; unevenness
        glm::vec4 form;   ///< heading, 1 for the right foot or −1, metres deep
        glm::vec4 slope;  ///< rise of the ground east and north, and whether the print is shown
    };

    View view_;
    Block block_;
    std::vector<Footprint> prints_;
    std::vector<glm::dvec2> positions_;  ///< theirs, block lengths from the bed's middle
    gl::Program program_;
    gl::VertexArray array_;
    gl::DynamicBuffer instances_{GL_ARRAY_BUFFER};
    std::optional<gl::Texture2D> heights_;
    glm::dvec2 anchor_{0.0};  ///< the first print's place, from which others count
};

}  // namespace fumon
