#include "gl/texture.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"

namespace fumon::gl {

Texture2D::Texture2D(int width, int height, const TextureLayout& layout, const void* pixels)
    : width_(width), height_(height), layout_(layout) {
    const Functions& gl = functions();
    GLint largest = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width > largest || height > largest) {
        throw Error(fmt::format("a texture of {} × {} is needed; this OpenGL allows {} × {}", width,
                                height, largest, largest));
    }
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, layout.internal_format, width, height, 0, layout.format,
                  layout.type, pixels);
    const GLint minification = layout.minification != 0 ? layout.minification : layout.filter;
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minification);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, layout.filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, layout.wrap);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, layout.wrap);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL,
                     layout.minification == 0 ? 0 : layout.coarsest_mip_level);
}

void Texture2D::upload(const void* pixels) const {
    const Functions& gl = functions();
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, layout_.format, layout_.type, pixels);
}

void Texture2D::upload_region(const glm::ivec2& low, const glm::ivec2& size, std::size_t row,
                              const void* pixels) const {
    const Functions& gl = functions();
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(row));
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, low.x, low.y, size.x, size.y, layout_.format, layout_.type,
                     pixels);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void Texture2D::set_mipmap(int level, const void* pixels) const {
    const Functions& gl = functions();
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, level, layout_.internal_format, size(level).x, size(level).y, 0,
                  layout_.format, layout_.type, pixels);
}

int Texture2D::coarsest_mip_level() const {
    int level = 0;
    while (level < layout_.coarsest_mip_level && std::max(width_, height_) >> (level + 1) > 0)
        ++level;
    return level;
}

glm::ivec2 Texture2D::size(int level) const {
    return {std::max(width_ >> level, 1), std::max(height_ >> level, 1)};
}

void Texture2D::allocate_mipmaps() const {
    if (has_mipmaps_) return;
    has_mipmaps_ = true;
    for (int level = 1; level <= coarsest_mip_level(); ++level) set_mipmap(level, nullptr);
}

void Texture2D::bind_mip_level(int level, int unit) const {
    bind(unit);
    functions().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, level);
    functions().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
}

void Texture2D::bind_all_mip_levels(int unit) const {
    bind(unit);
    functions().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
    functions().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, layout_.coarsest_mip_level);
}

void Texture2D::bind(int unit) const {
    functions().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    functions().BindTexture(GL_TEXTURE_2D, texture_.name());
}

DepthBuffer::DepthBuffer(int width, int height) {
    const Functions& gl = functions();
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, width, height, 0, GL_DEPTH_STENCIL,
                  GL_UNSIGNED_INT_24_8, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void DepthBuffer::set_stencils(int columns, int rows, const std::uint32_t* stencils) const {
    const Functions& gl = functions();
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, columns, rows, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                     stencils);
}

RenderTarget::RenderTarget(int width, int height, const TextureLayout& colour,
                           const DepthBuffer* depth)
    : colour_(width, height, colour) {
    const Functions& gl = functions();
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
    if (depth != nullptr)
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                                depth->name(), 0);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(fmt::format("OpenGL refuses a framebuffer of {} × {}", width, height));
}

void RenderTarget::bind() const {
    functions().BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    functions().Viewport(0, 0, width(), height());
}

}  // namespace fumon::gl
