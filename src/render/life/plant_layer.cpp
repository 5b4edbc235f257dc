#include "render/life/plant_layer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/elementary.h"
#include "base/elementary_power.h"
#include "base/snapshot_lookup.h"
#include "base/truncation.h"
#include "render/frame/view_uniforms.h"
#include "render/view/bilinear_height.h"
#include "render/view/tile_warp_waves.h"

namespace fumon {

namespace {

constexpr int squares_per_side = 16;
constexpr int rank_levels = 12;
constexpr double full_density_pixels = 9.0;  // pixels: as high as this, every plant is drawn
constexpr double least_pixels = 0.9;         // that a plant is high
constexpr double shadow_pixels = 2.0;
constexpr std::array detail_pixels{60.0, 20.0};
constexpr double most_growth = 2.5;
constexpr double growth_power = 0.3;  // of the share that is left
constexpr int height_unit = 7;
constexpr std::array shadow_widths{0.30F, 0.55F};
constexpr int strip_pieces = 5;

// Reflectances of Ammophila and Stipa, and of Tamarix: rounded to what photographs show.
const std::array young{glm::vec3(0.150, 0.170, 0.062), glm::vec3(0.088, 0.104, 0.056)};
const std::array dry{glm::vec3(0.250, 0.212, 0.118), glm::vec3(0.140, 0.128, 0.082)};

void point_attribute(GLuint index, GLint count, GLsizei stride, std::size_t offset,
                     GLuint divisor) {
    const gl::Functions& gl = gl::functions();
    gl.VertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, stride,
                           reinterpret_cast<const void*>(offset));
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribDivisor(index, divisor);
}

double pixel_angle(const Camera& camera, const View& view) {
    return 2.0 * camera.half.y / static_cast<double>(view.image.height);
}

}  // namespace

bool draws_plants(const View& view, const Snapshot& first) {
    return view.look.plants > 0.0 && view.look.mode == ViewMode::scenic &&
           view.camera.projection == Projection::perspective &&
           (find_named(first.fields, "grass") != nullptr ||
            find_named(first.fields, "shrubs") != nullptr);
}

PlantLayer::PlantLayer(const View& view, const Block& block, const gl::Constants& fixed)
    : view_(view),
      block_(block),
      leaf_program_("life/plant.vert.glsl", "life/standing.frag.glsl",
                    {"leaf", "leaf_normal", "root", "form"}, fixed),
      shadow_program_("life/plant_shadow.vert.glsl", "life/plant_shadow.frag.glsl",
                      {"strip", "root"}, fixed) {
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        for (int detail = 0; detail < plant_details; ++detail) {
            build(meshes_.at(kind).at(static_cast<std::size_t>(detail)),
                  plant_mesh(static_cast<PlantKind>(kind), static_cast<PlantDetail>(detail)));
        }
        std::vector<glm::vec2> strip;
        for (int i = 0; i < strip_pieces; ++i) {
            const float from = static_cast<float>(i) / strip_pieces;
            const float to = static_cast<float>(i + 1) / strip_pieces;
            strip.insert(strip.end(), {{-1.0F, from}, {1.0F, from}, {-1.0F, to}});
            strip.insert(strip.end(), {{1.0F, from}, {1.0F, to}, {-1.0F, to}});
        }
        Mesh& shadow = shadows_.at(kind);
        shadow.count = static_cast<int>(strip.size());
        const gl::Functions& gl = gl::functions();
        gl.BindVertexArray(shadow.array.name());
        gl.BindBuffer(GL_ARRAY_BUFFER, shadow.corners.name());
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(strip.size() * sizeof(glm::vec2)),
                      strip.data(), GL_STATIC_DRAW);
        point_attribute(0, 2, 0, 0, 0);
        gl.BindBuffer(GL_ARRAY_BUFFER, shadow.instances.name());
        point_attribute(1, 4, sizeof(Instance), offsetof(Instance, root), 1);
        gl.BindVertexArray(0);
    }
}

void PlantLayer::build(Mesh& mesh, const std::vector<LeafVertex>& corners) const {
    const gl::Functions& gl = gl::functions();
    mesh.count = static_cast<int>(corners.size());
    gl.BindVertexArray(mesh.array.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, mesh.corners.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(LeafVertex)),
                  corners.data(), GL_STATIC_DRAW);
    point_attribute(0, 3, sizeof(LeafVertex), offsetof(LeafVertex, position), 0);
    point_attribute(1, 4, sizeof(LeafVertex), offsetof(LeafVertex, normal), 0);  // and tint
    gl.BindBuffer(GL_ARRAY_BUFFER, mesh.instances.name());
    point_attribute(2, 4, sizeof(Instance), offsetof(Instance, root), 1);
    point_attribute(3, 3, sizeof(Instance), offsetof(Instance, form), 1);
    gl.BindVertexArray(0);
}

