#include "render/frame/frame_targets.h"

#include <utility>

#include "render/frame/view_uniforms.h"

namespace fumon {

namespace {

/// Of targets whose texels are looked up one by one.
gl::TextureLayout nearest_layout(PixelFormat kind) {
    gl::TextureLayout layout = colour_layout(kind);
    layout.filter = GL_NEAREST;
    return layout;
}

}  // namespace

gl::TextureLayout visibility_layout(Ground ground, bool surface) {
    gl::TextureLayout layout{GL_RG16, GL_RG, GL_UNSIGNED_SHORT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE};
    if (surface) layout = {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE};
    if (ground == Ground::endless)
        layout = {GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE};
    return layout;
}

FrameTargets::FrameTargets(TargetNeeds needs) : needs_(std::move(needs)) {
    if (!needs_.pixel_colours) return;
    const Tile& largest = needs_.plan.tiles.front();
    pixel_stencils_.emplace(largest.width, largest.height);
    pixel_programs_.emplace(largest.width, largest.height, nearest_layout(needs_.kind),
                            &*pixel_stencils_);
}

const gl::RenderTarget& FrameTargets::visibility() {
    const TilePlan& plan = needs_.plan;
    if (!visibility_) {
        sample_depths_.emplace(plan.target_width, plan.target_height);
        visibility_.emplace(plan.target_width, plan.target_height,
                            visibility_layout(needs_.ground, needs_.surface_heights),
                            &*sample_depths_);
    }
    return *visibility_;
}

const gl::RenderTarget& FrameTargets::sample_colours() {
    if (!sample_programs_) {
        visibility();
        sample_programs_.emplace(needs_.plan.target_width, needs_.plan.target_height,
                                 nearest_layout(needs_.kind), &*sample_depths_);
    }
    return *sample_programs_;
}

const gl::RenderTarget& FrameTargets::background() {
    if (!background_) {
        const Tile& largest = needs_.plan.tiles.front();
        background_.emplace(largest.width, largest.height, nearest_layout(needs_.kind),
                            pixel_stencils_ ? &*pixel_stencils_ : nullptr);
    }
    return *background_;
}

}  // namespace fumon
