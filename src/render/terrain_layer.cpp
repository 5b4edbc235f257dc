#include "render/terrain_layer.h"

#include <algorithm>
#include <vector>

#include "render/bed_shading.h"
#include "render/grain.h"

namespace fumon {

namespace {

constexpr double grains_across = 2048.0;  // texels of grain along the block's longer side
constexpr double strongest_grain = 0.30;  // of the colour, from darkest to lightest, at grain = 1

const gl::TextureLayout grain_layout{
    GL_R8, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_REPEAT};

template <class Element>
void fill(const gl::Buffer& buffer, GLenum target, const std::vector<Element>& elements,
          GLenum usage) {
    gl::functions().BindBuffer(target, buffer.name());
    gl::functions().BufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)),
                               elements.data(), usage);
}

void float_attribute(GLuint place, GLint count) {
    gl::functions().VertexAttribPointer(place, count, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl::functions().EnableVertexAttribArray(place);
}

}  // namespace

TerrainLayer::TerrainLayer(const View& view, const Block& block)
    : view_(view),
      block_(block),
      grainy_(view.look.mode == ViewMode::scenic && view.look.grain > 0.0),
      surface_program_("terrain.vert.glsl",
                       grainy_ ? "terrain.frag.glsl" : "terrain_plain.frag.glsl",
                       {"east_north", "height"}),
      side_program_("side.vert.glsl", "side.frag.glsl", {"east_north", "normal", "heights"}),
      grain_(grain_size, grain_size, grain_layout, grain_texels().data()) {
    grain_.make_mipmaps();
}

void TerrainLayer::build(const DisplayBed& bed, int stride, ViewOrder order) {
    mesh_ = terrain_mesh(bed.z.nx(), bed.z.ny(), bed.nodata, stride, order);
    nodata_ = bed.nodata;
    stride_ = stride;
    order_ = order;
    const gl::Functions& gl = gl::functions();

    gl.BindVertexArray(surface_array_.name());
    fill(places_, GL_ARRAY_BUFFER, mesh_.places, GL_STATIC_DRAW);
    float_attribute(0, 2);
    gl.BindBuffer(GL_ARRAY_BUFFER, heights_.name());
    float_attribute(1, 1);
    fill(triangles_, GL_ELEMENT_ARRAY_BUFFER, mesh_.triangles, GL_STATIC_DRAW);

    struct Place {
        MeshPlace at;
        float normal_x;
        float normal_y;
    };
    std::vector<Place> side_places;
    side_places.reserve(mesh_.side_corners.size());
    for (const SideCorner& corner : mesh_.side_corners)
        side_places.push_back({mesh_.places[corner.vertex], corner.normal_x, corner.normal_y});
    gl.BindVertexArray(side_array_.name());
    fill(side_places_, GL_ARRAY_BUFFER, side_places, GL_STATIC_DRAW);
    constexpr auto size = static_cast<GLsizei>(sizeof(Place));
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, size, nullptr);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, size,
                           reinterpret_cast<const void*>(sizeof(MeshPlace)));
    gl.EnableVertexAttribArray(1);
    gl.BindBuffer(GL_ARRAY_BUFFER, side_heights_.name());
    float_attribute(2, 3);
    fill(side_triangles_, GL_ELEMENT_ARRAY_BUFFER, mesh_.side_triangles, GL_STATIC_DRAW);
    gl.BindVertexArray(0);
}

void TerrainLayer::set_bed(const DisplayBed& bed, const Field<float>* water_depth, int stride,
                           ViewOrder order) {
    const bool same_order =
        order.from_south == order_.from_south && order.from_west == order_.from_west;
    if (stride != stride_ || !same_order || bed.nodata != nodata_) build(bed, stride, order);

    std::vector<float> heights(mesh_.samples.size());
    std::transform(mesh_.samples.begin(), mesh_.samples.end(), heights.begin(),
                   [&](std::uint32_t sample) { return bed.z.values()[sample]; });
    const auto depth_at = [&](std::uint32_t vertex) {
        return water_depth == nullptr ? 0.0F : water_depth->values()[mesh_.samples[vertex]];
    };
    const auto base = static_cast<float>(block_.base);
    std::vector<glm::vec3> side_heights(mesh_.side_corners.size());
    std::transform(mesh_.side_corners.begin(), mesh_.side_corners.end(), side_heights.begin(),
                   [&](const SideCorner& corner) {
                       const float ground = heights[corner.vertex];
                       const float surface = ground + depth_at(corner.vertex);
                       const float lower = std::min(base, ground);
                       return glm::vec3(corner.lower > 0.5F ? lower : surface, ground, surface);
                   });
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] += depth_at(static_cast<std::uint32_t>(i));
    fill(heights_, GL_ARRAY_BUFFER, heights, GL_STREAM_DRAW);
    fill(side_heights_, GL_ARRAY_BUFFER, side_heights, GL_STREAM_DRAW);
}

void TerrainLayer::draw(const gl::Texture2D& colours, const Light& light, const Camera& camera,
                        const TileSamples& tile) const {
    gl::functions().Enable(GL_DEPTH_TEST);
    const auto prepare = [&](const gl::Program& program) {
        program.use();
        program.set("clip_from_world", glm::mat4(clip_matrix(camera)));
        program.set("extent", glm::vec2(block_.width_x, block_.width_y));
        program.set("picture_size", tile.picture_size);
        program.set("tile_corner", tile.corner);
        program.set("tile_size", tile.size);
    };
    prepare(surface_program_);
    draw_surface(colours);
    if (view_.look.block_sides && !mesh_.side_triangles.empty()) {
        prepare(side_program_);
        draw_sides(light, camera);
    }
    gl::functions().BindVertexArray(0);
}

void TerrainLayer::draw_surface(const gl::Texture2D& colours) const {
    colours.bind(0);
    surface_program_.set("shaded", 0);
    if (grainy_) {
        grain_.bind(1);
        surface_program_.set("grain", 1);
        const double repeats = grains_across / grain_size;
        surface_program_.set("grain_scale",
                             glm::vec2(repeats * block_.width_x, repeats * block_.width_y));
        surface_program_.set("grain_strength",
                             static_cast<float>(strongest_grain * view_.look.grain));
    }
    gl::functions().BindVertexArray(surface_array_.name());
    gl::functions().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh_.triangles.size()),
                                 GL_UNSIGNED_INT, nullptr);
}

void TerrainLayer::draw_sides(const Light& light, const Camera& camera) const {
    set_light(side_program_, view_, light, camera, block_);
    side_program_.set("turbidity", static_cast<float>(view_.look.turbidity));
    side_program_.set("base", static_cast<float>(block_.base));
    side_program_.set("rock", static_cast<float>(block_.rock));
    side_program_.set("figure", view_.look.mode == ViewMode::figure ? 1.0F : 0.0F);
    gl::functions().BindVertexArray(side_array_.name());
    gl::functions().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh_.side_triangles.size()),
                                 GL_UNSIGNED_INT, nullptr);
}

}  // namespace fumon
