#include "render/world/world_layer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "gl/scoped_scissor.h"
#include "render/frame/view_uniforms.h"
#include "render/streamers/streamer_layer.h"

namespace fumon {

namespace {

// Two channels of four: llvmpipe looks those up in half the time that it takes for GL_RG8.
const gl::TextureLayout surface_layout{
    GL_RGBA8, GL_RG, GL_UNSIGNED_BYTE, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT};
const gl::TextureLayout detail_layout{
    GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT};
constexpr int relief_texels = 512;
const gl::TextureLayout wander_layout{GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT,
                                      GL_LINEAR, 0,       GL_REPEAT};
constexpr int wander_texels = 512;
constexpr int slip_texels = 512;
constexpr glm::vec2 slip_size{12.0F, 36.0F};       // metres
constexpr double wander_features_per_side = 64.0;  // along its side
constexpr double ripples_per_wander_feature = 7.0;

constexpr int detail_unit = 7;
constexpr int visibility_unit = 10;
constexpr int wander_unit = 11;
constexpr int listed_unit = 12;
constexpr int slip_unit = 13;
constexpr GLint near_stencil = 1;
constexpr GLint far_stencil = 2;
// Of ground that is true to nature: on none that falls less sand slid.
constexpr double least_slip_slope = 0.3;

constexpr double ripple_wavelength_m = 0.12;
constexpr double ripple_wavelength_cells =
    0.3;  // without metres: a hundredth of a dune of 30 cells
constexpr double steepest_ripple_slope = 0.2;
constexpr double steps_per_ripple_wavelength = 50.0;  // that it takes to move on by its length

enum class ShadingPass { smooth_pixels, slid_pixels, pixels, samples, packed_samples };

/// Samples along each side of a pixel; llvmpipe unrolls no loop whose end it does not know.
gl::Constant factor_of(const View& view) {
    const bool one = view.camera.has_lens();  // for each of the lens's points
    return {"factor", one ? 1.0F : static_cast<float>(view.image.supersampling)};
}

/// Of those that colour pixels of one ground, or samples of the others. What is multiplied by a
/// constant 0 is not worked out.
gl::Constants shading_constants(gl::Constants fixed, const View& view, ShadingPass pass) {
    fixed.push_back(factor_of(view));
    fixed.push_back({"least_slip_slope", static_cast<float>(least_slip_slope)});
    fixed.push_back({"sliding_from", sliding_from});
    if (view.look.ripples == 0.0) fixed.push_back({"ripple_slope", 0.0F});
    if (view.look.grain == 0.0) fixed.push_back({"sand_grain", 0.0F});
    const bool smooth = pass == ShadingPass::smooth_pixels;
    const bool plain = smooth || pass == ShadingPass::slid_pixels;
    fixed.push_back({"plain_sand", plain ? 1.0F : 0.0F});
    fixed.push_back({"slid_sand", smooth ? 0.0F : 1.0F});
    fixed.push_back({"whole_pixels", plain || pass == ShadingPass::pixels ? 1.0F : 0.0F});
    fixed.push_back({"packed_samples", pass == ShadingPass::packed_samples ? 1.0F : 0.0F});
    return fixed;
}

}  // namespace

WorldLayer::GroundPrograms::GroundPrograms(const gl::Constants& fixed)
    : near("common/screen.vert.glsl", "world/world_near.frag.glsl", {}, fixed),
      far("common/screen.vert.glsl", "world/world_far.frag.glsl", {}, fixed) {}

WorldLayer::WorldLayer(const View& view, const Block& block, const Snapshot& first, int refinement,
                       const DrawnOrigin& origin, const FarCopies& copies,
                       const gl::Constants& fixed, const gl::MipmapMaker& mipmaps, bool in_buffer)
    : mipmaps_(mipmaps),
      view_(view),
      block_(block),
      cell_(static_cast<float>(std::min(block.width_x * block.tiles.count() / first.bed.nx(),
                                        block.width_y / first.bed.ny()) /
                               refinement)),
      ripple_wavelength_(first.scale.in_metres ? ripple_wavelength_m / block.side
                                               : ripple_wavelength_cells * cell_ * refinement),
      origin_(origin),
      copies_(copies),
      visibility_program_("world/world.vert.glsl", "world/world_visibility.frag.glsl", {"offset"}),
      upsample_program_("common/screen.vert.glsl", "world/world_upsample.frag.glsl"),
      sample_programs_(shading_constants(fixed, view, ShadingPass::samples)),
      packed_programs_(shading_constants(fixed, view, ShadingPass::packed_samples)),
      surface_(first.bed.nx() * refinement, first.bed.ny() * refinement, surface_layout),
      relief_(relief_texels, relief_texels, detail_layout),
      wander_(wander_texels, wander_texels, wander_layout),
      slip_(slip_texels, slip_texels, detail_layout) {
    if (in_buffer) {
        seen_.emplace();
        copy_program_.emplace("common/screen.vert.glsl", "world/world_visibility_copy.frag.glsl",
                              std::initializer_list<const char*>{}, fixed);
        const auto near = [&](ShadingPass pass) {
            return gl::Program("common/screen.vert.glsl", "world/world_near.frag.glsl", {},
                               shading_constants(fixed, view, pass));
        };
        pixel_programs_.emplace(
            PixelPrograms{near(ShadingPass::smooth_pixels), near(ShadingPass::slid_pixels),
                          GroundPrograms(shading_constants(fixed, view, ShadingPass::pixels))});
    }
    build();
    draw_relief();
    draw_wander();
    draw_slip_face();
}

void WorldLayer::build() {
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(array_.name());
    places_.bind();
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.EnableVertexAttribArray(0);
    triangles_.bind();
    gl.BindVertexArray(0);
}

/// Draws all texels of a target by a program that is in use.
void WorldLayer::fill(const gl::RenderTarget& target) const {
    const gl::Functions& gl = gl::functions();
    target.bind();
    gl.BindVertexArray(no_attributes_.name());
    gl.Disable(GL_DEPTH_TEST);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.BindVertexArray(0);
}

void WorldLayer::draw_relief() {
    const gl::Program program("common/screen.vert.glsl", "world/relief.frag.glsl");
    program.use();
    fill(relief_);
    mipmaps_.make(relief_.colour());
}

void WorldLayer::draw_wander() {
    const gl::Program program("common/screen.vert.glsl", "world/ripple_wander.frag.glsl");
    program.use();
    program.set("features", static_cast<float>(wander_features_per_side));
    fill(wander_);
}

void WorldLayer::draw_slip_face() {
    const gl::Program program("common/screen.vert.glsl", "world/slip_face.frag.glsl");
    program.use();
    program.set("size", slip_size);
    program.set("texels", glm::vec2(slip_texels));
    fill(slip_);
    mipmaps_.make(slip_.colour());
}

void WorldLayer::set_bed(const Snapshot& snapshot, const RepeatedLight& light,
                         std::shared_ptr<const HeightPyramid> heights) {
    surface_.upload(light.surface.data());
    mipmaps_.make(surface_);
    slid_ = light.slid;
    heights_ = std::move(heights);
    step_ = snapshot.step;
    way_ = prevailing_way(snapshot);
}

void WorldLayer::set_eye(const gl::Program& program, const Camera& camera) const {
    program.set("eye", glm::vec3(reduced_eye(camera)));
    program.set("extent", glm::vec2(block_.width_x, block_.width_y));
    program.set("eye_from_middle", glm::vec2(eye_from_middle(camera)));
    program.set("copy_strength", static_cast<float>(copies_.strength()));
    program.set("curvature", curvature());
}

void WorldLayer::look_at(const SeenGround& ground) {
    sample_angle_ = ground.sample_angle;
    near_to_ = ground.near_to;
    ground_ = &ground;
    uploaded_ = false;
}

void WorldLayer::upload_mesh() const {
    if (uploaded_) return;
    places_.fill(ground_->mesh.places);
    triangles_.fill(ground_->mesh.triangles);
    uploaded_ = true;
}

pixel_vectors::Bounds WorldLayer::pixel_bounds(const Camera& camera) const {
    const glm::dvec2 from_middle = eye_from_middle(camera);
    const glm::dvec3 eye = reduced_eye(camera);
    return {static_cast<float>(near_to_),
            static_cast<float>(least_slip_slope * block_.exaggeration),
            1.0F / cell_,
            static_cast<float>(block_.width_x),
            static_cast<float>(block_.width_y),
            copies_.varied(),
            static_cast<float>(from_middle.x),
            static_cast<float>(from_middle.y),
            {slid_.words.data(), slid_.words_a_row(), slid_.nx, slid_.ny, block_.tiles.plain,
             static_cast<float>(eye.x), static_cast<float>(eye.y)}};
}

void WorldLayer::rasterise_buffer(const Camera& camera, const PixelSamples& at,
                                  const glm::ivec2& in_picture, const glm::ivec2& picture,
                                  WorkerPool& pool) {
    const GroundMesh& mesh = ground_->mesh;
    const std::span<const std::uint32_t> triangles(mesh.triangles);
    // From the second sample before the pixels on: their numbers are by fours.
    const glm::ivec2 before(2);
    const glm::ivec2 size(at.factor * at.columns + before.x + 1,
                          at.factor * (at.rows + 1) + before.y);
    const glm::ivec2 first = at.first - before;
    std::optional<SeenBuffer::Pixels> pixels;
    if (at.factor > 1) {
        pixels.emplace();
        pixels->grid = {before, at.factor, at.columns, at.rows, at.all_rows};
        pixels->bounds = pixel_bounds(camera);
    }
    seen_->see(
        {mesh.places, triangles.first(mesh.near_indices), triangles.subspan(mesh.near_indices)},
        at_origin(camera, fan_of(camera, *heights_)), {picture, in_picture + first, size}, first,
        pixels, pool);
}

void WorldLayer::set_detail(const gl::Program& program, const Camera& camera) const {
    program.set("sample_angle", static_cast<float>(sample_angle_));
    const glm::dvec2 wind(way_.x, way_.y);
    program.set("wind", glm::vec2(wind));
    program.set("ripple_length", static_cast<float>(ripple_wavelength_));
    const double turns = glm::dot(glm::dvec2(camera.eye), wind) / ripple_wavelength_ -
                         static_cast<double>(step_) / steps_per_ripple_wavelength;
    program.set("ripple_phase", static_cast<float>(turns - std::floor(turns)));
    program.set("wander_scale",
                static_cast<float>(1.0 / (wander_features_per_side * ripples_per_wander_feature)));
    program.set("ripple_slope", static_cast<float>(steepest_ripple_slope * view_.look.ripples));
    program.set("sand_grain", static_cast<float>(view_.look.grain));
    program.set("whole_eye", glm::vec2(camera.eye));
    program.set("exaggeration", static_cast<float>(block_.exaggeration));
}

void WorldLayer::copy_visibility(const Camera& camera, const PixelSamples& at) const {
    const gl::Functions& gl = gl::functions();
    const gl::ScopedScissor scissor(at.first, at.factor * glm::ivec2(at.columns, at.rows));
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_ALWAYS);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl.BindVertexArray(no_attributes_.name());
    const Camera there = at_origin(camera, fan_of(camera, *heights_));
    copy_program_->use();
    seen_->bind(*copy_program_, visibility_unit);
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

void WorldLayer::rasterise(const Camera& camera, const TileSamples& tile, bool tell_far) const {
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
        visibility_program_.set("side", tell_far && stencil == far_stencil ? -1.0F : 1.0F);
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

void WorldLayer::bind_visibility(const gl::Program& program, const gl::Texture2D* seen) const {
    if (seen_) {
        seen_->bind(program, visibility_unit);
    } else if (seen != nullptr) {
        seen->bind(visibility_unit);
        program.set("offsets", visibility_unit);
    }
}

void WorldLayer::bind(const gl::Program& program, const gl::Texture2D* seen,
                      const BedShading& shading, const Light& light, const Camera& camera) const {
    program.use();
    shading.bind(program);
    set_light(program, view_, light, camera, block_);
    surface_.bind(detail_unit);
    program.set("surface_map", detail_unit);
    shading.colours().bind(detail_unit + 1);
    program.set("albedo_map", detail_unit + 1);
    relief_.colour().bind(detail_unit + 2);
    program.set("relief_map", detail_unit + 2);
    wander_.colour().bind(wander_unit);
    program.set("wander_map", wander_unit);
    slip_.colour().bind(slip_unit);
    program.set("slip_map", slip_unit);
    program.set("slip_size", slip_size);
    bind_visibility(program, seen);
    if (streamers_ != nullptr) {
        streamers_->bind(program);
        program.set("first_of_tile", glm::vec2(first_of_tile_));
    }
    set_eye(program, camera);
    set_detail(program, camera);
}

/// Of the maps that plain pixels look at they see texels alone, no means of several; llvmpipe finds
/// these sooner where there are no others.
void WorldLayer::bind_map_levels(const BedShading& shading, bool alone) const {
    const auto bind_map = [&](const gl::Texture2D& map, int unit) {
        if (alone) {
            map.bind_level(0, unit);
        } else {
            map.bind_all_levels(unit);
        }
    };
    bind_map(shading.lighting(), 0);
    bind_map(surface_, detail_unit);
    if (shading.colours().width() <= surface_.width()) bind_map(shading.colours(), detail_unit + 1);
}

void WorldLayer::shade_pixels(const PixelSamples& at, const BedShading& shading, const Light& light,
                              const Camera& camera) const {
    const gl::Functions& gl = gl::functions();
    const gl::ScopedScissor scissor({0, 0}, {at.columns, at.rows});
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.BindVertexArray(no_attributes_.name());
    const auto draw = [&](const gl::Program& program, std::uint32_t kind) {
        bind(program, nullptr, shading, light, camera);
        program.set("first_sample", glm::vec2(at.first));
        gl.StencilFunc(GL_EQUAL, static_cast<GLint>(kind), 0xFF);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    };
    bind_map_levels(shading, true);
    draw(pixel_programs_->smooth, pixel_vectors::smooth);
    draw(pixel_programs_->slid, pixel_vectors::slid);
    bind_map_levels(shading, false);
    draw(pixel_programs_->others.near, pixel_vectors::near);
    draw(pixel_programs_->others.far, pixel_vectors::far);
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void WorldLayer::upsample_pixels(const gl::Texture2D& pixels, const PixelSamples& at) const {
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl.StencilFunc(GL_ALWAYS, 0, 0xFF);
    gl.BindVertexArray(no_attributes_.name());
    upsample_program_.use();
    upsample_program_.set("first_sample", glm::vec2(at.first));
    upsample_program_.set("factor", at.factor);
    pixels.bind(visibility_unit);
    upsample_program_.set("pixels", visibility_unit);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void WorldLayer::shade_samples(const gl::Texture2D& seen, const BedShading& shading,
                               const Light& light, const Camera& camera) const {
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.BindVertexArray(no_attributes_.name());
    for (const bool near : {true, false}) {
        bind(near ? sample_programs_.near : sample_programs_.far, &seen, shading, light, camera);
        gl.StencilFunc(GL_EQUAL, near ? near_stencil : far_stencil, 0xFF);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void WorldLayer::shade_packed_samples(const gl::Texture2D* seen, PackedSamples& samples,
                                      const BedShading& shading, const Light& light,
                                      const Camera& camera) const {
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(no_attributes_.name());
    for (const auto ground : {PackedSamples::Ground::near, PackedSamples::Ground::far}) {
        const gl::Program& program =
            ground == PackedSamples::Ground::near ? packed_programs_.near : packed_programs_.far;
        samples.colour(ground, [&](const gl::Texture2D& listed) {
            bind(program, seen, shading, light, camera);
            listed.bind(listed_unit);
            program.set("listed", listed_unit);
            gl.DrawArrays(GL_TRIANGLES, 0, 3);
        });
    }
    gl.BindVertexArray(0);
}

}  // namespace fumon
