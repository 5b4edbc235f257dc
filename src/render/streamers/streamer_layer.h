#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "gl/dynamic_buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/frame/ground_transform.h"
#include "render/frame/tile_samples.h"
#include "render/light/light.h"
#include "render/streamers/blown_sand.h"
#include "render/streamers/puffs.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/tiles.h"
#include "scene/scene.h"

namespace fumon {

/// The texture unit of what StreamerLayer draws, while ground and sky are coloured.
inline constexpr int streamer_unit = 14;

/// Blown sand over endless ground, as an absorbing and scattering medium. Transmittance and
/// scattered light of each pixel follow from the depths of its samples and are found before
/// shading, so that they act on ground and sky before any tone curve. Light is scattered once;
/// puffs shade neither each other nor the ground.
class StreamerLayer {
  public:
    StreamerLayer(const View& view, const Block& block, int width, int height);

    /// Chooses the puffs in a camera's view after `steps` moves, for all tiles of a picture.
    void choose(const BlownSand& sand, std::int64_t steps, const GroundTransform& ground,
                const Camera& camera);
    /// Rasterises what stands on the ground into the bound target, by a program with
    /// streamers/standing.frag.glsl: it is seen through what is blown before it.
    using Occluder = std::function<void(const TileSamples&)>;
    /// Draws it for a tile whose lower left pixel has the sample `first` of `visibility` there, see
    /// WorldLayer::rasterise(), of `factor`² samples a pixel.
    void draw(const gl::Texture2D& seen, glm::ivec2 first, int factor, const Tile& tile,
              const Light& light, const Camera& camera, std::span<const Occluder> occluders);
    /// Binds that to streamer_unit.
    void bind() const { target_.colour().bind(streamer_unit); }
    /// The same for a program that includes streamers/streamers.glsl, which is in use.
    void bind(const gl::Program& program) const;
    /// Likewise, and that includes life/standing.frag.glsl; samples as in draw().
    void bind(const gl::Program& program, glm::ivec2 first, int factor) const;

  private:
    void draw_noise();
    void draw_ground(const gl::Texture2D& seen, glm::ivec2 first, int factor,
                     const Camera& camera) const;

    void draw_occluders(std::span<const Occluder> occluders, const Tile& tile) const;

    View view_;
    Block block_;
    gl::Program program_;
    gl::Program ground_program_;
    gl::RenderTarget noise_;
    gl::RenderTarget ground_;
    gl::RenderTarget target_;
    gl::VertexArray array_;
    gl::VertexArray no_attributes_;
    gl::DynamicBuffer instances_{GL_ARRAY_BUFFER};
    glm::vec2 wind_{1.0F, 0.0F};
    glm::vec3 eye_position_{0.0F};
    float metre_ = 1.0F;
    std::vector<Puff> puffs_;
};

}  // namespace fumon
