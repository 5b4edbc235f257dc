#include "render/frame/sample_targets.h"

#include "render/frame/view_uniforms.h"

namespace fumon {

gl::TextureLayout nearest_layout(PixelKind kind) {
    gl::TextureLayout layout = colour_layout(kind);
    layout.filter = GL_NEAREST;
    return layout;
}

gl::TextureLayout visibility_layout(Ground ground, bool surface) {
    gl::TextureLayout layout{GL_RG16, GL_RG, GL_UNSIGNED_SHORT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE};
    if (surface) layout = {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE};
    if (ground == Ground::endless)
        layout = {GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE};
    return layout;
}

SampleTargets::SampleTargets(const TilePlan& plan, Ground ground, bool surface)
    : depths(plan.target_width, plan.target_height),
      visibility(plan.target_width, plan.target_height, visibility_layout(ground, surface),
                 &depths) {}

}  // namespace fumon
