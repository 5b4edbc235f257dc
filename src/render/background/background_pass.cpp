#include "render/background/background_pass.h"

#include "gl/functions.h"
#include "render/samples/pixel_class_vectors.h"

namespace fumon {

std::optional<RowOrder> BackgroundPass::draw(const TileFrame& tile, const gl::RenderTarget& target,
                                             const StreamerLayer* streamers, bool keep) {
    // Nothing in it changes while the camera stands still.
    keep = keep && tile.plan.tiles.size() == 1 && streamers == nullptr;
    if (keep && kept_whole_ && kept_from_ == tile.camera) return std::nullopt;
    gl::functions().BindVertexArray(no_attributes_.name());
    layer_.draw_clouds(tile.light, tile.camera, tile.tile);
    target.bind();
    if (streamers != nullptr) streamers->bind();
    gl::functions().Disable(GL_DEPTH_TEST);
    layer_.draw(tile.light, tile.camera, tile.tile, RowOrder::downward);
    kept_whole_ = true;
    if (keep) kept_from_ = tile.camera;
    return RowOrder::downward;
}

std::optional<RowOrder> BackgroundPass::draw_uncovered(
    const TileFrame& tile, const gl::RenderTarget& target, const StreamerLayer* streamers,
    const std::optional<std::vector<Tile>>& parts) {
    const bool first_of_several = several_ && !kept_from_ && streamers == nullptr;
    if (tile.plan.tiles.size() == 1 && streamers == nullptr &&
        (first_of_several || kept_from_ == tile.camera))
        return draw(tile, target, streamers, true);
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(no_attributes_.name());
    layer_.draw_clouds(tile.light, tile.camera, tile.tile);
    target.bind();
    if (streamers != nullptr) streamers->bind();
    gl.Disable(GL_DEPTH_TEST);
    if (parts) {
        layer_.draw(tile.light, tile.camera, tile.tile, *parts);
    } else {
        gl.Enable(GL_STENCIL_TEST);
        gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        gl.StencilFunc(GL_GREATER, pixel_class_vectors::first_single_surface,
                       0xFF);  // than the pixel's kind
        layer_.draw(tile.light, tile.camera, tile.tile, RowOrder::upward);
        gl.Disable(GL_STENCIL_TEST);
    }
    kept_whole_ = false;
    kept_from_ = tile.camera;
    return RowOrder::upward;
}

void BackgroundPass::draw_behind_samples(const TileFrame& tile, const gl::RenderTarget& samples,
                                         const StreamerLayer* streamers) {
    const gl::Functions& gl = gl::functions();
    // The target's own rows and columns, of which the tile's are a part.
    const glm::ivec2 corner = tile.target_corner();
    const int below = tile.picture().y - tile.plan.target_height;
    const Tile whole{corner.x, below - corner.y, tile.plan.target_width, tile.plan.target_height};
    gl.BindVertexArray(no_attributes_.name());
    layer_.draw_clouds(tile.light, tile.camera, whole);
    samples.bind();
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.StencilFunc(GL_EQUAL, 0, 0xFF);
    if (streamers != nullptr) streamers->bind();
    layer_.draw(tile.light, tile.camera, whole, RowOrder::upward, tile.first_in_target());
    gl.Disable(GL_STENCIL_TEST);
}

}  // namespace fumon
