#pragma once

#include <optional>
#include <vector>

#include "gl/texture.h"
#include "render/background/background_layer.h"
#include "render/frame/tile_frame.h"
#include "render/streamers/streamer_layer.h"
#include "render/view/camera.h"

namespace fumon {

/// Draws what surrounds the ground, where it is needed and has not been drawn before. Each draw()
/// returns in which order the target then holds the tile's rows, or nothing where it drew nothing,
/// since the last tile's background is this one's too.
class BackgroundPass {
  public:
    /// See BackgroundLayer; `several`: pictures of one camera may follow.
    BackgroundPass(const View& view, const Block& block, const Light& light, const FloorMap& floor,
                   const gl::Constants& fixed, PixelFormat wanted, bool several)
        : layer_(view, block, light, floor, fixed, wanted), several_(several) {}

    /// For the light of another sun.
    void set_floor(const FloorMap& floor) { layer_.set_floor(floor); }
    /// Before a picture in another light.
    void forget() { kept_from_.reset(); }
    /// Before a picture of a film, whose camera moves.
    void expect_other_cameras() { several_ = false; }
    /// The share of the sun's light that clouds before its disc let through to the camera.
    [[nodiscard]] float sun_through_clouds(const Light& light, const Camera& camera) {
        return layer_.sun_through_clouds(light, camera);
    }

    /// All of a tile. `keep`: for the next picture of this camera, where nothing in it changes.
    std::optional<RowOrder> draw(const TileFrame& tile, const gl::RenderTarget& target,
                                 const StreamerLayer* streamers, bool keep);
    /// Where the pixels of endless ground, whose kinds are the target's stencils, do not see that
    /// ground alone; or, of a block, in some `parts` of the tile. The whole of it, for the next
    /// ones, of the first of several pictures and where the camera is the last one's.
    std::optional<RowOrder> draw_uncovered(const TileFrame& tile, const gl::RenderTarget& target,
                                           const StreamerLayer* streamers,
                                           const std::optional<std::vector<Tile>>& parts);
    /// Into a target of samples, where stencils say that no ground is seen.
    void draw_behind_samples(const TileFrame& tile, const gl::RenderTarget& samples,
                             const StreamerLayer* streamers);

  private:
    BackgroundLayer layer_;
    gl::VertexArray no_attributes_;
    bool several_;
    std::optional<Camera> kept_from_;  // of the light of now, for the one tile
    bool kept_whole_ = false;          // also where the ground covers it
};

}  // namespace fumon
