#include "render/world_layer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "base/elementary.h"
#include "base/elementary_angle.h"

namespace fumon {

namespace {

const gl::TextureLayout height_layout{
    GL_R32F, GL_RED, GL_FLOAT, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT};
const gl::TextureLayout wind_layout{
    GL_R8, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT};

constexpr int rings = 1000;
constexpr double nearest_share = 0.2;    // of the eye's height above the ground: the first ring
constexpr double least_nearest = 1e-6;   // block lengths
constexpr double earth_radius = 6360.0;  // km
constexpr double pixels_a_ray = 3.0;
constexpr int detail_unit = 7;
constexpr GLint near_stencil = 1;
constexpr GLint far_stencil = 2;

constexpr double ripple_metres = 0.12;
constexpr double ripple_cells = 0.3;  // without metres: a hundredth of a dune of 30 cells
constexpr double steepest = 0.2;
constexpr double steps_a_ripple = 50.0;  // that it takes to move on by its length
constexpr double longest_turn = 0.45;  // of a ripple, between two samples, at which it is not seen

/// Between two samples in the middle of the picture.
double sample_angle(const Camera& camera, const TileSamples& tile) {
    return 2.0 * camera.half.y / static_cast<double>(tile.picture_size.y);
}

}  // namespace

WorldLayer::WorldLayer(const View& view, const Block& block, const Snapshot& first, int refinement,
                       const gl::Constants& fixed)
    : view_(view),
      block_(block),
      cell_(static_cast<float>(
          std::min(block.width_x / first.bed.nx(), block.width_y / first.bed.ny()) / refinement)),
      ripple_length_(first.scale.in_metres ? ripple_metres / block.side
                                           : ripple_cells * cell_ * refinement),
      seen_program_("world.vert.glsl", "world_seen.frag.glsl", {"ray_and_ring"}),
      near_colours_("screen.vert.glsl", "world_near.frag.glsl", {}, fixed),
      far_colours_("screen.vert.glsl", "world_far.frag.glsl", {}, fixed),
      heights_(first.bed.nx() * refinement, first.bed.ny() * refinement, height_layout),
      wind_(first.bed.nx() * refinement, first.bed.ny() * refinement, wind_layout) {
    build();
}

void WorldLayer::build() {
    rays_ = static_cast<int>(static_cast<double>(view_.image.width) / pixels_a_ray) + 2;
    std::vector<glm::vec2> places;
    places.reserve(static_cast<std::size_t>(rays_) * rings);
    for (int ring = 0; ring < rings; ++ring) {
        for (int ray = 0; ray < rays_; ++ray)
            places.emplace_back(
                -1.0F + 2.0F * static_cast<float>(ray) / static_cast<float>(rays_ - 1),
                static_cast<float>(ring - 1) / static_cast<float>(rings - 2));
    }
    std::vector<std::uint32_t> triangles;
    triangles.reserve(6 * places.size());
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int ray = 0; ray + 1 < rays_; ++ray) {
            const auto a = static_cast<std::uint32_t>(ring * rays_ + ray);
            const std::uint32_t b = a + 1;
            const std::uint32_t c = a + static_cast<std::uint32_t>(rays_);
            triangles.insert(triangles.end(), {a, b, c, b, c + 1, c});
        }
    }
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(array_.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, places_.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size() * sizeof(glm::vec2)),
                  places.data(), GL_STATIC_DRAW);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.EnableVertexAttribArray(0);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.name());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(triangles.size() * sizeof(std::uint32_t)),
                  triangles.data(), GL_STATIC_DRAW);
    gl.BindVertexArray(0);
}

void WorldLayer::set_bed(const Snapshot& snapshot, const RepeatedLight& light) {
    heights_.upload(light.z.data());
    heights_.make_mipmaps();
    wind_.upload(light.wind.data());
    wind_.make_mipmaps();
    z_ = light.z;
    highest_ = *std::ranges::max_element(z_.values());
    step_ = snapshot.step;
    way_ = prevailing_way(snapshot);
}

