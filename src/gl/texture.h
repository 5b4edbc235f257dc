#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "gl/handles.h"

namespace fumon::gl {

/// How a texture is stored and sampled.
struct TextureLayout {
    GLint internal_format = GL_RGBA8;
    GLenum format = GL_RGBA;
    GLenum type = GL_UNSIGNED_BYTE;
    GLint filter = GL_LINEAR;  ///< magnification, and minification without mipmaps
    GLint minification = 0;    ///< 0: as `filter`
    GLint wrap = GL_CLAMP_TO_EDGE;
    GLint coarsest_mip_level = 1000;  ///< of its mipmaps, the coarsest that is looked at
};

/// A 2-D texture of a fixed size.
class Texture2D {
  public:
    /// `pixels` may be null. Throws Error where the size exceeds what OpenGL allows.
    Texture2D(int width, int height, const TextureLayout& layout, const void* pixels = nullptr);

    void upload(const void* pixels) const;  ///< replaces all of it
    /// Replaces a part of it; `row`: texels from one row of `pixels` to the next.
    void upload_region(const glm::ivec2& low, const glm::ivec2& size, std::size_t row,
                       const void* pixels) const;
    void set_mipmap(int level, const void* pixels) const;
    void bind(int unit) const;  ///< to texture unit `unit`

    /// The mipmaps that there may be, down to one texel or the layout's coarsest.
    [[nodiscard]] int coarsest_mip_level() const;
    [[nodiscard]] glm::ivec2 size(int level) const;
    /// Gives them storage, once; MipmapMaker fills it.
    void allocate_mipmaps() const;
    void bind_mip_level(int level, int unit) const;  ///< that one alone is looked up
    void bind_all_mip_levels(int unit) const;

    [[nodiscard]] GLuint name() const { return texture_.name(); }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

  private:
    Texture texture_;
    int width_;
    int height_;
    TextureLayout layout_;
    mutable bool has_mipmaps_ = false;
};

/// Depths (24 bits) and stencils (8 bits) of samples, for one render target or several of a size.
class DepthBuffer {
  public:
    DepthBuffer(int width, int height);

    /// Sets stencils, a number each, of rows from the lowest on, and depths to 0. Takes texture
    /// unit 0.
    void set_stencils(int columns, int rows, const std::uint32_t* stencils) const;

    [[nodiscard]] GLuint name() const { return texture_.name(); }

  private:
    Texture texture_;
};

/// A framebuffer that draws into one colour texture and, where one is given, a depth buffer.
class RenderTarget {
  public:
    /// `depth` is as large, and outlives it. Throws Error where OpenGL refuses the combination.
    RenderTarget(int width, int height, const TextureLayout& colour,
                 const DepthBuffer* depth = nullptr);

    void bind() const;  ///< as the target, with a viewport over all of it
    [[nodiscard]] const Texture2D& colour() const { return colour_; }
    [[nodiscard]] int width() const { return colour_.width(); }
    [[nodiscard]] int height() const { return colour_.height(); }

  private:
    Texture2D colour_;
    Framebuffer framebuffer_;
};

}  // namespace fumon::gl
