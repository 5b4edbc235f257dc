#include "render/streamers/streamer_layer.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "gl/functions.h"
#include "render/frame/view_uniforms.h"

namespace fumon {

namespace {

const gl::TextureLayout depths_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT,
                                      GL_NEAREST, 0,       GL_CLAMP_TO_EDGE};
constexpr int offsets_unit = 10;
const gl::TextureLayout streaks_layout{GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT,
                                       GL_LINEAR, 0,       GL_REPEAT};
constexpr int streaks_texels = 256;
constexpr double streaks_features = 32.0;  // along its side
constexpr int streaks_unit = 11;
constexpr GLsizei corners = 4;
constexpr double whole_streaks = 4096.0;  // metres, before their places lose digits

}  // namespace

StreamerLayer::StreamerLayer(const View& view, const Block& block, int width, int height)
    : view_(view),
      block_(block),
      program_("streamers/puff.vert.glsl", "streamers/puff.frag.glsl",
               {"middle", "along", "across"}),
      ground_program_("common/screen.vert.glsl", "streamers/depths.frag.glsl"),
      noise_(streaks_texels, streaks_texels, streaks_layout),
      ground_(width, height, depths_layout),
      target_(width, height, depths_layout) {
    draw_noise();
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(array_.name());
    instances_.bind();
    constexpr std::array offsets{offsetof(Puff, middle), offsetof(Puff, along),
                                 offsetof(Puff, across)};
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const auto index = static_cast<GLuint>(i);
        gl.VertexAttribPointer(index, 4, GL_FLOAT, GL_FALSE, sizeof(Puff),
                               reinterpret_cast<const void*>(offsets.at(i)));
        gl.EnableVertexAttribArray(index);
        gl.VertexAttribDivisor(index, 1);
    }
    gl.BindVertexArray(0);
}

void StreamerLayer::draw_noise() {
    const gl::Program program("common/screen.vert.glsl", "streamers/streaks.frag.glsl");
    noise_.bind();
    gl::functions().BindVertexArray(no_attributes_.name());
    gl::functions().Disable(GL_DEPTH_TEST);
    program.use();
    program.set("features", static_cast<float>(streaks_features));
    gl::functions().DrawArrays(GL_TRIANGLES, 0, 3);
    gl::functions().BindVertexArray(0);
}

void StreamerLayer::draw_ground(const gl::Texture2D& seen, glm::ivec2 first, int factor,
                                const Camera& camera) const {
    ground_.bind();
    ground_program_.use();
    ground_program_.set("forward", glm::vec3(camera.forward));
    ground_program_.set("first_sample", glm::vec2(first));
    ground_program_.set("factor", factor);
    seen.bind(offsets_unit);
    ground_program_.set("offsets", offsets_unit);
    gl::functions().BindVertexArray(no_attributes_.name());
    gl::functions().DrawArrays(GL_TRIANGLES, 0, 3);
}

void StreamerLayer::choose(const BlownSand& sand, std::int64_t steps, const GroundTransform& ground,
                           const Camera& camera) {
    const PuffGround on{-0.5 * glm::dvec2(block_.width_x, block_.width_y),
                        glm::dvec2(block_.width_x, block_.width_y),
                        static_cast<double>(ground.curvature), ground.copies};
    const double gone = sand.travel * static_cast<double>(steps);
    const double pixel = 2.0 * camera.half.y / static_cast<double>(view_.image.height);
    puffs_ = visible_puffs(sand, view_.streamers.strength, gone, on, camera, pixel);
    const glm::dvec2 wind(sand.way.x, sand.way.y);
    const auto downwind =
        std::fmod((glm::dot(glm::dvec2(camera.eye), wind) - gone) / sand.metre, whole_streaks);
    const double aside = glm::dot(glm::dvec2(camera.eye), glm::dvec2(-wind.y, wind.x)) / sand.metre;
    wind_ = glm::vec2(wind);
    eye_position_ = glm::vec3(glm::dvec3(downwind, aside, camera.eye.z / sand.metre));
    metre_ = static_cast<float>(sand.metre);
    gl::functions().BindVertexArray(array_.name());
    instances_.fill(puffs_);
    gl::functions().BindVertexArray(0);
}

/// Into the depths of the ground, at each pixel's middle.
void StreamerLayer::draw_occluders(std::span<const Occluder> occluders, const Tile& tile) const {
    const gl::Functions& gl = gl::functions();
    TileSamples pixels{};
    pixels.picture_size =
        glm::vec2(static_cast<float>(view_.image.width), static_cast<float>(view_.image.height));
    pixels.corner = glm::vec2(static_cast<float>(tile.x),
                              static_cast<float>(view_.image.height - tile.y - tile.height));
    pixels.size = glm::vec2(ground_.width(), ground_.height());
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    gl.BlendEquation(GL_MIN);
    for (const Occluder& rasterise : occluders) rasterise(pixels);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.Disable(GL_BLEND);
    gl.Disable(GL_DEPTH_TEST);
}

void StreamerLayer::draw(const gl::Texture2D& seen, glm::ivec2 first, int factor, const Tile& tile,
                         const Light& light, const Camera& camera,
                         std::span<const Occluder> occluders) {
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    if (!puffs_.empty()) {
        draw_ground(seen, first, factor, camera);
        draw_occluders(occluders, tile);
    }
    target_.bind();
    gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    if (puffs_.empty()) return;
    const glm::vec2 picture(static_cast<float>(view_.image.width),
                            static_cast<float>(view_.image.height));
    const auto below = static_cast<float>(view_.image.height - tile.y - tile.height);
    const glm::vec2 corner(static_cast<float>(tile.x), below);
    program_.use();
    set_light(program_, view_, light, camera, block_);
    set_sand(program_, view_.look);
    program_.set("picture_size", picture);
    program_.set("tile_corner", corner);
    program_.set("tile_size", glm::vec2(target_.width(), target_.height()));
    program_.set("tile_pixel", corner);
    program_.set("picture_pixels", picture);
    program_.set("right", glm::vec3(camera.right * camera.half.x));
    program_.set("up", glm::vec3(camera.up * camera.half.y));
    program_.set("forward", glm::vec3(camera.forward));
    program_.set("lens", glm::vec2(camera.half));
    const glm::dvec3 ahead = camera.ahead();
    program_.set("ahead", glm::vec3(ahead));
    program_.set("aside", glm::vec3(camera.seen_from() - camera.eye));
    program_.set("shear",
                 glm::vec2(glm::dvec2(glm::dot(ahead, camera.right), glm::dot(ahead, camera.up)) /
                           camera.half));
    program_.set("wind", wind_);
    program_.set("eye_position", eye_position_);
    program_.set("metre", metre_);
    ground_.colour().bind(offsets_unit);
    program_.set("ground_map", offsets_unit);
    noise_.colour().bind(streaks_unit);
    program_.set("noise_map", streaks_unit);
    program_.set("noise_scale", static_cast<float>(1.0 / streaks_features));
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    gl.BindVertexArray(array_.name());
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, corners, static_cast<GLsizei>(puffs_.size()));
    gl.BindVertexArray(0);
    gl.Disable(GL_BLEND);
}

void StreamerLayer::bind(const gl::Program& program, glm::ivec2 first, int factor) const {
    bind(program);
    program.set("first_of_tile", glm::vec2(first));
    program.set("factor", static_cast<float>(factor));
}

void StreamerLayer::bind(const gl::Program& program) const {
    bind();
    program.set("streamer_map", streamer_unit);
}

}  // namespace fumon
