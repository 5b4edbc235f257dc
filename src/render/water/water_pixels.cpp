#include "render/water/water_pixels.h"

#include "gl/functions.h"
#include "render/frame/view_uniforms.h"
#include "render/view/water.h"

namespace fumon {

namespace {

constexpr int visibility_unit = 11;  // after those of the ground and the water
constexpr int grain_unit = 12;
constexpr int positions_unit = 13;

// How pixels are told apart, by depth: a drawing at a depth between reaches one kind of them.
constexpr double dry_depth = 0.1;
constexpr double before_dry = 0.2;
constexpr double thin_depth = 0.3;
constexpr double before_thin = 0.4;
constexpr double nothing_depth = 0.5;
constexpr double behind_deep = 0.6;
constexpr double deep_depth = 0.7;
constexpr double behind_split = 0.8;
constexpr double split_depth = 0.9;

constexpr GLint drawn_stencil = 1;

// What a program knows of the water; see shaders/bed/water.glsl.
constexpr float dry_water = 0.0F;
constexpr float thin_water = 1.0F;
constexpr float any_water = 2.0F;

const gl::TextureLayout positions_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT,
                                         GL_NEAREST, 0,       GL_CLAMP_TO_EDGE};

const gl::TextureLayout kinds_layout{GL_R8,      GL_RED, GL_UNSIGNED_BYTE,
                                     GL_NEAREST, 0,      GL_CLAMP_TO_EDGE};

gl::Constants with(gl::Constants fixed, float under_water, float split) {
    fixed.push_back({"under_water", under_water});
    fixed.push_back({"split", split});
    return fixed;
}

gl::Constants with_limits(gl::Constants fixed) {
    fixed.push_back({"split_distance_cells", WaterPixels::split_distance_cells});
    fixed.push_back({"split_distance_pixels", WaterPixels::split_distance_pixels});
    return fixed;
}

gl::TextureLayout layout_of(PixelFormat kind) {
    gl::TextureLayout layout = colour_layout(kind);
    layout.filter = GL_NEAREST;
    return layout;
}

/// Of what is drawn into a target, from its lower left corner.
struct Rectangle {
    glm::ivec2 low;
    glm::ivec2 size;
};

/// Pixels that may show the surface of a block, of which `clip` is where its corners are seen.
Rectangle pixels_of_block(const glm::mat4& clip, const glm::vec3& low, const glm::vec3& high,
                          const TileSamples& tile, const glm::ivec2& offset, int factor,
                          const glm::ivec2& whole) {
    glm::vec2 first(1e9F);
    glm::vec2 last(-1e9F);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 at =
            clip * glm::vec4((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                             (corner & 4) != 0 ? high.z : low.z, 1.0F);
        if (at.w < 1e-3F) return {{0, 0}, whole};  // it reaches behind the eye
        const glm::vec2 sample =
            (0.5F + 0.5F * glm::vec2(at) / at.w) * tile.picture_size - tile.corner;
        const glm::vec2 pixel = (sample - glm::vec2(offset)) / static_cast<float>(factor);
        first = glm::min(first, pixel);
        last = glm::max(last, pixel);
    }
    const glm::vec2 most(whole);
    const glm::ivec2 begin(glm::clamp(glm::floor(first) - 1.0F, glm::vec2(0.0F), most));
    const glm::ivec2 end(glm::clamp(glm::ceil(last) + 1.0F, glm::vec2(0.0F), most));
    return {begin, end - begin};
}

/// Pixels, one of them begun at most, that so many samples make.
int pixels_of(int samples, int factor) {
    return (samples + factor - 1) / factor + 1;
}

int rows_of(const TilePlan& plan) {
    const int rows = pixels_of(plan.target_height, plan.factor);
    return rows + spare_rows(rows);
}

}  // namespace

glm::ivec2 pixel_offset(const glm::ivec2& first, int factor) {
    const auto begun = [factor](int sample) {
        const int over = sample % factor;
        return over == 0 ? 0 : over - factor;
    };
    return {begun(first.x), begun(first.y)};
}

WaterPixels::WaterPixels(const TilePlan& plan, const gl::Constants& fixed, PixelFormat kind,
                         bool alike)
    : factor_(plan.factor),
      alike_(alike),
      fixed_(with_limits(fixed)),
      dry_("common/screen.vert.glsl", "water/water_pixels.frag.glsl", {},
           with(fixed_, dry_water, 0.0F)),
      thin_("common/screen.vert.glsl", "water/water_pixels.frag.glsl", {},
            with(fixed_, thin_water, 0.0F)),
      deep_("common/screen.vert.glsl", "water/water_pixels.frag.glsl", {},
            with(fixed_, any_water, 0.0F)),
      depths_(pixels_of(plan.target_width, plan.factor), rows_of(plan)),
      positions_(pixels_of(plan.target_width, plan.factor), rows_of(plan), positions_layout,
                 &depths_),
      target_(positions_.width(), positions_.height(), layout_of(kind), &depths_) {}

