#include "render/air/air_layer.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace fumon {

namespace {

constexpr double inside_edge = 1e-4;  // block lengths: the strip's own side hides the rest
constexpr int finest_sheet = 2048;    // texels along the sheet
constexpr const char* air_palette = "oslo";

const gl::TextureLayout sheet_layout{
    GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_CLAMP_TO_EDGE};

void fill(const gl::VertexArray& array, const gl::Buffer& buffer, const AirVertex* vertices,
          std::size_t count) {
    const gl::Functions& gl = gl::functions();
    constexpr auto size = static_cast<GLsizei>(sizeof(AirVertex));
    gl.BindVertexArray(array.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * sizeof(AirVertex)), vertices,
                  GL_STREAM_DRAW);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, size, nullptr);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, size,
                           reinterpret_cast<const void*>(offsetof(AirVertex, paint)));
    gl.EnableVertexAttribArray(1);
    gl.BindVertexArray(0);
}

}  // namespace

AirLayer::AirLayer(const Block& block, const Camera& camera, int picture_side,
                   const gl::Constants& fixed, const gl::MipmapMaker& mipmaps)
    : mipmaps_(mipmaps),
      far_edge_((camera.forward.y >= 0.0 ? 1.0 : -1.0) * (0.5 * block.width_y - inside_edge)),
      texture_width_(std::min(picture_side, finest_sheet)),
      palette_(read_palette(air_palette)),
      behind_program_("common/screen.vert.glsl", "air/behind.frag.glsl"),
      sheet_program_("air/air.vert.glsl", "air/air_sheet.frag.glsl", {"point", "paint"}, fixed),
      path_program_("air/air.vert.glsl", "air/air_paths.frag.glsl", {"point", "paint"}, fixed) {}

void AirLayer::set_air(const Snapshot& strip, const Block& block, const Camera& camera,
                       WorkerPool& pool) {
    const SectionAir air(strip);
    const double unit = strip.scale.height_unit;
    const double low = *std::min_element(strip.bed.values().begin(), strip.bed.values().end());
    sheet_ = paint_air_sheet(air, palette_, texture_width_, low * unit, block.exaggeration, pool);
    if (!texture_ || texture_->width() != sheet_.width || texture_->height() != sheet_.height)
        texture_.emplace(sheet_.width, sheet_.height, sheet_layout);
    texture_->upload(sheet_.rgba.data());
    mipmaps_.make(*texture_);

    const auto corner = [&](double east, double up) {
        const double z = block.z((up > 0.5 ? sheet_.high : sheet_.low) / unit);
        return AirVertex{glm::vec3((east - 0.5) * block.width_x, far_edge_, z),
                         glm::vec4(east, up, 0.0F, 0.0F)};
    };
    const std::array<AirVertex, 6> quad = {corner(0, 0), corner(1, 0), corner(1, 1),
                                           corner(0, 0), corner(1, 1), corner(0, 1)};
    fill(sheet_array_, sheet_vertices_, quad.data(), quad.size());
    const std::vector<AirVertex> paths = grain_paths(strip, block, camera);
    path_count_ = static_cast<int>(paths.size());
    fill(path_array_, path_vertices_, paths.data(), paths.size());
}

void AirLayer::draw_behind(const gl::Texture2D& surroundings, int factor, glm::ivec2 margin,
                           glm::ivec2 pixels) const {
    gl::functions().Disable(GL_DEPTH_TEST);
    behind_program_.use();
    surroundings.bind(0);
    behind_program_.set("background", 0);
    behind_program_.set("factor", factor);
    behind_program_.set("margin_x", margin.x);
    behind_program_.set("margin_y", margin.y);
    behind_program_.set("columns", pixels.x);
    behind_program_.set("rows", pixels.y);
    gl::functions().DrawArrays(GL_TRIANGLES, 0, 3);
}

void AirLayer::draw(const Camera& camera, const TileSamples& tile) const {
    const gl::Functions& gl = gl::functions();
    const auto prepare = [&](const gl::Program& program) {
        program.use();
        program.set("clip_from_world", glm::mat4(clip_matrix(camera)));
        program.set("picture_size", tile.picture_size);
        program.set("tile_corner", tile.corner);
        program.set("tile_size", tile.size);
    };
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthMask(GL_FALSE);
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    prepare(sheet_program_);
    texture_->bind(0);
    sheet_program_.set("sheet", 0);
    gl.BindVertexArray(sheet_array_.name());
    gl.DrawArrays(GL_TRIANGLES, 0, 6);
    prepare(path_program_);
    gl.BindVertexArray(path_array_.name());
    gl.DrawArrays(GL_TRIANGLES, 0, path_count_);
    gl.BindVertexArray(0);
    gl.Disable(GL_BLEND);
    gl.DepthMask(GL_TRUE);
}

}  // namespace fumon
