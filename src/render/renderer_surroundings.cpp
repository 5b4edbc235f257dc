#include "gl/functions.h"
#include "render/renderer_parts.h"

namespace fumon {

void Renderer::Parts::see_sun(const ReadyPicture& picture) {
    float seen = static_cast<float>(picture.sun_share);
    gl::functions().BindVertexArray(no_attributes.name());
    if (seen > 0.0F) seen *= background.sun_through_clouds(light, picture.pose.camera);
    if (seen != light.sun_seen) surroundings_from.reset();
    light.sun_seen = seen;
}

const gl::RenderTarget& Renderer::Parts::surroundings() {
    if (!surroundings_target) {
        const gl::DepthBuffer* depths = pixel_depths ? &*pixel_depths : nullptr;
        surroundings_target.emplace(plan.tiles.front().width, plan.tiles.front().height,
                                    nearest_layout(kind), depths);
    }
    return *surroundings_target;
}

void Renderer::Parts::draw_background(const Tile& tile, const Camera& camera, DeepPicture* deep) {
    // Nothing in it changes while the camera stands still.
    const bool kept = deep == nullptr && plan.tiles.size() == 1 && !streamers;
    if (kept && surroundings_whole && surroundings_from == camera) return;
    gl::functions().BindVertexArray(no_attributes.name());
    background.draw_clouds(light, camera, tile);
    surroundings().bind();
    if (streamers) streamers->bind();
    gl::functions().Disable(GL_DEPTH_TEST);
    background.draw(light, camera, tile, RowOrder::downward);
    if (deep != nullptr) {
        deep->read_background(tile);
    } else {
        bytes.read_background(tile, RowOrder::downward);
    }
    surroundings_whole = true;
    if (kept) surroundings_from = camera;
}

/// Where pixels see the ground alone nothing behind it counts.
void Renderer::Parts::draw_uncovered_background(const Tile& tile, const Camera& camera) {
    if (streamers && !pixels) {
        draw_background(tile, camera, nullptr);
        return;
    }
    const bool of_several = later_pictures && !surroundings_from && !streamers;
    if (plan.tiles.size() == 1 && !streamers && (of_several || surroundings_from == camera)) {
        draw_background(tile, camera, nullptr);
        return;
    }
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(no_attributes.name());
    background.draw_clouds(light, camera, tile);
    surroundings().bind();
    if (streamers) streamers->bind();
    if (world) {
        gl.Disable(GL_DEPTH_TEST);
        gl.Enable(GL_STENCIL_TEST);
        gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        gl.StencilFunc(GL_GREATER, pixel_vectors::first_whole, 0xFF);  // than the pixel's kind
        background.draw(light, camera, tile, RowOrder::upward);
        gl.Disable(GL_STENCIL_TEST);
    } else {
        gl.Disable(GL_DEPTH_TEST);
        background.draw(light, camera, tile, block_samples->open_parts());
    }
    bytes.read_background(tile, RowOrder::upward);
    surroundings_whole = false;
    surroundings_from = camera;
}

}  // namespace fumon
