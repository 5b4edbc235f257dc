#include <algorithm>

#include "gl/functions.h"
#include "render/terrain_layer.h"

namespace fumon {

namespace {

constexpr int surface_kind = 1;  // of block/block_samples.glsl; sides are the next ones
constexpr int block_unit = 2;
constexpr double around_box = 0.01;  // block lengths: more than a pixel
// Between the depths that block/block_pixels.frag.glsl gives: what lies behind is done.
constexpr double behind_edges = 0.5;
constexpr double behind_sides = 0.75;
constexpr double of_wholes = 0.875;  // one of these depths

}  // namespace

const TerrainLayer::PixelPrograms& TerrainLayer::by_pixel() {
    if (!by_pixel_)
        by_pixel_.emplace(PixelPrograms{
            {"block/terrain.vert.glsl", "block/seen_kind.frag.glsl", {"east_north", "height"}},
            {"block/side.vert.glsl",
             "block/seen_kind.frag.glsl",
             {"east_north", "normal", "heights"}},
            {"block/block_cover.vert.glsl", "block/block_pixels.frag.glsl", {}, fixed_},
            {"block/block_cover.vert.glsl", "block/block_edges.frag.glsl", {}, fixed_},
            {"block/side.vert.glsl",
             "block/side_pixels.frag.glsl",
             {"east_north", "normal", "heights"},
             fixed_}});
    return *by_pixel_;
}

TerrainLayer::Box TerrainLayer::box_around() const {
    const glm::dvec2 half = 0.5 * glm::dvec2(block_.width_x, block_.width_y) + around_box;
    double lowest = std::min(static_cast<double>(height_range_.x), block_.base);
    double highest = static_cast<double>(height_range_.y);
    for (const float height : surface_) {
        lowest = std::min(lowest, static_cast<double>(height));
        highest = std::max(highest, static_cast<double>(height));
    }
    return {glm::dvec3(-half, lowest - around_box), glm::dvec3(half, highest + around_box)};
}

void TerrainLayer::draw_kinds(const Camera& camera, const TileSamples& tile) {
    const gl::Functions& gl = gl::functions();
    const PixelPrograms& programs = by_pixel();
    gl.Enable(GL_DEPTH_TEST);
    if (no_back_is_seen(camera)) gl.Enable(GL_CULL_FACE);
    place(programs.surface, camera, tile);
    programs.surface.set("kind", surface_kind);
    gl.BindVertexArray(surface_array_.name());
    gl.DrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    if (view_.look.block_sides) {
        place(programs.sides, camera, tile);
        gl.BindVertexArray(side_array_.name());
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            programs.sides.set("kind", surface_kind + 1 + static_cast<int>(i));
            draw_triangles(faces_[i].first_drawn, faces_[i].drawn.size());
        }
    }
    gl.Disable(GL_CULL_FACE);
    gl.BindVertexArray(0);
}

void TerrainLayer::colour_pixels(const gl::Texture2D& seen, const gl::Texture2D& colours,
                                 const Light& light, const Camera& camera,
                                 const TileSamples& tile) {
    const gl::Functions& gl = gl::functions();
    const PixelPrograms& programs = by_pixel();
    const Box box = box_around();
    const bool outside = !camera.perspective || glm::any(glm::lessThan(camera.eye, box.lowest)) ||
                         glm::any(glm::greaterThan(camera.eye, box.highest));
    const auto draw_covered = [&](const gl::Program& program) {
        place(program, camera, tile);
        program.set("lowest", glm::vec3(box.lowest));
        program.set("highest", glm::vec3(box.highest));
        program.set("seen", block_unit);
        program.set("texels", glm::vec2(colours.width(), colours.height()));
        set_surface(program, colours);
        gl.Enable(GL_CULL_FACE);
        gl.CullFace(outside ? GL_BACK : GL_FRONT);
        gl.BindVertexArray(no_attributes_.name());
        gl.DrawArrays(GL_TRIANGLES, 0, 36);
        gl.CullFace(GL_BACK);
        gl.Disable(GL_CULL_FACE);
    };
    seen.bind(block_unit);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_ALWAYS);
    draw_covered(programs.pixels);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_GREATER);
    gl.DepthRange(behind_edges, behind_edges);
    draw_covered(programs.edges);
    if (view_.look.block_sides) {
        gl.Enable(GL_BLEND);
        gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
        gl.DepthRange(behind_sides, behind_sides);
        if (no_back_is_seen(camera)) gl.Enable(GL_CULL_FACE);
        place(programs.side_pixels, camera, tile);
        programs.side_pixels.set("seen", block_unit);
        set_sides(programs.side_pixels, light, camera);
        gl.BindVertexArray(side_array_.name());
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            programs.side_pixels.set("kind", surface_kind + 1 + static_cast<int>(i));
            draw_triangles(faces_[i].first_coloured, faces_[i].coloured.size());
        }
        gl.Disable(GL_CULL_FACE);
        gl.Disable(GL_BLEND);
    }
    gl.DepthRange(0.0, 1.0);
    gl.DepthFunc(GL_LESS);
    gl.DepthMask(GL_TRUE);
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(0);
}

void TerrainLayer::beside_whole_pixels(const std::function<void()>& draw) {
    const gl::Functions& gl = gl::functions();
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_NOTEQUAL);
    gl.DepthRange(of_wholes, of_wholes);
    draw();
    gl.DepthRange(0.0, 1.0);
    gl.DepthFunc(GL_LESS);
    gl.DepthMask(GL_TRUE);
    gl.Disable(GL_DEPTH_TEST);
}

}  // namespace fumon
