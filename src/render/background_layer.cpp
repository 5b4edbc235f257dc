#include "render/background_layer.h"

#include "render/bed_shading.h"

namespace fumon {

namespace {

const gl::TextureLayout floor_layout{GL_RG8,    GL_RG, GL_UNSIGNED_BYTE,
                                     GL_LINEAR, 0,     GL_CLAMP_TO_EDGE};

/// Of the background's shader, which does the work of what is left out by them otherwise.
gl::Constants of_background(gl::Constants fixed, const View& view) {
    fixed.push_back({"endless", view.look.ground == Ground::endless ? 1.0F : 0.0F});
    if (view.sun.source != LightSource::moon) fixed.push_back({"stars", 0.0F});
    return fixed;
}

}  // namespace

BackgroundLayer::BackgroundLayer(const View& view, const Block& block, const FloorMap& floor,
                                 const gl::Constants& fixed)
    : view_(view),
      block_(block),
      program_("common/screen.vert.glsl", "sky/background.frag.glsl", {},
               of_background(fixed, view)),
      floor_(FloorMap::cells, FloorMap::cells, floor_layout, floor.sun_and_sky.data()) {}

void BackgroundLayer::set_floor(const FloorMap& floor) const {
    floor_.upload(floor.sun_and_sky.data());
}

void BackgroundLayer::draw(const Light& light, const Camera& camera, const Tile& tile,
                           RowOrder order) const {
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    if (view_.look.mode == ViewMode::figure) {
        gl.ClearColor(1.0F, 1.0F, 1.0F, 1.0F);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        return;
    }
    program_.use();
    set_light(program_, view_, light, camera, block_);
    program_.set("ray_origin", glm::vec3(camera.eye));
    program_.set("ray_right", glm::vec3(camera.right * camera.half.x));
    program_.set("ray_up", glm::vec3(camera.up * camera.half.y));
    program_.set("ray_forward", glm::vec3(camera.forward));
    program_.set("stars", light.stars ? 1.0F : 0.0F);
    program_.set("pixel",
                 static_cast<float>(2.0 * camera.half.y / static_cast<double>(view_.image.height)));
    program_.set("base", static_cast<float>(block_.base));
    floor_.bind(0);
    program_.set("floor_map", 0);
    program_.set("floor_half_width", static_cast<float>(FloorMap::half_width));
    program_.set("picture_pixels", glm::vec2(static_cast<float>(view_.image.width),
                                             static_cast<float>(view_.image.height)));
    const bool upward = order == RowOrder::upward;
    program_.set("row_of", upward ? glm::vec2(static_cast<float>(tile.height), -1.0F)
                                  : glm::vec2(0.0F, 1.0F));
    program_.set("tile_pixel", glm::vec2(static_cast<float>(tile.x), static_cast<float>(tile.y)));
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace fumon