double WorldLayer::ground_under(const glm::dvec3& eye) const {
    const auto cell = [](double share, int count) {
        const double within = share - std::floor(share);
        return std::min(static_cast<int>(within * count), count - 1);
    };
    return z_(cell(eye.x / block_.width_x + 0.5, z_.nx()),
              cell(eye.y / block_.width_y + 0.5, z_.ny()));
}

/// As wide as the picture's corners reach, all around where it looks down on itself; from the
/// ground under the camera to where the planet's curvature hides the highest crests.
WorldLayer::Fan WorldLayer::fan_of(const Camera& camera) const {
    Fan fan;
    const glm::dvec2 level(camera.forward.x, camera.forward.y);
    const double length = glm::length(level);
    if (length > 1e-6) fan.heading = level / length;
    double least_run = 1e3;  // of a ray, while it sinks by 1
    for (const double x : {-1.0, 0.0, 1.0}) {
        for (const double y : {-1.0, 0.0, 1.0}) {
            const glm::dvec3 ray =
                camera.forward + x * camera.half.x * camera.right + y * camera.half.y * camera.up;
            const glm::dvec2 flat(ray.x, ray.y);
            if (ray.z < 0.0) least_run = std::min(least_run, glm::length(flat) / -ray.z);
            const double along = glm::dot(flat, fan.heading);
            const double across = fan.heading.x * flat.y - fan.heading.y * flat.x;
            fan.half_angle = std::max(fan.half_angle, std::abs(elementary::atan2(across, along)));
        }
    }
    fan.half_angle = fan.half_angle > 1.4 ? std::numbers::pi : fan.half_angle * 1.02 + 0.01;
    fan.nearest =
        std::max(nearest_share * (camera.eye.z - ground_under(camera.eye)), least_nearest);
    // Where the whole bed lies under the eye, nothing nearer than the steepest ray's foot is seen.
    if (fan.half_angle < std::numbers::pi)
        fan.nearest = std::max(fan.nearest, 0.9 * (camera.eye.z - highest_) * least_run);
    const double twice_radius = 2.0 * earth_radius / block_.kilometres;
    const auto horizon = [&](double height) {
        return std::sqrt(std::max(height, 0.0) * twice_radius);
    };
    const double lowest = block_.surface - (highest_ - block_.surface);
    fan.farthest = std::max(1.1 * (horizon(camera.eye.z - lowest) + horizon(highest_ - lowest)),
                            1e3 * fan.nearest);
    return fan;
}

void WorldLayer::set_eye(const gl::Program& program, const Camera& camera) const {
    const auto reduced = [](double place, double extent) {
        return place - extent * std::floor(place / extent + 0.5);
    };
    const glm::dvec3 eye(reduced(camera.eye.x, block_.width_x),
                         reduced(camera.eye.y, block_.width_y), camera.eye.z);
    program.set("eye", glm::vec3(eye));
    program.set("extent", glm::vec2(block_.width_x, block_.width_y));
}

glm::mat4 WorldLayer::clip_from_eye(const Camera& camera, const Fan& fan) {
    Camera at_origin = camera;
    at_origin.eye = glm::dvec3(0.0);
    at_origin.near_depth = 0.5 * fan.nearest;
    at_origin.far_depth = fan.farthest * 1.1;
    return {clip_matrix(at_origin)};
}

glm::mat4 WorldLayer::clip_from_eye(const Camera& camera) const {
    return clip_from_eye(camera, fan_of(camera));
}

float WorldLayer::curvature() const {
    return static_cast<float>(block_.kilometres / (2.0 * earth_radius));
}

void WorldLayer::set_fan(const gl::Program& program, const Fan& fan, const Camera& camera,
                         const TileSamples& tile) const {
    program.set("clip_from_eye", clip_from_eye(camera, fan));
    program.set("heading", glm::vec2(fan.heading));
    program.set("half_angle", static_cast<float>(fan.half_angle));
    program.set("nearest", static_cast<float>(fan.nearest));
    const double reach = elementary::log(fan.farthest / fan.nearest);
    program.set("reach", static_cast<float>(reach));
    program.set("ray_spacing", static_cast<float>(2.0 * fan.half_angle / rays_));
    program.set("ring_spacing", static_cast<float>(reach / (rings - 2)));
    program.set("cell", cell_);
    program.set("curvature", curvature());
    program.set("picture_size", tile.picture_size);
    program.set("tile_corner", tile.corner);
    program.set("tile_size", tile.size);
}