void PlantLayer::set_bed(const Snapshot& snapshot, const Field<float>& z, bool repeats) {
    const std::vector<Plant> plants = plant_positions(snapshot, block_, view_.look.plants);
    levels_.assign(rank_levels, {});
    for (Level& level : levels_) level.squares.resize(squares_per_side * squares_per_side);
    tallest_ = 0.0F;
    for (const Plant& plant : plants) {
        // The share of plants that a level begins at halves from one to the next.
        int level = 0;
        for (float share = 0.5F; level + 1 < rank_levels && plant.rank < share; share *= 0.5F)
            ++level;
        const auto square = [](double position, double extent) {
            return truncated_within(position / extent * squares_per_side, 0, squares_per_side - 1);
        };
        const int number = square(plant.position.y, block_.width_y) * squares_per_side +
                           square(plant.position.x, block_.width_x);
        levels_[static_cast<std::size_t>(level)]
            .squares[static_cast<std::size_t>(number)]
            .push_back(plant);
        tallest_ = std::max(tallest_, plant.height);
    }
    z_ = z;
    repeats_ = repeats;
    if (plants.empty()) return;
    if (!heights_ || heights_->width() != z.nx() || heights_->height() != z.ny()) {
        heights_.emplace(z.nx(), z.ny(),
                         gl::TextureLayout{GL_R32F, GL_RED, GL_FLOAT, GL_LINEAR, 0,
                                           repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE});
    }
    heights_->upload(z.data());
}

/// From the bed's south-west corner.
float PlantLayer::ground_at(const glm::dvec2& position, const GroundTransform& ground) const {
    return bilinear_height(
        z_, (position - ground.origin) / glm::dvec2(block_.width_x, block_.width_y), repeats_);
}

/// Whether a ball may show in the picture.
bool PlantLayer::in_frustum(const Camera& camera, const glm::dvec3& offset, double radius) const {
    const double depth = glm::dot(offset, camera.forward);
    radius += camera.lens.radius * std::abs(1.0 - depth / camera.lens.focus);  // it is blurred
    if (depth < -radius) return false;
    const auto beside = [&](const glm::dvec3& axis, double half) {
        return std::abs(glm::dot(offset, axis)) <=
               half * depth + radius * std::sqrt(1.0 + half * half);
    };
    return beside(camera.right, camera.half.x) && beside(camera.up, camera.half.y);
}

void PlantLayer::choose_in(const std::vector<Plant>& plants, const glm::dvec2& origin,
                           const GroundTransform& ground, const Camera& camera) {
    const double angle = pixel_angle(camera, view_);
    for (const Plant& plant : plants) {
        const glm::dvec2 position =
            ground.copies.ground_position_of(origin + glm::dvec2(plant.position));
        const double z = ground.copies.raised(
            ground.copies.at(position),
            static_cast<double>(ground_at(glm::dvec2(plant.position), ground)));
        glm::dvec3 offset(position - glm::dvec2(camera.eye), z - camera.eye.z);
        const double distance = glm::length(offset);
        const double pixels = plant.height / (distance * angle);
        const double full_density_ratio = full_density_pixels / pixels;
        const double share =
            full_density_ratio > 1.0 ? 1.0 / (full_density_ratio * full_density_ratio) : 1.0;
        if (pixels < least_pixels || plant.rank >= share) continue;
        if (!in_frustum(camera, offset, 2.0 * plant.height)) continue;
        // Plants shrink away before they are left out.
        const double faded =
            share < 1.0 ? std::min((share - plant.rank) / (0.25 * share), 1.0) : 1.0;
        const double grown = std::min(elementary::pow(share, -growth_power), most_growth) * faded;
        const auto height = static_cast<float>(plant.height * grown);
        if (ground.endless)
            offset.z -= glm::dot(glm::dvec2(offset), glm::dvec2(offset)) *
                        static_cast<double>(ground.curvature);
        const glm::vec3 root =
            ground.endless ? glm::vec3(offset) : glm::vec3(glm::dvec3(position, z));
        const Instance one{{root, height},
                           {static_cast<float>(elementary::cos(plant.turn)),
                            static_cast<float>(elementary::sin(plant.turn)),
                            2.0F * (plant.turn / 6.2831853F) - 1.0F}};
        const std::size_t detail = pixels > detail_pixels[0]   ? 0
                                   : pixels > detail_pixels[1] ? 1
                                                               : 2;
        const auto kind = static_cast<std::size_t>(plant.kind);
        meshes_.at(kind).at(detail).chosen.push_back(one);
        if (pixels > shadow_pixels) shadows_.at(kind).chosen.push_back(one);
    }
}

