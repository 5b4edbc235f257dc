#include "render/background/background_layer.h"

#include <algorithm>

#include "render/frame/clouds.h"
#include "render/frame/view_uniforms.h"
#include "render/light/haze.h"
#include "render/streamers/streamer_layer.h"
#include "render/view/visible_sun.h"

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

/// The most that the disc has of the sun's irradiance over its solid angle, where all of it counts
/// and where a picture's white is enough. A lens that spreads it keeps it white.
double disc_brightness(const View& view, const Camera& camera, PixelFormat wanted) {
    constexpr double radiance = 200.0;
    constexpr double white = 16.0;
    if (wanted == PixelFormat::radiance) return radiance;
    const double spread = camera.lens.radius / camera.lens.focus / disc_radius;
    return view.camera.has_lens() ? std::min(radiance, white * (1.0 + spread) * (1.0 + spread))
                                  : white;
}

/// Of a tile's clouds the first texel, of two pixels along each side.
glm::vec2 cloud_corner(const Tile& tile) {
    const glm::ivec2 halves(tile.x / 2, tile.y / 2);
    return glm::vec2(halves - 1);
}

const gl::TextureLayout floor_layout{GL_RG8,    GL_RG, GL_UNSIGNED_BYTE,
                                     GL_LINEAR, 0,     GL_CLAMP_TO_EDGE};

}  // namespace

BackgroundLayer::BackgroundLayer(const View& view, const Block& block, const Light& light,
                                 const FloorMap& floor, const gl::Constants& fixed,
                                 PixelFormat wanted)
    : view_(view),
      block_(block),
      fixed_(fixed),
      wanted_(wanted),
      clouds_(cloud_number(view, light)),
      floor_(FloorMap::cells, FloorMap::cells, floor_layout, floor.sun_and_sky.data()) {}

void BackgroundLayer::set_floor(const FloorMap& floor) const {
    floor_.upload(floor.sun_and_sky.data());
}

const gl::Program& BackgroundLayer::program(bool plain_alone, bool stars, bool in_parts) {
    std::optional<gl::Program>& made =
        programs_[(plain_alone ? 1U : 0U) + (stars ? 2U : 0U) + (in_parts ? 4U : 0U)];
    if (!made) {
        gl::Constants constants = fixed_;
        constants.push_back({"endless", view_.look.ground == Ground::endless ? 1.0F : 0.0F});
        constants.push_back({"plain_alone", plain_alone ? 1.0F : 0.0F});
        constants.push_back({"stars", stars ? 1.0F : 0.0F});
        made.emplace(in_parts ? "common/parts.vert.glsl" : "common/screen.vert.glsl",
                     "background/background.frag.glsl",
                     std::initializer_list<const char*>{"corner"}, constants);
    }
    return *made;
}

void BackgroundLayer::set_rays(const gl::Program& program, const Light& light,
                               const Camera& camera) const {
    set_light(program, view_, light, camera, block_);
    program.set("ray_origin", glm::vec3(camera.seen_from()));
    program.set("ray_right", glm::vec3(camera.right * camera.half.x));
    program.set("ray_up", glm::vec3(camera.up * camera.half.y));
    program.set("ray_forward", glm::vec3(camera.ahead()));
    program.set("pixel",
                static_cast<float>(2.0 * camera.half.y / static_cast<double>(view_.image.height)));
    program.set("base", static_cast<float>(block_.base));
    program.set("picture_pixels", glm::vec2(static_cast<float>(view_.image.width),
                                            static_cast<float>(view_.image.height)));
}

/// Binds a target that a tile's clouds fit in, and their program.
void BackgroundLayer::start_clouds(const Light& light, const Camera& camera, const Tile& tile) {
    const int width = tile.width / 2 + 4;
    const int height = tile.height / 2 + 4;
    if (!cloud_target_ || cloud_target_->width() < width || cloud_target_->height() < height)
        cloud_target_.emplace(width, height, colour_layout(PixelFormat::radiance));
    if (!cloud_program_)
        cloud_program_.emplace("common/screen.vert.glsl", "background/clouds.frag.glsl",
                               std::initializer_list<const char*>{}, fixed_);
    cloud_target_->bind();
    gl::functions().Disable(GL_DEPTH_TEST);
    cloud_program_->use();
    set_rays(*cloud_program_, light, camera);
    cloud_program_->set("cloud_sun", light.sun_aloft);
    const Haze haze = haze_of(view_, block_);
    cloud_program_->set("cloud_haze", static_cast<float>(haze.per_kilometre));
    cloud_program_->set("cloud_haze_height", static_cast<float>(haze.height));
}

