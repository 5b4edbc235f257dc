// The colours of endless ground: of whole pixels, and of samples.

#include <array>
#include <cmath>

#include "gl/functions.h"
#include "gl/scoped_scissor.h"
#include "render/frame/view_uniforms.h"
#include "render/streamers/streamer_layer.h"
#include "render/world/world_layer.h"

namespace fumon {

namespace {

constexpr int detail_unit = 7;
constexpr int wander_unit = 11;
constexpr int listed_unit = 12;
constexpr int slip_unit = 13;
// Ground under water has neither ripples nor tongues: these take the place of their maps.
constexpr std::array<int, 5> water_units{detail_unit, detail_unit + 2, 6, wander_unit, slip_unit};
constexpr double ripples_per_wander_feature = 7.0;
constexpr double steepest_ripple_slope = 0.2;
constexpr double steps_per_ripple_wavelength = 50.0;  // that it takes to move on by its length

}  // namespace

void WorldLayer::set_eye(const gl::Program& program, const Camera& camera) const {
    program.set("eye", glm::vec3(reduced_eye(camera)));
    program.set("extent", glm::vec2(block_.width_x, block_.width_y));
    program.set("eye_from_middle", glm::vec2(eye_from_middle(camera)));
    program.set("warp_strength", static_cast<float>(copies_.strength()));
    program.set("curvature", curvature());
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

void WorldLayer::bind_visibility(const gl::Program& program,
                                 const gl::Texture2D* visibility) const {
    if (visibility_) {
        visibility_->bind(program, visibility_unit);
    } else if (visibility != nullptr) {
        visibility->bind(visibility_unit);
        program.set("offsets", visibility_unit);
    }
}

void WorldLayer::bind(const gl::Program& program, const gl::Texture2D* visibility,
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
    bind_visibility(program, visibility);
    if (streamers_ != nullptr) {
        streamers_->bind(program);
        program.set("first_of_tile", glm::vec2(first_of_tile_));
    }
    if (wet_) shading.bind_water(program, water_units, camera);
    set_eye(program, camera);
    set_detail(program, camera);
}

/// Of the maps that plain pixels look at they see texels alone, no means of several; llvmpipe finds
/// these sooner where there are no others.
void WorldLayer::bind_map_levels(const BedShading& shading, bool alone) const {
    const auto bind_map = [&](const gl::Texture2D& map, int unit) {
        if (alone) {
            map.bind_mip_level(0, unit);
        } else {
            map.bind_all_mip_levels(unit);
        }
    };
    bind_map(shading.lighting(), 0);
    bind_map(surface_, detail_unit);
    if (shading.colours().width() <= surface_.width()) bind_map(shading.colours(), detail_unit + 1);
}

void WorldLayer::shade_pixels(const FrameTargets& targets, const BedShading& shading,
                              const TileFrame& tile) const {
    const PixelSamples at = pixel_samples(tile);
    targets.pixel_colours().bind();
    gl::functions().Clear(GL_COLOR_BUFFER_BIT);
    targets.pixel_stencils().set_stencils(at.columns, at.all_rows, kinds().numbers().data());
    const gl::Functions& gl = gl::functions();
    const gl::ScopedScissor scissor({0, 0}, {at.columns, at.rows});
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.BindVertexArray(no_attributes_.name());
    const auto draw = [&](const gl::Program& program, std::uint32_t kind) {
        bind(program, nullptr, shading, tile.light, tile.camera);
        program.set("first_sample", glm::vec2(at.first));
        gl.StencilFunc(GL_EQUAL, static_cast<GLint>(kind), 0xFF);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    };
    bind_map_levels(shading, true);
    draw(pixel_programs_->smooth, pixel_class_vectors::smooth);
    draw(pixel_programs_->slid, pixel_class_vectors::slid);
    bind_map_levels(shading, false);
    draw(pixel_programs_->others.near, pixel_class_vectors::near);
    draw(pixel_programs_->others.far, pixel_class_vectors::far);
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void WorldLayer::upsample_pixels(const gl::Texture2D& pixels, const TileFrame& tile) const {
    const PixelSamples at = pixel_samples(tile);
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

void WorldLayer::shade_samples(const gl::Texture2D& visibility, const BedShading& shading,
                               const TileFrame& tile) const {
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.BindVertexArray(no_attributes_.name());
    for (const bool near : {true, false}) {
        bind(near ? sample_programs_.near : sample_programs_.far, &visibility, shading, tile.light,
             tile.camera);
        gl.StencilFunc(GL_EQUAL, near ? near_stencil : far_stencil, 0xFF);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl.Disable(GL_STENCIL_TEST);
    gl.BindVertexArray(0);
}

void WorldLayer::shade_packed_samples(const gl::Texture2D* visibility, PackedSamples& samples,
                                      const BedShading& shading, const TileFrame& tile) const {
    samples.read_pixels(tile.tile, tile.first_in_target(), kinds());
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(no_attributes_.name());
    for (const auto ground : {PackedSamples::Ground::near, PackedSamples::Ground::far}) {
        const gl::Program& program =
            ground == PackedSamples::Ground::near ? packed_programs_.near : packed_programs_.far;
        samples.colour(ground, [&](const gl::Texture2D& listed) {
            bind(program, visibility, shading, tile.light, tile.camera);
            listed.bind(listed_unit);
            program.set("listed", listed_unit);
            gl.DrawArrays(GL_TRIANGLES, 0, 3);
        });
    }
    gl.BindVertexArray(0);
}

}  // namespace fumon
