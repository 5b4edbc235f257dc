#include "render/block/terrain_layer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "render/colour/grain.h"
#include "render/frame/view_uniforms.h"
#include "render/ground/outline_rim.h"
#include "render/view/bilinear_height.h"
#include "render/view/framing.h"

namespace fumon {

namespace {

constexpr double grains_across = 2048.0;  // texels of grain along the block's longer side
constexpr double strongest_grain = 0.30;  // of the colour, from darkest to lightest, at grain = 1

const gl::TextureLayout grain_layout{
    GL_R8, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_REPEAT, 3};

/// A corner of a side face as block/side.vert.glsl takes it.
struct SideCorner {
    MeshPosition at;
    MeshPosition normal;
    float height;
    float ground;
    float surface;
};

constexpr GLint surface_stencil = 1;
constexpr GLint rim_stencil = 2;     // around cells without data
constexpr GLint border_stencil = 3;  // and the next three
// By which the rectangle around a border's faces is larger, in block lengths: more than rounding.
constexpr float around_faces = 0.01F;

constexpr std::array<MeshPosition, 4> border_normals = {
    {{-1.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, -1.0F}, {0.0F, 1.0F}}};

void float_attribute(GLuint position, GLint count, std::size_t stride, std::size_t offset) {
    const gl::Functions& gl = gl::functions();
    gl.VertexAttribPointer(position, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                           reinterpret_cast<const void*>(offset));
    gl.EnableVertexAttribArray(position);
}

/// With its mipmaps: a driver that makes them compiles shaders for that.
gl::Texture2D grain_texture() {
    std::vector<std::uint8_t> texels = grain_texels();
    gl::Texture2D grain(grain_size, grain_size, grain_layout, texels.data());
    for (int level = 1; level <= grain_layout.coarsest_mip_level; ++level) {
        texels = downsampled_texels(texels, grain_size >> (level - 1));
        grain.set_mipmap(level, texels.data());
    }
    return grain;
}

/// How large heights are on the screen over a block.
ScreenScale screen_scale(const Camera& camera, const View& view, const Block& block) {
    ScreenScale scale;
    scale.pixels =
        static_cast<float>(pixels_per_length(camera, view) * std::max(camera.up.z, 0.05));
    if (!camera.perspective) return scale;
    const double middle = std::max(-glm::dot(camera.eye, camera.forward), 0.05);
    const double east = camera.forward.x * block.width_x / middle;
    const double north = camera.forward.y * block.width_y / middle;
    scale.depth_east = static_cast<float>(east);
    scale.depth_north = static_cast<float>(north);
    scale.depth = static_cast<float>(1.0 - 0.5 * (east + north));
    return scale;
}

}  // namespace

TerrainLayer::TerrainLayer(const View& view, const Block& block, const gl::Constants& fixed,
                           bool by_pixels)
    : view_(view),
      block_(block),
      grainy_(view.look.mode == ViewMode::scenic && view.look.grain > 0.0),
      by_pixels_(by_pixels),
      fixed_(fixed) {}

const TerrainLayer::SamplePrograms& TerrainLayer::by_sample() {
    if (grainy_ && !grain_) grain_.emplace(grain_texture());
    if (!by_sample_)
        by_sample_.emplace(SamplePrograms{
            {"block/terrain.vert.glsl",
             by_pixels_ ? "block/visibility_surface.frag.glsl" : "block/visibility.frag.glsl",
             {"east_north", "height"}},
            {"block/side.vert.glsl",
             "block/visibility.frag.glsl",
             {"east_north", "normal", "heights"}},
            {"common/screen.vert.glsl",
             by_pixels_ ? "block/terrain_of_pixels.frag.glsl"
             : grainy_  ? "block/terrain.frag.glsl"
                        : "block/terrain_plain.frag.glsl",
             {},
             fixed_},
            {"block/side.vert.glsl",
             "block/side.frag.glsl",
             {"east_north", "normal", "heights"},
             fixed_}});
    return *by_sample_;
}

void TerrainLayer::build(const DisplayBed& bed, int stride) {
    lattice_ = terrain_lattice(bed.z.nx(), bed.z.ny(), bed.nodata, stride);
    moved_ = move_rim(lattice_, bed);
    rim_ = rim_faces(lattice_, static_cast<float>(block_.width_x / block_.width_y));
    nodata_ = bed.nodata;
    stride_ = stride;
    const gl::Functions& gl = gl::functions();

    gl.BindVertexArray(surface_array_.name());
    positions_.fill(lattice_.positions);
    float_attribute(0, 2, sizeof(MeshPosition), 0);
    heights_.bind();
    float_attribute(1, 1, sizeof(float), 0);
    triangles_.bind();

    gl.BindVertexArray(side_array_.name());
    side_corners_.bind();
    constexpr std::size_t size = sizeof(SideCorner);
    float_attribute(0, 2, size, offsetof(SideCorner, at));
    float_attribute(1, 2, size, offsetof(SideCorner, normal));
    float_attribute(2, 3, size, offsetof(SideCorner, height));
    side_triangles_.bind();
    gl.BindVertexArray(0);
}

void TerrainLayer::set_bed(const DisplayBed& bed, const Field<float>* water_depth,
                           const Camera& camera) {
    const double cell = pixels_per_length(camera, view_) * std::max(bed.dx, bed.dy);
    const int stride = lattice_stride(cell);
    if (stride != stride_ || bed.nodata != nodata_) build(bed, stride);

    surface_.resize(lattice_.cells.size());
    ground_.resize(surface_.size());
    for (std::size_t i = 0; i < surface_.size(); ++i) {
        const std::uint32_t at = lattice_.cells[i];
        ground_[i] = bed.z.values()[at];
        surface_[i] = water_depth ? ground_[i] + water_depth->values()[at] : ground_[i];
    }
    for (const std::uint32_t vertex : moved_) {
        const glm::dvec2 share(lattice_.positions[vertex].east, lattice_.positions[vertex].north);
        ground_[vertex] = bilinear_height(bed.z, share, false);
        surface_[vertex] = ground_[vertex];
        if (water_depth != nullptr) surface_[vertex] += bilinear_height(*water_depth, share, false);
    }
    if (by_pixels_) {
        if (!grain_) grain_.emplace(grain_texture());
        const auto [lowest, highest] = std::minmax_element(surface_.begin(), surface_.end());
        height_span_ = {*lowest, std::max(*highest - *lowest, 1e-6F)};
    }
    const ViewOrder order{camera.forward.y >= 0.0, camera.forward.x >= 0.0};
    mesh_ = mesher_.mesh(lattice_, surface_, screen_scale(camera, view_, block_),
                         largest_square(stride * cell), order);
    uploaded_ = false;
    strips_made_ = false;
    watery_ = water_depth != nullptr;
    set_sides(mesh_.sides);
    gl::functions().BindVertexArray(0);
}

void TerrainLayer::upload_surface() {
    if (uploaded_) return;
    uploaded_ = true;
    gl::functions().BindVertexArray(surface_array_.name());
    heights_.fill(surface_);
    triangles_.fill(mesh_.triangles);
    indices_ = static_cast<GLsizei>(mesh_.triangles.size());
    gl::functions().BindVertexArray(0);
}

void TerrainLayer::set_sides(const std::vector<SideFace>& borders) {
    const auto base = static_cast<float>(block_.base);
    const auto lower = [&](std::uint32_t vertex) { return std::min(base, ground_[vertex]); };
    std::vector<SideCorner> corners;
    corners.reserve(4 * (rim_.size() + borders.size()));
    float lowest = base;
    float highest = base + 1e-6F;
    const auto add_rectangle = [&](std::vector<std::uint32_t>& triangles,
                                   const std::array<SideCorner, 4>& rectangle) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        corners.insert(corners.end(), rectangle.begin(), rectangle.end());
        for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) triangles.push_back(first + k);
    };
    const auto add_face = [&](Faces& faces, const SideFace& face) {
        const auto corner = [&](std::uint32_t vertex, MeshPosition normal, bool low) {
            lowest = std::min(lowest, lower(vertex));
            highest = std::max({highest, surface_[vertex], ground_[vertex]});
            return SideCorner{lattice_.positions[vertex], normal,
                              low ? lower(vertex) : surface_[vertex], ground_[vertex],
                              surface_[vertex]};
        };
        add_rectangle(
            faces.drawn,
            {corner(face.from, face.normal_from, true), corner(face.to, face.normal_to, true),
             corner(face.to, face.normal_to, false), corner(face.from, face.normal_from, false)});
    };
    faces_.clear();
    faces_.push_back({rim_stencil, false, {}, 0, {}, 0});
    for (const SideFace& face : rim_) add_face(faces_.back(), face);
    faces_.back().coloured = faces_.back().drawn;
    for (std::size_t side = 0; side < border_normals.size(); ++side) {
        const MeshPosition normal = border_normals[side];
        Faces faces{border_stencil + static_cast<GLint>(side), true, {}, 0, {}, 0};
        for (const SideFace& face : borders) {
            if (face.normal_from.east != normal.east || face.normal_from.north != normal.north)
                continue;
            add_face(faces, face);
        }
        faces_.push_back(std::move(faces));
    }
    for (std::size_t side = 0; side < border_normals.size(); ++side) {
        Faces& faces = faces_[1 + side];
        if (faces.drawn.empty()) continue;
        // From left to right as seen from outside.
        const MeshPosition normal = border_normals[side];
        const auto corner = [&](float along, float height) {
            return SideCorner{{0.5F + 0.5F * normal.east - along * normal.north,
                               0.5F + 0.5F * normal.north + along * normal.east},
                              normal,
                              height,
                              0.0F,
                              0.0F};
        };
        const float half = 0.5F + around_faces / std::min(static_cast<float>(block_.width_x),
                                                          static_cast<float>(block_.width_y));
        add_rectangle(
            faces.coloured,
            {corner(-half, lowest - around_faces), corner(half, lowest - around_faces),
             corner(half, highest + around_faces), corner(-half, highest + around_faces)});
    }
    height_range_ = {lowest, highest};
    std::vector<std::uint32_t> triangles;
    for (Faces& faces : faces_) {
        faces.first_drawn = triangles.size();
        triangles.insert(triangles.end(), faces.drawn.begin(), faces.drawn.end());
        faces.first_coloured = triangles.size();
        triangles.insert(triangles.end(), faces.coloured.begin(), faces.coloured.end());
    }
    side_positions_.clear();
    side_heights_.clear();
    for (const SideCorner& corner : corners) {
        side_positions_.push_back(corner.at.east);
        side_positions_.push_back(corner.at.north);
        side_heights_.push_back(corner.height);
    }
    gl::functions().BindVertexArray(side_array_.name());
    side_corners_.fill(corners);
    side_triangles_.fill(triangles);
}