void PlantLayer::choose(const GroundTransform& ground, const Camera& camera) {
    for (auto& of_kind : meshes_) {
        for (Mesh& mesh : of_kind) mesh.chosen.clear();
    }
    for (Mesh& mesh : shadows_) mesh.chosen.clear();
    if (tallest_ <= 0.0F || !camera.perspective) return;
    const double angle = pixel_angle(camera, view_);
    const glm::dvec2 square(block_.width_x / squares_per_side, block_.width_y / squares_per_side);
    const glm::dvec2 corner(-0.5 * block_.width_x, -0.5 * block_.width_y);
    const double all_within = tallest_ / (full_density_pixels * angle);
    const double none_beyond = tallest_ / (least_pixels * angle);
    const double middle_z = block_.surface;
    const bool varied = ground.copies.varied();
    const double widest = varied ? tile_warp::largest_stretch : 1.0;
    const double aside = varied ? tile_warp::largest_offset * squares_per_side : 0.0;
    for (std::size_t level = 0; level < levels_.size(); ++level) {
        const double lowest_rank =
            level + 1 < levels_.size() ? std::ldexp(0.5, -static_cast<int>(level)) : 0.0;
        const double reach = lowest_rank > 0.0
                                 ? std::min(all_within / std::sqrt(lowest_rank), none_beyond)
                                 : none_beyond;
        // Squares, counted on over the bed's repetitions.
        const auto range = [&](double at, double from, double size) {
            const double low = (at - reach - from) / size - aside;
            const double high = (at + reach - from) / size + aside;
            const double last = squares_per_side - 1;
            return repeats_ ? std::pair(std::floor(low), std::floor(high))
                            : std::pair(std::clamp(std::floor(low), 0.0, last),
                                        std::clamp(std::floor(high), 0.0, last));
        };
        const auto [west, east] = range(camera.eye.x, corner.x, square.x);
        const auto [south, north] = range(camera.eye.y, corner.y, square.y);
        for (double y = south; y <= north; y += 1.0) {
            for (double x = west; x <= east; x += 1.0) {
                const glm::dvec2 middle = ground.copies.ground_position_of(
                    corner + square * glm::dvec2(x + 0.5, y + 0.5));
                const glm::dvec3 offset(middle - glm::dvec2(camera.eye), middle_z - camera.eye.z);
                const double radius =
                    widest * 0.5 * glm::length(square) + (block_.top - block_.base);
                if (glm::length(glm::dvec2(offset)) > reach + radius) continue;
                if (!in_frustum(camera, offset, radius)) continue;
                const double repeat_x = std::floor(x / squares_per_side);
                const double repeat_y = std::floor(y / squares_per_side);
                const auto number =
                    static_cast<std::size_t>((y - repeat_y * squares_per_side) * squares_per_side +
                                             (x - repeat_x * squares_per_side));
                choose_in(levels_[level].squares[number],
                          corner + glm::dvec2(repeat_x * block_.width_x, repeat_y * block_.width_y),
                          ground, camera);
            }
        }
    }
    for (const auto& of_kind : meshes_) {
        for (const Mesh& mesh : of_kind) upload(mesh);
    }
    for (const Mesh& mesh : shadows_) upload(mesh);
}

void PlantLayer::upload(const Mesh& mesh) {
    const gl::Functions& gl = gl::functions();
    gl.BindBuffer(GL_ARRAY_BUFFER, mesh.instances.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.chosen.size() * sizeof(Instance)),
                  mesh.chosen.data(), GL_STREAM_DRAW);
}

void PlantLayer::set_position(const gl::Program& program, const GroundTransform& ground,
                              const TileSamples& tile) {
    program.use();
    program.set("clip", ground.clip);
    program.set("picture_size", tile.picture_size);
    program.set("tile_corner", tile.corner);
    program.set("tile_size", tile.size);
}

