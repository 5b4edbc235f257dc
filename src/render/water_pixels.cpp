#include "render/water_pixels.h"

#include "gl/functions.h"
#include "render/view/water.h"
#include "render/view_uniforms.h"

namespace fumon {

namespace {

constexpr int seen_unit = 9;  // after those of the ground and the water
constexpr int grain_unit = 10;
constexpr int places_unit = 11;
constexpr int others_unit = 12;

// How pixels are told apart, by depth: a drawing at a depth between reaches one kind of them.
constexpr double split_dry_depth = 0.1;
constexpr double before_split_dry = 0.2;
constexpr double dry_depth = 0.3;
constexpr double before_dry = 0.4;
constexpr double nothing_depth = 0.5;
constexpr double behind_wet = 0.6;
constexpr double wet_depth = 0.7;
constexpr double behind_split_wet = 0.8;
constexpr double split_wet_depth = 0.9;

const gl::TextureLayout places_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT,
                                      GL_NEAREST, 0,       GL_CLAMP_TO_EDGE};

gl::Constants with(gl::Constants fixed, float under_water, float farther) {
    fixed.push_back({"under_water", under_water});
    fixed.push_back({"farther", farther});
    return fixed;
}

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
    : kinds_("common/screen.vert.glsl", "bed/water_pixel_kinds.frag.glsl", {}, fixed),
      dry_("common/screen.vert.glsl", "bed/water_pixels.frag.glsl", {}, with(fixed, 0.0F, 0.0F)),
      wet_("common/screen.vert.glsl", "bed/water_pixels.frag.glsl", {}, with(fixed, 1.0F, 0.0F)),
      farther_("common/screen.vert.glsl", "bed/water_pixels.frag.glsl", {},
               with(fixed, 1.0F, 1.0F)),
      depths_(pixels_of(plan.target_width, plan.factor),
              pixels_of(plan.target_height, plan.factor)),
      places_(pixels_of(plan.target_width, plan.factor), pixels_of(plan.target_height, plan.factor),
              places_layout, &depths_),
      others_(places_.width(), places_.height(), layout_of(kind), &depths_),
      target_(places_.width(), places_.height(), layout_of(kind), &depths_) {}

void WaterPixels::shade(const gl::Texture2D& seen, const glm::ivec2& offset,
                        const BedShading& shading, const TerrainLayer& terrain, const Light& light,
                        const Camera& camera) {
    const gl::Functions& gl = gl::functions();
    const auto draw = [&](const gl::Program& program, GLenum passes, double depth) {
        program.use();
        shading.bind_all(program, light, camera, 0.0);
        seen.bind(seen_unit);
        program.set("seen", seen_unit);
        program.set("height_span", terrain.height_span());
        program.set("sample_offset", glm::vec2(offset));
        if (&program != &kinds_) {
            terrain.set_grain(program, grain_unit);
            places_.colour().bind(places_unit);
            program.set("places", places_unit);
        }
        if (&program == &dry_ || &program == &wet_) {
            others_.colour().bind(others_unit);
            program.set("others", others_unit);
        }
        gl.DepthRange(depth, depth);
        gl.DepthFunc(passes);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    };
    gl.Enable(GL_DEPTH_TEST);
    places_.bind();
    kinds_.use();
    kinds_.set("split_dry_depth", static_cast<float>(split_dry_depth));
    kinds_.set("dry_depth", static_cast<float>(dry_depth));
    kinds_.set("nothing_depth", static_cast<float>(nothing_depth));
    kinds_.set("wet_depth", static_cast<float>(wet_depth));
    kinds_.set("split_wet_depth", static_cast<float>(split_wet_depth));
    draw(kinds_, GL_ALWAYS, 0.0);
    gl.DepthMask(GL_FALSE);
    others_.bind();
    gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    draw(farther_, GL_GREATER, before_split_dry);
    draw(farther_, GL_LESS, behind_split_wet);
    target_.bind();
    draw(dry_, GL_GREATER, before_dry);
    draw(wet_, GL_LESS, behind_wet);
    gl.DepthMask(GL_TRUE);
    gl.DepthRange(0.0, 1.0);
    gl.DepthFunc(GL_LESS);
    gl.Disable(GL_DEPTH_TEST);
}

}  // namespace fumon
