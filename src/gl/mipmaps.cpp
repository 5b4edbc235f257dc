#include "gl/mipmaps.h"

#include <algorithm>

namespace fumon::gl {

MipmapMaker::MipmapMaker() : program_("common/screen.vert.glsl", "common/downsample.frag.glsl") {}

void MipmapMaker::make(const Texture2D& texture) const {
    const Functions& gl = functions();
    texture.allocate_mipmaps();
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl.BindVertexArray(no_attributes_.name());
    gl.Disable(GL_DEPTH_TEST);
    gl.Disable(GL_STENCIL_TEST);
    program_.use();
    program_.set("finer", 0);
    for (int level = 1; level <= texture.coarsest_mip_level(); ++level) {
        texture.bind_mip_level(level - 1, 0);
        const glm::ivec2 size = texture.size(level);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(),
                                level);
        gl.Viewport(0, 0, size.x, size.y);
        program_.set("size", glm::vec2(size));
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    texture.bind_all_mip_levels(0);
}

}  // namespace fumon::gl
