#pragma once

#include "gl/handles.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace fumon::gl {

/// Makes the mipmaps of textures by a shader of its own: what a driver makes them with may be
/// compiled anew in every process, for each format.
class MipmapMaker {
  public:
    MipmapMaker();

    /// Each level is the mean of four texels of the finer one, or between its nearest where a side
    /// is odd. Binds another target, program and vertex array, one without attributes,
    /// and leaves depths and stencils untested.
    void make(const Texture2D& texture) const;

  private:
    Program program_;
    Framebuffer framebuffer_;
    VertexArray no_attributes_;
};

}  // namespace fumon::gl