void WorldLayer::set_detail(const gl::Program& program, const Camera& camera,
                            const TileSamples& tile) const {
    program.set("sample_angle", static_cast<float>(sample_angle(camera, tile)));
    const glm::dvec2 wind(way_.x, way_.y);
    program.set("wind", glm::vec2(wind));
    program.set("ripple_length", static_cast<float>(ripple_length_));
    const double turns = glm::dot(glm::dvec2(camera.eye), wind) / ripple_length_ -
                         static_cast<double>(step_) / steps_a_ripple;
    program.set("ripple_phase", static_cast<float>(turns - std::floor(turns)));
    program.set("ripple_slope", static_cast<float>(steepest * view_.look.ripples));
    program.set("sand_grain", static_cast<float>(view_.look.grain));
    program.set("whole_eye", glm::vec2(camera.eye));
}

void WorldLayer::draw_rings(int first, int last) const {
    if (last <= first) return;
    const std::size_t indices = 6 * static_cast<std::size_t>(rays_ - 1);
    const std::size_t from = sizeof(std::uint32_t) * indices * static_cast<std::size_t>(first);
    gl::functions().DrawElements(
        GL_TRIANGLES, static_cast<GLsizei>(indices * static_cast<std::size_t>(last - first)),
        GL_UNSIGNED_INT, reinterpret_cast<const void*>(from));
}

int WorldLayer::first_far_ring(const Fan& fan, const Camera& camera,
                               const TileSamples& tile) const {
    // Beyond that distance a sample spans too much of a ripple.
    const double seen_to = 2.0 * longest_turn * ripple_length_ / sample_angle(camera, tile);
    const double share = elementary::log(std::max(seen_to / fan.nearest, 1.0)) /
                         elementary::log(fan.farthest / fan.nearest);
    // Of log radius = reach · u · (0.6 + 0.4 u).
    const double u = 1.25 * (std::sqrt(0.36 + 1.6 * std::clamp(share, 0.0, 1.0)) - 0.6);
    return std::min(static_cast<int>(std::ceil(u * (rings - 2))) + 1, rings - 1);
}

void WorldLayer::draw_seen(const Camera& camera, const TileSamples& tile) const {
    const gl::Functions& gl = gl::functions();
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    const Fan fan = fan_of(camera);
    const int first_far = first_far_ring(fan, camera, tile);
    seen_program_.use();
    heights_.bind(detail_unit - 1);
    seen_program_.set("height_map", detail_unit - 1);
    set_eye(seen_program_, camera);
    set_fan(seen_program_, fan, camera, tile);
    gl.BindVertexArray(array_.name());
    gl.StencilFunc(GL_ALWAYS, near_stencil, 0xFF);
    draw_rings(0, first_far);
    gl.StencilFunc(GL_ALWAYS, far_stencil, 0xFF);
    draw_rings(first_far, rings - 1);
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void WorldLayer::colour_seen(const gl::Texture2D& seen, const BedShading& shading,
                             const Light& light, const Camera& camera,
                             const TileSamples& tile) const {
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.BindVertexArray(no_attributes_.name());
    for (const bool near : {true, false}) {
        const gl::Program& program = near ? near_colours_ : far_colours_;
        program.use();
        shading.bind(program);
        set_light(program, view_, light, camera, block_);
        wind_.bind(detail_unit);
        program.set("wind_map", detail_unit);
        shading.colours().bind(detail_unit + 1);
        program.set("albedo_map", detail_unit + 1);
        seen.bind(detail_unit + 2);
        program.set("offsets", detail_unit + 2);
        set_eye(program, camera);
        set_detail(program, camera, tile);
        gl.StencilFunc(GL_EQUAL, near ? near_stencil : far_stencil, 0xFF);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

}  // namespace fumon
