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
#include "render/light/light.h"
#include "render/streamers/streamer_layer.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// Throws KeyError where persons cannot stand: the bed has no metres or is too small, the view does
/// not show heights as they are or has no perspective, or a point is not on the bed.
void check_persons(const View& view, const Snapshot& first);

/// Where a person stands.
struct PersonPosition {
    glm::dvec2 at;          ///< block lengths from the bed's middle
    glm::vec2 turn;         ///< cosine and sine, anticlockwise from north
    std::size_t first = 0;  ///< index of its mesh among those of all persons
    int count = 0;          ///< of indices
    int casting = 0;        ///< of those before the details, which cast no shadow
};

/// Persons who stand on the bed as a scale, each with a shadow on the ground. The target's depths
/// are those of the ground; of its stencils the highest three bits are taken.
class PersonLayer {
  public:
    /// Throws as check_persons().
    PersonLayer(const View& view, const Block& block, const Snapshot& first,
                const gl::Constants& fixed);

    /// `z`: the ground of a frame as it is drawn, block lengths, by the block of its maps.
    void set_bed(const Field<float>& z, const Block& ground, bool repeats);
    /// What is seen through blown sand: see StreamerLayer::bind().
    void set_streamers(const StreamerLayer* streamers, glm::ivec2 first, int factor) {
        through_ = streamers;
        first_ = first;
        factor_ = factor;
    }
    void draw(const GroundTransform& ground, const BedShading& shading, const Light& light,
              const Camera& camera, const TileSamples& tile) const;
    /// As TerrainLayer::rasterise_positions(), by the program of
    /// position/person_position.vert.glsl.
    void rasterise_positions(const gl::Program& program, const GroundTransform& ground,
                             const Camera& camera, const TileSamples& tile) const;
    /// The same depths alone, as StreamerLayer::Occluder does.
    void rasterise_depths(const GroundTransform& ground, const Camera& camera,
                          const TileSamples& tile);

  private:
    void set_common(const gl::Program& program, const GroundTransform& ground,
                    const TileSamples& tile) const;
    void draw_one(const gl::Program& program, const PersonPosition& position, int count,
                  const GroundTransform& ground, const Camera& camera) const;
    void draw_shadows(const GroundTransform& ground, const BedShading& shading, const Light& light,
                      const Camera& camera, const TileSamples& tile) const;

    View view_;
    Block block_;
    std::vector<PersonPosition> positions_;
    gl::Program program_;
    gl::Program shadow_program_;
    std::optional<gl::Program> depth_program_;
    gl::VertexArray array_;
    gl::Buffer corners_;
    gl::Buffer indices_;
    std::optional<gl::Texture2D> heights_;
    Field<float> z_;
    glm::dvec2 extent_{1.0};  ///< of the ground's tile
    GroundTiles tiles_;
    bool repeats_ = false;
    const StreamerLayer* through_ = nullptr;
    glm::ivec2 first_{0};
    int factor_ = 1;
};

}  // namespace fumon