void BackgroundLayer::draw_clouds(const Light& light, const Camera& camera, const Tile& tile) {
    if (clouds_ == 0.0F) return;
    start_clouds(light, camera, tile);
    cloud_program_->set("cloud_corner", cloud_corner(tile));
    gl::functions().DrawArrays(GL_TRIANGLES, 0, 3);
}

float BackgroundLayer::sun_through_clouds(const Light& light, const Camera& camera) {
    if (clouds_ == 0.0F) return 1.0F;
    constexpr int side = 4;
    const Tile disc{0, 0, 2 * side, 2 * side};
    start_clouds(light, camera, disc);
    const glm::vec3 aside = glm::normalize(glm::vec3(light.to_sun.y, -light.to_sun.x, 1e-6F));
    const auto radius = static_cast<float>(0.8 * disc_radius);
    cloud_program_->set("ray_forward", light.to_sun);
    cloud_program_->set("ray_right", radius * aside);
    cloud_program_->set("ray_up", radius * glm::cross(aside, light.to_sun));
    cloud_program_->set("picture_pixels", glm::vec2(2.0F * side));
    cloud_program_->set("cloud_corner", glm::vec2(0.0F));
    gl::functions().DrawArrays(GL_TRIANGLES, 0, 3);
    std::array<float, std::size_t{4} * side * side> texels{};
    gl::functions().ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, texels.data());
    float sum = 0.0F;
    for (std::size_t i = 3; i < texels.size(); i += 4) sum += texels.at(i);
    return sum / (side * side);
}

void BackgroundLayer::draw(const Light& light, const Camera& camera, const Tile& tile,
                           RowOrder order, const glm::ivec2& first_drawn) {
    if (start(light, camera, tile, order, first_drawn, false))
        gl::functions().DrawArrays(GL_TRIANGLES, 0, 3);
}

void BackgroundLayer::draw(const Light& light, const Camera& camera, const Tile& tile,
                           const std::vector<Tile>& parts) {
    if (!start(light, camera, tile, RowOrder::upward, {0, 0}, true)) return;
    std::vector<glm::vec2> corners;
    corners.reserve(6 * parts.size());
    for (const Tile& part : parts) {
        const auto position = [&](int x, int y) {
            return glm::vec2(2.0F * static_cast<float>(x) / static_cast<float>(tile.width) - 1.0F,
                             1.0F - 2.0F * static_cast<float>(y) / static_cast<float>(tile.height));
        };
        const int right = part.x + part.width;
        const int lower = part.y + part.height;
        corners.insert(corners.end(), {position(part.x, lower), position(right, lower),
                                       position(right, part.y), position(part.x, lower),
                                       position(right, part.y), position(part.x, part.y)});
    }
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(parts_array_.name());
    parts_corners_.fill(corners);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
    gl.EnableVertexAttribArray(0);
    gl.Viewport(0, 0, tile.width, tile.height);
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
    gl.BindVertexArray(0);
}

/// Sets all that a picture's surroundings need, or draws a figure's: then false.
bool BackgroundLayer::start(const Light& light, const Camera& camera, const Tile& tile,
                            RowOrder order, const glm::ivec2& first_drawn, bool in_parts) {
    const gl::Functions& gl = gl::functions();
    if (view_.look.mode == ViewMode::figure) {
        gl.ClearColor(1.0F, 1.0F, 1.0F, 1.0F);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        return false;
    }
    const bool plain_alone = view_.look.ground != Ground::endless && looks_down(camera);
    const gl::Program& sees = program(plain_alone, light.stars && !plain_alone, in_parts);
    sees.use();
    set_rays(sees, light, camera);
    sees.set("disc_brightness", static_cast<float>(disc_brightness(view_, camera, wanted_)));
    const double pixel = 2.0 * camera.half.y / static_cast<double>(view_.image.height);
    const double near_disc = disc_radius + 2.0 * pixel;
    sees.set("near_disc2", static_cast<float>(near_disc * near_disc));
    if (clouds_ > 0.0F) {
        cloud_target_->colour().bind(1);
        sees.set("cloud_map", 1);
        sees.set("cloud_corner", cloud_corner(tile));
    }
    floor_.bind(0);
    sees.set("floor_map", 0);
    sees.set("floor_half_width", static_cast<float>(FloorMap::half_width));
    const bool upward = order == RowOrder::upward;
    sees.set("row_of",
             upward ? glm::vec2(static_cast<float>(tile.height), -1.0F) : glm::vec2(0.0F, 1.0F));
    sees.set("streamer_map", streamer_unit);
    sees.set("tile_rows", static_cast<float>(tile.height));
    sees.set("first_drawn", glm::vec2(first_drawn));
    sees.set("tile_pixel", glm::vec2(static_cast<float>(tile.x), static_cast<float>(tile.y)));
    return true;
}

}  // namespace fumon
