#pragma once

#include <optional>

#include "gl/texture.h"
#include "render/colour/pixel_kind.h"
#include "render/view/tiles.h"
#include "scene/scene.h"

namespace fumon {

/// Of targets whose texels are looked up one by one.
gl::TextureLayout nearest_layout(PixelKind kind);

/// Of what a sample sees: a position on the block, or an offset from the eye over endless ground.
/// `surface`: with its height, of block/visibility_surface.frag.glsl.
gl::TextureLayout visibility_layout(Ground ground, bool surface = false);

/// What samples see, and their colours.
struct SampleTargets {
    SampleTargets(const TilePlan& plan, Ground ground, bool surface);

    gl::DepthBuffer depths;
    gl::RenderTarget visibility;
    std::optional<gl::RenderTarget> colours;  ///< none where pixels of endless ground have them
};

}  // namespace fumon
