#include "render/water_pixels.h"

#include "gl/functions.h"
#include "render/view/water.h"
#include "render/view_uniforms.h"

namespace fumon {

namespace {

constexpr int seen_unit = 9;  // after those of the ground and the water
constexpr int grain_unit = 10;

/// Finer than bytes: samples at edges are mixed with others.
gl::TextureLayout layout_of(PixelKind kind) {
    gl::TextureLayout layout =
        colour_layout(kind == PixelKind::radiance ? kind : PixelKind::display_16);
    layout.filter = GL_NEAREST;
    return layout;
}

/// Pixels, one of them begun at most, that so many samples make.
int pixels_of(int samples, int factor) {
    return (samples + factor - 1) / factor + 1;
}

}  // namespace

bool shades_pixels(const View& view, const Snapshot& first) {
    return draws_water(view.look, first) && view.look.ground != Ground::endless &&
           !view.camera.has_lens() && view.camera.projection != Projection::map;
}

glm::ivec2 pixel_offset(const glm::ivec2& first, int factor) {
    const auto begun = [factor](int sample) {
        const int over = sample % factor;
        return over == 0 ? 0 : over - factor;
    };
    return {begun(first.x), begun(first.y)};
}

WaterPixels::WaterPixels(const TilePlan& plan, const gl::Constants& fixed, PixelKind kind)
    : program_("common/screen.vert.glsl", "bed/water_pixels.frag.glsl", {}, fixed),
      target_(pixels_of(plan.target_width, plan.factor), pixels_of(plan.target_height, plan.factor),
              layout_of(kind)) {}

void WaterPixels::shade(const gl::Texture2D& seen, const glm::ivec2& offset,
                        const BedShading& shading, const TerrainLayer& terrain, const Light& light,
                        const Camera& camera) {
    const gl::Functions& gl = gl::functions();
    target_.bind();
    gl.Disable(GL_DEPTH_TEST);
    program_.use();
    shading.bind_water(program_, light, camera, 0.0);
    seen.bind(seen_unit);
    program_.set("seen", seen_unit);
    terrain.set_grain(program_, grain_unit);
    program_.set("height_span", terrain.height_span());
    program_.set("sample_offset", glm::vec2(offset));
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace fumon