void PlantLayer::set_common(const gl::Program& program, const GroundTransform& ground,
                            const BedShading& shading, const Light& light, const Camera& camera,
                            const TileSamples& tile) const {
    set_position(program, ground, tile);
    shading.bind(program);
    set_light(program, view_, light, camera, block_);
    // Reduced to one period, for the sake of precision.
    const auto reduced = [&](double position, double extent) {
        if (block_.tiles.plain) return position;
        return position - extent * std::floor(position / extent + 0.5);
    };
    program.set("root_origin",
                ground.endless ? glm::vec2(reduced(camera.eye.x - ground.origin.x, block_.width_x),
                                           reduced(camera.eye.y - ground.origin.y, block_.width_y))
                               : glm::vec2(0.0F));
    program.set("from_eye", ground.endless ? 1.0F : 0.0F);
    program.set("eye_from_middle", glm::vec2(ground.eye_from_middle));
    program.set("warp_strength", static_cast<float>(ground.copies.strength()));
    program.set("extent", glm::vec2(block_.width_x, block_.width_y));
}

void PlantLayer::draw_shadows(const GroundTransform& ground, const BedShading& shading,
                              const Light& light, const Camera& camera,
                              const TileSamples& tile) const {
    const gl::Functions& gl = gl::functions();
    set_common(shadow_program_, ground, shading, light, camera, tile);
    heights_->bind(height_unit);
    shadow_program_.set("height_map", height_unit);
    shadow_program_.set("curvature", ground.curvature);
    shadow_program_.set("height_origin", ground.endless ? static_cast<float>(camera.eye.z) : 0.0F);
    gl.DepthMask(GL_FALSE);
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        const Mesh& shadow = shadows_.at(kind);
        shadow_program_.set("width", shadow_widths.at(kind));
        gl.BindVertexArray(shadow.array.name());
        gl.DrawArraysInstanced(GL_TRIANGLES, 0, shadow.count,
                               static_cast<GLsizei>(shadow.chosen.size()));
    }
    gl.Disable(GL_BLEND);
    gl.DepthMask(GL_TRUE);
}

void PlantLayer::draw(const GroundTransform& ground, const BedShading& shading, const Light& light,
                      const Camera& camera, const TileSamples& tile) const {
    if (tallest_ <= 0.0F || !camera.perspective) return;
    const gl::Functions& gl = gl::functions();
    gl.Enable(GL_DEPTH_TEST);
    draw_shadows(ground, shading, light, camera, tile);
    set_common(leaf_program_, ground, shading, light, camera, tile);
    if (through_) through_->bind(leaf_program_, first_, factor_);
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        leaf_program_.set("young", young.at(kind));
        leaf_program_.set("dry", dry.at(kind));
        for (const Mesh& mesh : meshes_.at(kind)) {
            if (mesh.chosen.empty()) continue;
            gl.BindVertexArray(mesh.array.name());
            gl.DrawArraysInstanced(GL_TRIANGLES, 0, mesh.count,
                                   static_cast<GLsizei>(mesh.chosen.size()));
        }
    }
    gl.BindVertexArray(0);
}

void PlantLayer::rasterise_positions(const gl::Program& leaves, const GroundTransform& ground,
                                     const Camera& camera, const TileSamples& tile) const {
    if (tallest_ <= 0.0F || !camera.perspective) return;
    const gl::Functions& gl = gl::functions();
    gl.Enable(GL_DEPTH_TEST);
    set_position(leaves, ground, tile);
    for (const auto& of_kind : meshes_) {
        for (const Mesh& mesh : of_kind) {
            if (mesh.chosen.empty()) continue;
            gl.BindVertexArray(mesh.array.name());
            gl.DrawArraysInstanced(GL_TRIANGLES, 0, mesh.count,
                                   static_cast<GLsizei>(mesh.chosen.size()));
        }
    }
    gl.BindVertexArray(0);
}

void PlantLayer::rasterise_depths(const GroundTransform& ground, const Camera& camera,
                                  const TileSamples& tile) {
    if (!depth_program_)
        depth_program_.emplace(
            "position/plant_position.vert.glsl", "streamers/standing.frag.glsl",
            std::initializer_list<const char*>{"leaf", "leaf_normal", "root", "form"});
    depth_program_->use();
    depth_program_->set("forward", glm::vec3(camera.forward));
    rasterise_positions(*depth_program_, ground, camera, tile);
}

}  // namespace fumon
