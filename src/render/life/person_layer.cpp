#include "render/life/person_layer.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>

#include "base/elementary.h"
#include "base/error.h"
#include "render/frame/view_uniforms.h"
#include "render/life/person_mesh.h"
#include "render/view/bed_positions.h"
#include "render/view/bilinear_height.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"

namespace fumon {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr int ground_unit = 7;
constexpr int points_of_sun = 7;  // as many as three bits count
constexpr GLuint shadow_bits = 0xE0;
constexpr GLint first_shadow_bit = 0x20;

void check_view(const View& view, const Block& block, const Snapshot& first) {
    const char* key = "person.0.at";
    const std::string what = "a person on the bed";
    check_shows_scale(view, block, first, key, what);
    if (block.side < 2.0 * person_height) {
        throw KeyError(key, fmt::format("{} is {} m tall, and this bed is {:g} m long", what,
                                        person_height, block.side));
    }
}

std::vector<PersonPosition> person_positions(const View& view, const Block& block,
                                             const Snapshot& first) {
    check_view(view, block, first);
    std::vector<PersonPosition> positions;
    for (std::size_t i = 0; i < view.persons.size(); ++i) {
        const PersonSettings& person = view.persons[i];
        const std::string key = fmt::format("person.{}.at", i);
        if (person.at.size() != 2) {
            throw KeyError(key, key +
                                    " is two numbers: metres east and north of the bed's "
                                    "south-western corner");
        }
        const glm::dvec2 at =
            bed_position({person.at[0], person.at[1]}, view, block, first, key, key);
        const double facing = person.facing.is_word() ? person_facing(i) : person.facing.value;
        const double angle = -facing * degree;
        positions.push_back({at, glm::vec2(elementary::cos(angle), elementary::sin(angle))});
    }
    return positions;
}

}  // namespace

void check_persons(const View& view, const Snapshot& first) {
    if (view.persons.empty()) return;
    const View drawn = with_chosen_ground(view, first);
    static_cast<void>(person_positions(drawn, framed_block(drawn, first), first));
}

PersonLayer::PersonLayer(const View& view, const Block& block, const Snapshot& first,
                         const gl::Constants& fixed)
    : view_(view),
      block_(block),
      positions_(person_positions(view, block, first)),
      program_("life/person.vert.glsl", "life/standing.frag.glsl",
               {"part", "part_normal", "part_colour"}, fixed),
      shadow_program_("life/person_shadow.vert.glsl", "life/plant.frag.glsl",
                      {"part", "part_normal", "part_colour"}, fixed) {
    BodyMesh mesh;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        const BodyMesh own = person_mesh(person_figure(i));
        const auto corners = static_cast<std::uint32_t>(mesh.corners.size());
        positions_[i].first = mesh.indices.size();
        positions_[i].casting = static_cast<int>(own.indices.size());
        positions_[i].count = static_cast<int>(own.indices.size() + own.details.size());
        mesh.corners.insert(mesh.corners.end(), own.corners.begin(), own.corners.end());
        mesh.indices.reserve(mesh.indices.size() + own.indices.size() + own.details.size());
        for (const std::uint32_t index : own.indices) mesh.indices.push_back(corners + index);
        for (const std::uint32_t index : own.details) mesh.indices.push_back(corners + index);
    }
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(array_.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, corners_.name());
    constexpr std::size_t size = sizeof(BodyCorner);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.corners.size() * size),
                  mesh.corners.data(), GL_STATIC_DRAW);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                  mesh.indices.data(), GL_STATIC_DRAW);
    constexpr std::array offsets{offsetof(BodyCorner, position), offsetof(BodyCorner, normal),
                                 offsetof(BodyCorner, colour)};
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        gl.VertexAttribPointer(static_cast<GLuint>(i), 3, GL_FLOAT, GL_FALSE, size,
                               reinterpret_cast<const void*>(offsets.at(i)));
        gl.EnableVertexAttribArray(static_cast<GLuint>(i));
    }
    gl.BindVertexArray(0);
}

void PersonLayer::set_bed(const Field<float>& z, const Block& ground, bool repeats) {
    z_ = z;
    extent_ = glm::dvec2(ground.width_x, ground.width_y);
    tiles_ = ground.tiles;
    repeats_ = repeats;
    if (!heights_) {
        heights_.emplace(z.nx(), z.ny(),
                         gl::TextureLayout{GL_R32F, GL_RED, GL_FLOAT, GL_LINEAR, 0,
                                           repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE});
    }
    heights_->upload(z.data());
}

void PersonLayer::set_common(const gl::Program& program, const GroundTransform& ground,
                             const TileSamples& tile) const {
    program.use();
    program.set("clip", ground.clip);
    program.set("picture_size", tile.picture_size);
    program.set("tile_corner", tile.corner);
    program.set("tile_size", tile.size);
    program.set("from_eye", ground.endless ? 1.0F : 0.0F);
    program.set("eye_from_middle", glm::vec2(ground.eye_from_middle));
    program.set("warp_strength", static_cast<float>(ground.copies.strength()));
}