const WaterPixels::BySamples& WaterPixels::by_samples() {
    if (!by_samples_)
        by_samples_.emplace(
            BySamples{{"common/screen.vert.glsl", "water/water_pixel_kinds.frag.glsl", {}, fixed_},
                      {"common/screen.vert.glsl",
                       "water/water_pixels.frag.glsl",
                       {},
                       with(fixed_, any_water, 1.0F)}});
    return *by_samples_;
}

const WaterPixels::ByPositions& WaterPixels::by_positions() {
    if (!by_positions_)
        by_positions_.emplace(
            ByPositions{{"common/screen.vert.glsl", "water/water_kind_depths.frag.glsl", {}},
                        {target_.width(), target_.height(), kinds_layout}});
    return *by_positions_;
}

void WaterPixels::draw(const gl::Program& program, GLenum passes, double depth,
                       const Shaded& shaded) {
    const gl::Functions& gl = gl::functions();
    program.use();
    shaded.shading.bind_all(program, shaded.light, shaded.camera, 0.0);
    program.set("height_span", shaded.terrain.height_span());
    shaded.terrain.set_grain(program, grain_unit);
    positions_.colour().bind(positions_unit);
    program.set("positions", positions_unit);
    gl.DepthRange(depth, depth);
    gl.DepthFunc(passes);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void WaterPixels::begin_shading() {
    const gl::Functions& gl = gl::functions();
    gl.DepthMask(GL_FALSE);
    target_.bind();
    gl.Clear(GL_STENCIL_BUFFER_BIT);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl.StencilFunc(GL_NOTEQUAL, drawn_stencil, 0xFF);
}

void WaterPixels::end_shading() {
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_STENCIL_TEST);
    gl.Disable(GL_SCISSOR_TEST);
    gl.DepthMask(GL_TRUE);
    gl.DepthRange(0.0, 1.0);
    gl.DepthFunc(GL_LESS);
    gl.Disable(GL_DEPTH_TEST);
}

void WaterPixels::shade(GBuffer& known, const Shaded& shaded) {
    const glm::ivec2 size = known.size;
    known.colours.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    if (known.colours.empty()) return;
    const gl::Functions& gl = gl::functions();
    positions_.colour().bind(positions_unit);  // a new texture takes the unit in use: not the sky's
    const ByPositions& by = by_positions();
    const std::size_t first = static_cast<std::size_t>(known.low.y) * known.stride +
                              static_cast<std::size_t>(known.low.x);
    positions_.colour().upload_region(known.low, size, known.stride,
                                      known.positions.data() + 4 * first);
    by.kinds.bind(visibility_unit);
    by.kinds.upload_region(known.low, size, known.stride, known.kinds.data() + first);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(known.low.x, known.low.y, size.x, size.y);
    gl.Enable(GL_DEPTH_TEST);
    target_.bind();
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    by.depths.use();
    by.depths.set("kinds", visibility_unit);
    gl.DepthFunc(GL_ALWAYS);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    begin_shading();
    const auto before = [](ShadedKind kind) { return (static_cast<double>(kind) - 32.0) / 255.0; };
    draw(deep_, GL_LESS, before(shows_any), shaded);
    draw(thin_, GL_LESS, before(shows_film), shaded);
    draw(dry_, GL_LESS, before(shows_dry_ground), shaded);
    end_shading();
    gl.ReadPixels(known.low.x, known.low.y, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                  known.colours.data());
}

void WaterPixels::shade(const gl::Texture2D& visibility, const glm::ivec2& offset,
                        const Shaded& shaded, const TileSamples& tile) {
    const gl::Functions& gl = gl::functions();
    const BySamples& by = by_samples();
    const Rectangle part = pixels_of_block(glm::mat4(clip_matrix(shaded.camera)),
                                           shaded.terrain.low(), shaded.terrain.high(), tile,
                                           offset, factor_, {target_.width(), target_.height()});
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(part.low.x, part.low.y, part.size.x, part.size.y);
    const auto take_samples = [&](const gl::Program& program) {
        program.use();
        visibility.bind(visibility_unit);
        program.set("visibility", visibility_unit);
        program.set("sample_offset", glm::vec2(offset));
    };
    gl.Enable(GL_DEPTH_TEST);
    positions_.bind();
    take_samples(by.kinds);
    by.kinds.set("dry_depth", static_cast<float>(alike_ ? deep_depth : dry_depth));
    by.kinds.set("nothing_depth", static_cast<float>(nothing_depth));
    by.kinds.set("thin_depth", static_cast<float>(alike_ ? deep_depth : thin_depth));
    by.kinds.set("deep_depth", static_cast<float>(deep_depth));
    by.kinds.set("split_depth", static_cast<float>(split_depth));
    draw(by.kinds, GL_ALWAYS, 0.0, shaded);
    begin_shading();
    draw(dry_, GL_GREATER, before_dry, shaded);
    draw(thin_, GL_GREATER, before_thin, shaded);
    take_samples(by.split);
    draw(by.split, GL_LESS, behind_split, shaded);
    draw(deep_, GL_LESS, behind_deep, shaded);
    end_shading();
}

}  // namespace fumon
