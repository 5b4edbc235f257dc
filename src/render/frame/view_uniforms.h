#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "render/colour/pixel_format.h"
#include "render/light/light.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// The texture unit of the sky's radiances, bound while a frame is drawn.
inline constexpr int sky_unit = 15;

/// What never changes while a view is drawn, of the uniforms of common/light.glsl,
/// common/colour.glsl, bed/bed.glsl, bed/ground.glsl and block/side.frag.glsl.
gl::Constants fixed_uniforms(const View& view, const Light& light, const Block& block,
                             PixelFormat kind = PixelFormat::display_8);

/// Of a sample's extent, that over which textures are averaged: a lens has one sample a pixel for
/// each of its points, elsewhere within it, and takes textures as the finer samples of a pinhole.
float sample_share(const View& view);

/// How colours of that kind are stored.
gl::TextureLayout colour_layout(PixelFormat kind);

/// Light::metered, for pictures exposed by the part of a desert sky in a camera's view.
double metered_exposure(const View& view, const Light& light, const Camera& camera);

/// Sets the uniforms of shaders/common/light.glsl and shaders/common/colour.glsl and the eye of
/// shaders/bed/bed.glsl.
void set_light(const gl::Program& program, const View& view, const Light& light,
               const Camera& camera, const Block& block);

/// Sets sand_crest and sand_trough of shaders/bed/ground.glsl and shaders/block/spade_cut.glsl.
void set_sand(const gl::Program& program, const LookSettings& look);

}  // namespace fumon
