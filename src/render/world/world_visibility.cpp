// What samples see of endless ground: by vector code into memory, or by OpenGL into a target.

#include <algorithm>
#include <optional>
#include <span>

#include "gl/functions.h"
#include "gl/scoped_scissor.h"
#include "render/world/world_layer.h"

namespace fumon {

pixel_class_vectors::ClassBounds WorldLayer::pixel_bounds(const Camera& camera) const {
    const glm::dvec2 from_middle = eye_from_middle(camera);
    const glm::dvec3 eye = reduced_eye(camera);
    return {static_cast<float>(near_limit_),
            static_cast<float>(least_slip_slope * block_.exaggeration),
            1.0F / cell_,
            static_cast<float>(block_.width_x),
            static_cast<float>(block_.width_y),
            copies_.varied(),
            static_cast<float>(from_middle.x),
            static_cast<float>(from_middle.y),
            {slid_.words.data(), slid_.words_per_row(), slid_.nx, slid_.ny, block_.tiles.plain,
             static_cast<float>(eye.x), static_cast<float>(eye.y)}};
}

void WorldLayer::upload_mesh() const {
    if (uploaded_) return;
    positions_.fill(ground_->mesh.positions);
    triangles_.fill(ground_->mesh.triangles);
    uploaded_ = true;
}

PixelSamples WorldLayer::pixel_samples(const TileFrame& tile) const {
    const int rows = ground_rows(tile.camera, tile.picture().y) - tile.rows_below();
    return {tile.first_in_target(), tile.plan.factor, std::clamp(rows, 0, tile.tile.height),
            tile.tile.width, tile.tile.height};
}

void WorldLayer::rasterise_buffer(const TileFrame& tile) {
    const Camera& camera = tile.camera;
    const PixelSamples at = pixel_samples(tile);
    const GroundMesh& mesh = ground_->mesh;
    const std::span<const std::uint32_t> triangles(mesh.triangles);
    // From the second sample before the pixels on: their numbers are by fours.
    const glm::ivec2 before(2);
    const glm::ivec2 size(at.factor * at.columns + before.x + 1,
                          at.factor * (at.rows + 1) + before.y);
    const glm::ivec2 first = at.first - before;
    std::optional<VisibilityBuffer::Pixels> pixels;
    if (at.factor > 1) {
        pixels.emplace();
        pixels->grid = {before, at.factor, at.columns, at.rows, at.all_rows};
        pixels->bounds = pixel_bounds(camera);
    }
    visibility_->rasterise(
        {mesh.positions, triangles.first(mesh.near_indices), triangles.subspan(mesh.near_indices)},
        at_origin(camera, fan_of(camera, *heights_)),
        {at.factor * tile.picture(), tile.target_corner() + first, size}, first, pixels, tile.pool);
}

void WorldLayer::copy_visibility(const TileFrame& tile) const {
    const Camera& camera = tile.camera;
    const PixelSamples at = pixel_samples(tile);
    const gl::Functions& gl = gl::functions();
    const gl::ScopedScissor scissor(at.first, at.factor * glm::ivec2(at.columns, at.rows));
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_ALWAYS);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl.BindVertexArray(no_attributes_.name());
    const Camera there = at_origin(camera, fan_of(camera, *heights_));
    copy_program_->use();
    visibility_->bind(*copy_program_, visibility_unit);
    copy_program_->set("depth_range", glm::vec2(there.near_depth, there.far_depth));
    for (const GLint ground : {near_stencil, far_stencil}) {
        copy_program_->set("ground", ground);
        gl.StencilFunc(GL_ALWAYS, ground, 0xFF);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl.DepthFunc(GL_LESS);
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void WorldLayer::rasterise(const Camera& camera, const TileSamples& tile, bool mark_far) const {
    const gl::Functions& gl = gl::functions();
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    visibility_program_.use();
    visibility_program_.set("clip_from_eye", clip_from_eye(camera));
    visibility_program_.set("picture_size", tile.picture_size);
    visibility_program_.set("tile_corner", tile.corner);
    visibility_program_.set("tile_size", tile.size);
    gl.BindVertexArray(array_.name());
    upload_mesh();
    const auto near = static_cast<GLsizei>(ground_->mesh.near_indices);
    const auto all = static_cast<GLsizei>(ground_->mesh.triangles.size());
    const auto draw = [&](GLint stencil, GLsizei first, GLsizei count) {
        if (count == 0) return;
        visibility_program_.set("side", mark_far && stencil == far_stencil ? -1.0F : 1.0F);
        gl.StencilFunc(GL_ALWAYS, stencil, 0xFF);
        gl.DrawElements(
            GL_TRIANGLES, count, GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(sizeof(std::uint32_t) * static_cast<std::size_t>(first)));
    };
    draw(near_stencil, 0, near);
    draw(far_stencil, near, all - near);
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

}  // namespace fumon