void PersonLayer::draw_one(const gl::Program& program, const PersonPosition& position, int count,
                           const GroundTransform& ground, const Camera& camera) const {
    const WarpedGround copy = ground.copies.at(position.at);
    const glm::dvec2 share =
        tiles_.in_maps((position.at - ground.origin) / extent_ + 0.5 + copy.offset);
    const double height =
        ground.copies.raised(copy, static_cast<double>(bilinear_height(z_, share, repeats_)));
    glm::dvec3 root(position.at, height);
    if (ground.endless) {
        root -= camera.eye;
        root.z -=
            glm::dot(glm::dvec2(root), glm::dvec2(root)) * static_cast<double>(ground.curvature);
    }
    program.set("root", glm::vec4(glm::dvec4(root, 1.0 / block_.side)));
    program.set("root_position", glm::vec2(share - glm::floor(share)));
    program.set("turn", position.turn);
    gl::functions().DrawElements(
        GL_TRIANGLES, count, GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(position.first * sizeof(std::uint32_t)));
}

/// The union of all shadows from each of a few points of the sun's disc, one after the other.
void PersonLayer::draw_shadows(const GroundTransform& ground, const BedShading& shading,
                               const Light& light, const Camera& camera,
                               const TileSamples& tile) const {
    if (light.to_sun.z <= 0.0F) return;
    const gl::Functions& gl = gl::functions();
    set_common(shadow_program_, ground, tile);
    shading.bind(shadow_program_);
    set_light(shadow_program_, view_, light, camera, block_);
    heights_->bind(ground_unit);
    shadow_program_.set("height_map", ground_unit);
    shadow_program_.set("curvature", ground.curvature);
    shadow_program_.set("height_origin", ground.endless ? static_cast<float>(camera.eye.z) : 0.0F);
    shadow_program_.set("share", 1.0F / points_of_sun);
    const glm::dvec3 middle(light.to_sun);
    const glm::dvec3 aside = glm::normalize(glm::cross(
        middle, glm::abs(middle.z) < 0.99 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0)));
    const glm::dvec3 up = glm::cross(aside, middle);
    // Where half of the disc lies within.
    const double radius = 0.5 * view_.sun.diameter * degree * std::numbers::sqrt2 / 2.0;
    gl.DepthMask(GL_FALSE);
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilMask(shadow_bits);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (int point = 0; point < points_of_sun; ++point) {
        const double angle = 2.0 * std::numbers::pi * point / (points_of_sun - 1);
        const double off = point == points_of_sun - 1 ? 0.0 : radius;
        const glm::dvec3 from = glm::normalize(
            middle + off * (elementary::cos(angle) * aside + elementary::sin(angle) * up));
        shadow_program_.set("from_point", glm::vec3(from));
        gl.StencilFunc(GL_GREATER, first_shadow_bit * (point + 1), shadow_bits);
        for (const PersonPosition& position : positions_)
            draw_one(shadow_program_, position, position.casting, ground, camera);
    }
    gl.StencilMask(0xFF);
    gl.Disable(GL_STENCIL_TEST);
    gl.Disable(GL_BLEND);
    gl.DepthMask(GL_TRUE);
}

void PersonLayer::draw(const GroundTransform& ground, const BedShading& shading, const Light& light,
                       const Camera& camera, const TileSamples& tile) const {
    const gl::Functions& gl = gl::functions();
    gl.Enable(GL_DEPTH_TEST);
    gl.BindVertexArray(array_.name());
    draw_shadows(ground, shading, light, camera, tile);
    set_common(program_, ground, tile);
    shading.bind(program_);
    set_light(program_, view_, light, camera, block_);
    if (through_) through_->bind(program_, first_, factor_);
    for (const PersonPosition& position : positions_)
        draw_one(program_, position, position.count, ground, camera);
    gl.BindVertexArray(0);
}

void PersonLayer::rasterise_positions(const gl::Program& program, const GroundTransform& ground,
                                      const Camera& camera, const TileSamples& tile) const {
    gl::functions().Enable(GL_DEPTH_TEST);
    gl::functions().BindVertexArray(array_.name());
    set_common(program, ground, tile);
    for (const PersonPosition& position : positions_)
        draw_one(program, position, position.count, ground, camera);
    gl::functions().BindVertexArray(0);
}

void PersonLayer::rasterise_depths(const GroundTransform& ground, const Camera& camera,
                                   const TileSamples& tile) {
    if (!depth_program_)
        depth_program_.emplace(
            "position/person_position.vert.glsl", "streamers/standing.frag.glsl",
            std::initializer_list<const char*>{"part", "part_normal", "part_colour"});
    depth_program_->use();
    depth_program_->set("forward", glm::vec3(camera.forward));
    rasterise_positions(*depth_program_, ground, camera, tile);
}

}  // namespace fumon
