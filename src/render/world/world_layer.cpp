#include "render/world/world_layer.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "gl/functions.h"

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

constexpr double ripple_wavelength_m = 0.12;
// Without metres: a hundredth of a dune of 30 cells.
constexpr double ripple_wavelength_cells = 0.3;
/// What a program shades, for which the driver compiles it.
enum class ShadingPass { smooth_pixels, slid_pixels, pixels, samples, packed_samples };

/// Samples along each side of a pixel; llvmpipe unrolls no loop whose end it does not know.
gl::Constant factor_of(const View& view) {
    const bool one = view.camera.has_lens();  // for each of the lens's points
    return {"factor", one ? 1.0F : static_cast<float>(view.image.supersampling)};
}

/// Of the programs of a pass. What is multiplied by a constant 0 is not computed.
/// `least_slip_slope` is WorldLayer's.
gl::Constants shading_constants(gl::Constants fixed, const View& view, ShadingPass pass,
                                double least_slip_slope) {
    fixed.push_back(factor_of(view));
    fixed.push_back({"least_slip_slope", static_cast<float>(least_slip_slope)});
    fixed.push_back({"min_avalanche_slope", min_avalanche_slope});
    if (view.look.ripples == 0.0) fixed.push_back({"ripple_slope", 0.0F});
    if (view.look.grain == 0.0) fixed.push_back({"sand_grain", 0.0F});
    const bool smooth = pass == ShadingPass::smooth_pixels;
    const bool plain = smooth || pass == ShadingPass::slid_pixels;
    fixed.push_back({"plain_sand", plain ? 1.0F : 0.0F});
    fixed.push_back({"slid_sand", smooth ? 0.0F : 1.0F});
    fixed.push_back({"single_surface_pixels", plain || pass == ShadingPass::pixels ? 1.0F : 0.0F});
    fixed.push_back({"packed_samples", pass == ShadingPass::packed_samples ? 1.0F : 0.0F});
    return fixed;
}

}  // namespace

gl::Program WorldLayer::near_program(gl::Constants fixed, bool wet) {
    if (wet) fixed.push_back({"of_far", 0.0F});
    return {"common/screen.vert.glsl",
            wet ? "world/world_wet.frag.glsl" : "world/world_near.frag.glsl",
            {},
            fixed};
}

gl::Program WorldLayer::far_program(gl::Constants fixed, bool wet) {
    if (wet) fixed.push_back({"of_far", 1.0F});
    return {"common/screen.vert.glsl",
            wet ? "world/world_wet.frag.glsl" : "world/world_far.frag.glsl",
            {},
            fixed};
}

WorldLayer::GroundPrograms::GroundPrograms(const gl::Constants& fixed, bool wet)
    : near(near_program(fixed, wet)), far(far_program(fixed, wet)) {}

WorldLayer::WorldLayer(const View& view, const Block& block, const Snapshot& first, int refinement,
                       const DrawnOrigin& origin, const TileWarp& copies,
                       const gl::Constants& fixed, const gl::MipmapMaker& mipmaps,
                       bool has_visibility_buffer)
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
      wet_(draws_water(view.look, first)),
      visibility_program_("world/world.vert.glsl", "world/world_visibility.frag.glsl", {"offset"}),
      upsample_program_("common/screen.vert.glsl", "world/world_upsample.frag.glsl"),
      sample_programs_(shading_constants(fixed, view, ShadingPass::samples, least_slip_slope),
                       wet_),
      packed_programs_(
          shading_constants(fixed, view, ShadingPass::packed_samples, least_slip_slope), wet_),
      surface_(first.bed.nx() * refinement, first.bed.ny() * refinement, surface_layout),
      relief_(relief_texels, relief_texels, detail_layout),
      wander_(wander_texels, wander_texels, wander_layout),
      slip_(slip_texels, slip_texels, detail_layout) {
    if (has_visibility_buffer) {
        visibility_.emplace();
        copy_program_.emplace("common/screen.vert.glsl", "world/world_visibility_copy.frag.glsl",
                              std::initializer_list<const char*>{}, fixed);
        const auto near = [&](ShadingPass pass) {
            return near_program(shading_constants(fixed, view, pass, least_slip_slope), wet_);
        };
        pixel_programs_.emplace(PixelPrograms{
            near(ShadingPass::smooth_pixels), near(ShadingPass::slid_pixels),
            GroundPrograms(shading_constants(fixed, view, ShadingPass::pixels, least_slip_slope),
                           wet_)});
    }
    build();
    draw_relief();
    draw_wander();
    draw_slip_face();
}

void WorldLayer::build() {
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(array_.name());
    positions_.bind();
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
    way_ = prevailing_direction(snapshot);
}

void WorldLayer::look_at(const VisibleGround& ground) {
    sample_angle_ = ground.sample_angle;
    near_limit_ = ground.near_limit;
    ground_ = &ground;
    uploaded_ = false;
}

}  // namespace fumon
