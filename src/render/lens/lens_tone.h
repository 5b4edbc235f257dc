#pragma once

#include "base/image.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/light/light.h"
#include "render/samples/accumulated_light.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/tiles.h"
#include "scene/scene.h"

namespace fumon {

/// Makes pictures of the light that a lens has gathered.
class LensTone {
  public:
    /// `fixed`: of display values, of 16 bits where `deep`.
    LensTone(const Tile& largest, const gl::Constants& fixed, bool deep);

    /// Puts a tile into the picture, of 8 or also of 16 bits, and with opacities as this has them.
    void put(const AccumulatedLight& light, const View& view, const Light& of, const Camera& camera,
             const Block& block, Image& image) const;

  private:
    int rows_;  // at once
    gl::Program program_;
    gl::Texture2D accumulated_;
    gl::RenderTarget shown_;
};

}  // namespace fumon
