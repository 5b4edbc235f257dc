#include "render/world_layer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/elementary.h"
#include "base/elementary_angle.h"

namespace fumon {

namespace {

const gl::TextureLayout height_layout{
    GL_R32F, GL_RED, GL_FLOAT, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT};

constexpr double innermost_ring = 1e-4;   // block lengths
constexpr double outermost_ring = 400.0;  // block lengths
constexpr double ring_ratio = 1.008;
constexpr double pixels_a_ray = 2.0;

}  // namespace

WorldLayer::WorldLayer(const View& view, const Block& block, const DisplayBed& first_bed)
    : view_(view),
      block_(block),
      cell_(std::min(first_bed.dx, first_bed.dy)),
      program_("world.vert.glsl", "world.frag.glsl", {"ray_and_ring"}),
      heights_(first_bed.z.nx(), first_bed.z.ny(), height_layout) {
    build();
}

void WorldLayer::build() {
    rays_ = static_cast<int>(static_cast<double>(view_.image.width) / pixels_a_ray) + 2;
    rings_ = static_cast<int>(elementary::log(outermost_ring / innermost_ring) /
                              elementary::log(ring_ratio)) +
             2;
    std::vector<glm::vec2> places;
    places.reserve(static_cast<std::size_t>(rays_ * rings_));
    for (int ring = 0; ring < rings_; ++ring) {
        for (int ray = 0; ray < rays_; ++ray)
            places.emplace_back(
                -1.0F + 2.0F * static_cast<float>(ray) / static_cast<float>(rays_ - 1),
                static_cast<float>(ring - 1));
    }
    std::vector<std::uint32_t> triangles;
    triangles.reserve(6 * places.size());
    for (int ring = 0; ring + 1 < rings_; ++ring) {
        for (int ray = 0; ray + 1 < rays_; ++ray) {
            const auto a = static_cast<std::uint32_t>(ring * rays_ + ray);
            const std::uint32_t b = a + 1;
            const std::uint32_t c = a + static_cast<std::uint32_t>(rays_);
            triangles.insert(triangles.end(), {a, b, c, b, c + 1, c});
        }
    }
    indices_ = static_cast<GLsizei>(triangles.size());
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

void WorldLayer::set_bed(const Field<float>& z) {
    heights_.upload(z.data());
    heights_.make_mipmaps();
}

void WorldLayer::draw(const BedShading& shading, const Light& light, const Camera& camera,
                      const TileSamples& tile) const {
    const gl::Functions& gl = gl::functions();
    gl.Enable(GL_DEPTH_TEST);
    program_.use();
    shading.bind(program_);
    set_light(program_, view_, light, camera, block_);
    heights_.bind(6);
    program_.set("height_map", 6);

    // The fan: as wide as the picture's corners reach, all around where it looks down on itself.
    const glm::dvec2 level(camera.forward.x, camera.forward.y);
    const double length = glm::length(level);
    const glm::dvec2 heading = length > 1e-6 ? level / length : glm::dvec2(0.0, 1.0);
    double half_angle = 0.0;
    for (const double x : {-1.0, 0.0, 1.0}) {
        for (const double y : {-1.0, 0.0, 1.0}) {
            const glm::dvec3 ray =
                camera.forward + x * camera.half.x * camera.right + y * camera.half.y * camera.up;
            const glm::dvec2 flat(ray.x, ray.y);
            const double along = glm::dot(flat, heading);
            const double across = heading.x * flat.y - heading.y * flat.x;
            half_angle = std::max(half_angle, std::abs(elementary::atan2(across, along)));
        }
    }
    half_angle = half_angle > 1.4 ? std::numbers::pi : half_angle * 1.02 + 0.01;

    const auto reduced = [](double place, double extent) {
        return place - extent * std::floor(place / extent + 0.5);
    };
    const glm::dvec3 eye(reduced(camera.eye.x, block_.width_x),
                         reduced(camera.eye.y, block_.width_y), camera.eye.z);
    Camera at_origin = camera;
    at_origin.eye = glm::dvec3(0.0);
    at_origin.near_depth = innermost_ring;
    at_origin.far_depth = outermost_ring * 1.1;
    program_.set("clip_from_eye", glm::mat4(clip_matrix(at_origin)));
    program_.set("eye", glm::vec3(eye));
    program_.set("heading", glm::vec2(heading));
    program_.set("half_angle", static_cast<float>(half_angle));
    program_.set("nearest", static_cast<float>(innermost_ring));
    program_.set("ring_ratio", static_cast<float>(ring_ratio));
    program_.set("spacing", static_cast<float>(2.0 * half_angle / rays_));
    program_.set("extent", glm::vec2(block_.width_x, block_.width_y));
    program_.set("cell", cell_);
    program_.set("curvature", 0.0F);
    program_.set("picture_size", tile.picture_size);
    program_.set("tile_corner", tile.corner);
    program_.set("tile_size", tile.size);
    constexpr double visibility = 40.0;  // block lengths
    program_.set("extinction", static_cast<float>(3.912 / visibility));
    const double ripple_length = 0.5 * cell_;
    program_.set("wind", glm::vec2(1.0F, 0.0F));
    program_.set("ripple_length", static_cast<float>(ripple_length));
    const double turns = camera.eye.x / ripple_length;
    program_.set("ripple_phase", static_cast<float>(turns - std::floor(turns)));
    constexpr double steepest = 0.28;
    program_.set("ripple_slope", static_cast<float>(steepest * view_.look.ripples));
    program_.set("whole_eye", glm::vec2(camera.eye));
    gl.BindVertexArray(array_.name());
    gl.DrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    gl.BindVertexArray(0);
}

}  // namespace fumon
