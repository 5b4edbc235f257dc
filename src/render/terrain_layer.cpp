#include "render/terrain_layer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "render/bed_shading.h"
#include "render/grain.h"
#include "render/view/framing.h"

namespace fumon {

namespace {

constexpr double grains_across = 2048.0;  // texels of grain along the block's longer side
constexpr double strongest_grain = 0.30;  // of the colour, from darkest to lightest, at grain = 1

const gl::TextureLayout grain_layout{
    GL_R8, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_REPEAT, 3};

/// A corner of a side face as side.vert.glsl takes it.
struct SideCorner {
    MeshPlace at;
    float face;
    float height;
};

/// A side face as side.frag.glsl reads it.
struct FaceTexels {
    MeshPlace from, to;
    MeshPlace normal_from, normal_to;
    float ground_from, ground_to, surface_from, surface_to;
};

constexpr GLint surface_stencil = 1;
constexpr GLint side_stencil = 2;

void float_attribute(GLuint place, GLint count, std::size_t stride, std::size_t offset) {
    const gl::Functions& gl = gl::functions();
    gl.VertexAttribPointer(place, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                           reinterpret_cast<const void*>(offset));
    gl.EnableVertexAttribArray(place);
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

TerrainLayer::TerrainLayer(const View& view, const Block& block, const gl::Constants& fixed)
    : view_(view),
      block_(block),
      grainy_(view.look.mode == ViewMode::scenic && view.look.grain > 0.0),
      surface_program_("terrain.vert.glsl", "seen.frag.glsl", {"east_north", "height"}),
      side_program_("side.vert.glsl", "seen.frag.glsl", {"east_north", "face", "height"}),
      surface_colours_("screen.vert.glsl",
                       grainy_ ? "terrain.frag.glsl" : "terrain_plain.frag.glsl"),
      side_colours_("screen.vert.glsl", "side.frag.glsl", {}, fixed),
      grain_(grain_size, grain_size, grain_layout, grain_texels().data()) {
    grain_.make_mipmaps();
}

void TerrainLayer::build(const DisplayBed& bed, int stride) {
    lattice_ = terrain_lattice(bed.z.nx(), bed.z.ny(), bed.nodata, stride);
    rim_ = rim_faces(lattice_, bed.nodata);
    nodata_ = bed.nodata;
    stride_ = stride;
    const gl::Functions& gl = gl::functions();

    gl.BindVertexArray(surface_array_.name());
    places_.fill(lattice_.places);
    float_attribute(0, 2, sizeof(MeshPlace), 0);
    heights_.bind();
    float_attribute(1, 1, sizeof(float), 0);
    triangles_.bind();

    gl.BindVertexArray(side_array_.name());
    side_corners_.bind();
    constexpr std::size_t size = sizeof(SideCorner);
    float_attribute(0, 2, size, offsetof(SideCorner, at));
    float_attribute(1, 1, size, offsetof(SideCorner, face));
    float_attribute(2, 1, size, offsetof(SideCorner, height));
    side_triangles_.bind();
    gl.BindVertexArray(0);
}

void TerrainLayer::set_bed(const DisplayBed& bed, const Field<float>* water_depth,
                           const Camera& camera) {
    const double cell = pixels_per_length(camera, view_) * std::max(bed.dx, bed.dy);
    const int stride = lattice_stride(cell);
    if (stride != stride_ || bed.nodata != nodata_) build(bed, stride);

    surface_.resize(lattice_.cells.size());
    for (std::size_t i = 0; i < surface_.size(); ++i) {
        const std::uint32_t at = lattice_.cells[i];
        surface_[i] = bed.z.values()[at];
        if (water_depth != nullptr) surface_[i] += water_depth->values()[at];
    }
    const ViewOrder order{camera.forward.y >= 0.0, camera.forward.x >= 0.0};
    const TerrainMesh mesh = mesher_.mesh(lattice_, surface_, screen_scale(camera, view_, block_),
                                          largest_square(stride * cell), order);
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(surface_array_.name());
    heights_.fill(surface_);
    triangles_.fill(mesh.triangles);
    indices_ = static_cast<GLsizei>(mesh.triangles.size());
    std::vector<SideFace> faces = rim_;
    faces.insert(faces.end(), mesh.sides.begin(), mesh.sides.end());
    set_sides(faces, bed);
    gl.BindVertexArray(0);
}

void TerrainLayer::set_sides(const std::vector<SideFace>& faces, const DisplayBed& bed) {
    const auto base = static_cast<float>(block_.base);
    const auto ground = [&](std::uint32_t vertex) {
        return bed.z.values()[lattice_.cells[vertex]];
    };
    std::vector<SideCorner> corners;
    std::vector<std::uint32_t> triangles;
    std::vector<FaceTexels> texels;
    corners.reserve(4 * faces.size());
    triangles.reserve(6 * faces.size());
    texels.reserve(faces.size());
    for (const SideFace& face : faces) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        const auto number = static_cast<float>(texels.size());
        const auto add = [&](std::uint32_t vertex, float along, bool lower) {
            corners.push_back({lattice_.places[vertex], number + 0.125F + 0.75F * along,
                               lower ? std::min(base, ground(vertex)) : surface_[vertex]});
        };
        add(face.from, 0.0F, true);
        add(face.to, 1.0F, true);
        add(face.to, 1.0F, false);
        add(face.from, 0.0F, false);
        for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) triangles.push_back(first + k);
        texels.push_back({lattice_.places[face.from], lattice_.places[face.to], face.normal_from,
                          face.normal_to, ground(face.from), ground(face.to), surface_[face.from],
                          surface_[face.to]});
    }
    gl::functions().BindVertexArray(side_array_.name());
    faces_.fill(texels);
    side_corners_.fill(corners);
    side_triangles_.fill(triangles);
    side_indices_ = static_cast<GLsizei>(triangles.size());
}

void TerrainLayer::draw_seen(const Camera& camera, const TileSamples& tile) const {
    const gl::Functions& gl = gl::functions();
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    const bool from_above =
        camera.perspective ? camera.eye.z > block_.base : camera.forward.z < 0.0;
    const bool closed = view_.look.block_sides && from_above;  // so no back is seen
    if (closed) gl.Enable(GL_CULL_FACE);
    const auto prepare = [&](const gl::Program& program) {
        program.use();
        program.set("clip_from_world", glm::mat4(clip_matrix(camera)));
        program.set("extent", glm::vec2(block_.width_x, block_.width_y));
        program.set("picture_size", tile.picture_size);
        program.set("tile_corner", tile.corner);
        program.set("tile_size", tile.size);
    };
    prepare(surface_program_);
    gl.StencilFunc(GL_ALWAYS, surface_stencil, 0xFF);
    gl.BindVertexArray(surface_array_.name());
    gl.DrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    if (view_.look.block_sides && side_indices_ > 0) {
        prepare(side_program_);
        gl.StencilFunc(GL_ALWAYS, side_stencil, 0xFF);
        gl.BindVertexArray(side_array_.name());
        gl.DrawElements(GL_TRIANGLES, side_indices_, GL_UNSIGNED_INT, nullptr);
    }
    gl.Disable(GL_CULL_FACE);
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void TerrainLayer::colour_seen(const gl::Texture2D& seen, const gl::Texture2D& colours,
                               const Light& light, const Camera& camera) const {
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.BindVertexArray(no_attributes_.name());
    seen.bind(2);
    surface_colours_.use();
    surface_colours_.set("seen", 2);
    colour_surface(colours);
    gl.StencilFunc(GL_EQUAL, surface_stencil, 0xFF);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    if (view_.look.block_sides && side_indices_ > 0) {
        side_colours_.use();
        side_colours_.set("seen", 2);
        colour_sides(light, camera);
        gl.StencilFunc(GL_EQUAL, side_stencil, 0xFF);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void TerrainLayer::colour_surface(const gl::Texture2D& colours) const {
    colours.bind(0);
    surface_colours_.set("shaded", 0);
    if (grainy_) {
        grain_.bind(1);
        surface_colours_.set("grain", 1);
        const double repeats = grains_across / grain_size;
        surface_colours_.set("grain_scale",
                             glm::vec2(repeats * block_.width_x, repeats * block_.width_y));
        surface_colours_.set("grain_strength",
                             static_cast<float>(strongest_grain * view_.look.grain));
    }
}

void TerrainLayer::colour_sides(const Light& light, const Camera& camera) const {
    set_light(side_colours_, view_, light, camera, block_);
    side_colours_.set("turbidity", static_cast<float>(view_.look.turbidity));
    side_colours_.set("base", static_cast<float>(block_.base));
    side_colours_.set("rock", static_cast<float>(block_.rock));
    side_colours_.set("figure", view_.look.mode == ViewMode::figure ? 1.0F : 0.0F);
    side_colours_.set("extent", glm::vec2(block_.width_x, block_.width_y));
    const gl::Functions& gl = gl::functions();
    gl.ActiveTexture(GL_TEXTURE0 + 3);
    gl.BindTexture(GL_TEXTURE_BUFFER, faces_texture_.name());
    gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, faces_.name());
    side_colours_.set("faces", 3);
}

}  // namespace fumon