void TerrainLayer::set_transform(const gl::Program& program, const Camera& camera,
                                 const TileSamples& tile) const {
    program.use();
    program.set("clip_from_world", glm::mat4(clip_matrix(camera)));
    program.set("extent", glm::vec2(block_.width_x, block_.width_y));
    program.set("picture_size", tile.picture_size);
    program.set("tile_corner", tile.corner);
    program.set("tile_size", tile.size);
    program.set("height_range", height_range_);
    program.set("height_span", height_span_);
}

bool TerrainLayer::backs_are_hidden(const Camera& camera) const {
    const bool from_above =
        camera.perspective ? camera.eye.z > block_.base : camera.forward.z < 0.0;
    return view_.look.block_sides && from_above;
}

void TerrainLayer::draw_triangles(std::size_t first, std::size_t count) {
    if (count == 0) return;
    gl::functions().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                                 reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

void TerrainLayer::rasterise(const Camera& camera, const TileSamples& tile) {
    const gl::Functions& gl = gl::functions();
    const SamplePrograms& programs = by_sample();
    upload_surface();
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    if (backs_are_hidden(camera)) gl.Enable(GL_CULL_FACE);
    set_transform(programs.surface, camera, tile);
    gl.StencilFunc(GL_ALWAYS, surface_stencil, 0xFF);
    gl.BindVertexArray(surface_array_.name());
    gl.DrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    if (view_.look.block_sides) {
        set_transform(programs.sides, camera, tile);
        gl.BindVertexArray(side_array_.name());
        for (const Faces& faces : faces_) {
            gl.StencilFunc(GL_ALWAYS, faces.stencil, 0xFF);
            draw_triangles(faces.first_drawn, faces.drawn.size());
        }
    }
    gl.Disable(GL_CULL_FACE);
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void TerrainLayer::shade_samples(const gl::Texture2D& visibility, const gl::Texture2D& colours,
                                 const Light& light, const Camera& camera, const TileSamples& tile,
                                 const glm::ivec2& offset) {
    const gl::Functions& gl = gl::functions();
    const SamplePrograms& programs = by_sample();
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    visibility.bind(2);
    programs.surface_colours.use();
    programs.surface_colours.set("visibility", 2);
    set_surface(programs.surface_colours, colours);
    programs.surface_colours.set("sample_offset", glm::vec2(offset));
    gl.StencilFunc(GL_EQUAL, surface_stencil, 0xFF);
    gl.BindVertexArray(no_attributes_.name());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    if (view_.look.block_sides) {
        set_transform(programs.side_colours, camera, tile);
        programs.side_colours.set("visibility", 2);
        set_sides(programs.side_colours, light, camera);
        gl.BindVertexArray(side_array_.name());
        gl.DepthMask(GL_FALSE);
        gl.DepthFunc(GL_LEQUAL);
        for (const Faces& faces : faces_) {
            // A rim may stand before another one.
            if (!faces.in_one_plane) gl.Enable(GL_DEPTH_TEST);
            gl.StencilFunc(GL_EQUAL, faces.stencil, 0xFF);
            draw_triangles(faces.first_coloured, faces.coloured.size());
            gl.Disable(GL_DEPTH_TEST);
        }
        gl.DepthFunc(GL_LESS);
        gl.DepthMask(GL_TRUE);
    }
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void TerrainLayer::rasterise_positions(const gl::Program& surface, const gl::Program& sides,
                                       const Camera& camera, const TileSamples& tile) {
    const gl::Functions& gl = gl::functions();
    upload_surface();
    gl.Enable(GL_DEPTH_TEST);
    if (backs_are_hidden(camera)) gl.Enable(GL_CULL_FACE);
    set_transform(surface, camera, tile);
    gl.BindVertexArray(surface_array_.name());
    gl.DrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    if (view_.look.block_sides) {
        set_transform(sides, camera, tile);
        gl.BindVertexArray(side_array_.name());
        for (const Faces& faces : faces_) draw_triangles(faces.first_drawn, faces.drawn.size());
    }
    gl.Disable(GL_CULL_FACE);
    gl.BindVertexArray(0);
}

glm::vec2 TerrainLayer::grain_over_block() const {
    return {grains_across * block_.width_x, grains_across * block_.width_y};
}

float TerrainLayer::grain_strength() const {
    return grainy_ ? static_cast<float>(strongest_grain * view_.look.grain) : 0.0F;
}

void TerrainLayer::set_surface(const gl::Program& program, const gl::Texture2D& colours) const {
    colours.bind(0);
    program.set("shaded", 0);
    if (grainy_) set_grain(program, 1);
}

void TerrainLayer::set_grain(const gl::Program& program, int unit) const {
    grain_->bind(unit);
    program.set("grain", unit);
    program.set("grain_scale", grain_over_block() / static_cast<float>(grain_size));
    program.set("grain_strength", grain_strength());
}

void TerrainLayer::set_sides(const gl::Program& program, const Light& light,
                             const Camera& camera) const {
    set_light(program, view_, light, camera, block_);
    program.set("turbidity", turbidity_);
    set_sand(program, view_.look);
    program.set("pixels", static_cast<float>(pixels_per_length(camera, view_)));
    program.set("clarity", clarity_);
    program.set("watery", watery_ ? 1.0F : 0.0F);
    program.set("base", static_cast<float>(block_.base));
    program.set("rock", static_cast<float>(block_.rock));
    program.set("figure", view_.look.mode == ViewMode::figure ? 1.0F : 0.0F);
    const double line = std::max(1.0, view_.image.dots_per_inch / 144.0);  // half a point
    program.set("side_line", static_cast<float>(line / pixels_per_length(camera, view_)));
    program.set("upright", static_cast<float>(std::max(camera.up.z, 0.1)));
}

}  // namespace fumon
