#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/grid.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/bed/bed_shading.h"
#include "render/frame/ground_transform.h"
#include "render/frame/tile_samples.h"
#include "render/life/plant_meshes.h"
#include "render/life/plant_positions.h"
#include "render/light/light.h"
#include "render/streamers/streamer_layer.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/tile_warp.h"
#include "scene/scene.h"

namespace fumon {

/// Whether a view draws the plants of such beds.
bool draws_plants(const View& view, const Snapshot& first);

/// Plants, one by one, on a bed or on its repetitions: leaf by leaf near the camera; farther away
/// fewer and larger ones, as many as keep their share of what is seen (after Cook, Halstead, Planck
/// & Ryu 2007), down to a pixel's height. Beyond, the ground's own tint stands for them. Each casts
/// a soft shadow. The target's depths are those of the ground.
class PlantLayer {
  public:
    PlantLayer(const View& view, const Block& block, const gl::Constants& fixed);

    /// Of a frame: its plants and `z`, the ground as it is drawn, block lengths.
    void set_bed(const Snapshot& snapshot, const Field<float>& z, bool repeats);

    /// Chooses the plants that the camera sees, for all tiles of a picture.
    void choose(const GroundTransform& ground, const Camera& camera);
    /// What is seen through blown sand: see StreamerLayer::bind().
    void set_streamers(const StreamerLayer* streamers, glm::ivec2 first, int factor) {
        through_ = streamers;
        first_ = first;
        factor_ = factor;
    }
    void draw(const GroundTransform& ground, const BedShading& shading, const Light& light,
              const Camera& camera, const TileSamples& tile) const;
    /// As TerrainLayer::rasterise_positions(), by the program of
    /// position/plant_position.vert.glsl.
    void rasterise_positions(const gl::Program& leaves, const GroundTransform& ground,
                             const Camera& camera, const TileSamples& tile) const;
    /// The same depths alone, as StreamerLayer::Occluder does.
    void rasterise_depths(const GroundTransform& ground, const Camera& camera,
                          const TileSamples& tile);

  private:
    /// What one drawn plant gives to its corners.
    struct Instance {
        glm::vec4 root;  ///< and height
        glm::vec3 form;
    };
    static constexpr std::size_t kinds = 2;
    /// Of plants of like rank, which are drawn up to the same distance: a square of the bed each.
    struct Level {
        std::vector<std::vector<Plant>> squares;
    };
    struct Mesh {
        gl::VertexArray array;
        gl::Buffer corners;
        gl::Buffer instances;
        int count = 0;
        std::vector<Instance> chosen;
    };

    void build(Mesh& mesh, const std::vector<LeafVertex>& corners) const;
    /// `origin`: the south-western corner of their repetition of the bed.
    void choose_in(const std::vector<Plant>& plants, const glm::dvec2& origin,
                   const GroundTransform& ground, const Camera& camera);
    static void upload(const Mesh& mesh);
    [[nodiscard]] float ground_at(const glm::dvec2& position, const GroundTransform& ground) const;
    [[nodiscard]] bool in_frustum(const Camera& camera, const glm::dvec3& offset,
                                  double radius) const;
    void draw_shadows(const GroundTransform& ground, const BedShading& shading, const Light& light,
                      const Camera& camera, const TileSamples& tile) const;
    static void set_position(const gl::Program& program, const GroundTransform& ground,
                             const TileSamples& tile);
    void set_common(const gl::Program& program, const GroundTransform& ground,
                    const BedShading& shading, const Light& light, const Camera& camera,
                    const TileSamples& tile) const;

    View view_;
    Block block_;
    gl::Program leaf_program_;
    gl::Program shadow_program_;
    std::optional<gl::Program> depth_program_;
    std::array<std::array<Mesh, plant_details>, kinds> meshes_;
    std::array<Mesh, kinds> shadows_;
    std::optional<gl::Texture2D> heights_;
    Field<float> z_;
    bool repeats_ = false;
    std::vector<Level> levels_;
    float tallest_ = 0.0F;
    const StreamerLayer* through_ = nullptr;
    glm::ivec2 first_{0};
    int factor_ = 1;
};

}  // namespace fumon
