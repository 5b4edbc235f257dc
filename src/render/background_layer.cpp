#include "render/background_layer.h"

#include <algorithm>

#include "render/bed_shading.h"
#include "render/streamer_layer.h"

namespace fumon {

namespace {

/// Whether no ray of a picture comes near the horizon: all see the plain.
bool looks_down(const Camera& camera) {
    constexpr double steep = -1e-3;  // what the shader takes for the plain, and more than rounding
    if (!camera.perspective) return camera.forward.z < steep;
    const glm::dvec3 ahead = camera.ahead();
    double highest = 0.0;
    double longest = 0.0;
    bool first = true;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            const glm::dvec3 ray =
                ahead + x * camera.half.x * camera.right + y * camera.half.y * camera.up;
            highest = first ? ray.z : std::max(highest, ray.z);
            longest = std::max(longest, glm::length(ray));
            first = false;
        }
    }
    return highest < steep * longest;
}

const gl::TextureLayout floor_layout{GL_RG8,    GL_RG, GL_UNSIGNED_BYTE,
                                     GL_LINEAR, 0,     GL_CLAMP_TO_EDGE};

}  // namespace

BackgroundLayer::BackgroundLayer(const View& view, const Block& block, const FloorMap& floor,
                                 const gl::Constants& fixed)
    : view_(view),
      block_(block),
      fixed_(fixed),
      floor_(FloorMap::cells, FloorMap::cells, floor_layout, floor.sun_and_sky.data()) {}

void BackgroundLayer::set_floor(const FloorMap& floor) const {
    floor_.upload(floor.sun_and_sky.data());
}

const gl::Program& BackgroundLayer::program(bool plain_alone, bool stars) {
    std::optional<gl::Program>& made = programs_[(plain_alone ? 1U : 0U) + (stars ? 2U : 0U)];
    if (!made) {
        gl::Constants constants = fixed_;
        constants.push_back({"endless", view_.look.ground == Ground::endless ? 1.0F : 0.0F});
        constants.push_back({"plain_alone", plain_alone ? 1.0F : 0.0F});
        constants.push_back({"stars", stars ? 1.0F : 0.0F});
        made.emplace("common/screen.vert.glsl", "sky/background.frag.glsl",
                     std::initializer_list<const char*>{}, constants);
    }
    return *made;
}

void BackgroundLayer::draw(const Light& light, const Camera& camera, const Tile& tile,
                           RowOrder order, const glm::ivec2& first_drawn) {
    const gl::Functions& gl = gl::functions();
    if (view_.look.mode == ViewMode::figure) {
        gl.ClearColor(1.0F, 1.0F, 1.0F, 1.0F);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        return;
    }
    const bool plain_alone = view_.look.ground != Ground::endless && looks_down(camera);
    const gl::Program& sees = program(plain_alone, light.stars && !plain_alone);
    sees.use();
    set_light(sees, view_, light, camera, block_);
    sees.set("ray_origin", glm::vec3(camera.seen_from()));
    sees.set("ray_right", glm::vec3(camera.right * camera.half.x));
    sees.set("ray_up", glm::vec3(camera.up * camera.half.y));
    sees.set("ray_forward", glm::vec3(camera.ahead()));
    sees.set("pixel",
             static_cast<float>(2.0 * camera.half.y / static_cast<double>(view_.image.height)));
    sees.set("base", static_cast<float>(block_.base));
    floor_.bind(0);
    sees.set("floor_map", 0);
    sees.set("floor_half_width", static_cast<float>(FloorMap::half_width));
    sees.set("picture_pixels", glm::vec2(static_cast<float>(view_.image.width),
                                         static_cast<float>(view_.image.height)));
    const bool upward = order == RowOrder::upward;
    sees.set("row_of",
             upward ? glm::vec2(static_cast<float>(tile.height), -1.0F) : glm::vec2(0.0F, 1.0F));
    sees.set("streamer_map", streamer_unit);
    sees.set("tile_rows", static_cast<float>(tile.height));
    sees.set("first_drawn", glm::vec2(first_drawn));
    sees.set("tile_pixel", glm::vec2(static_cast<float>(tile.x), static_cast<float>(tile.y)));
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace fumon
