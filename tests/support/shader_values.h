#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "gl/functions.h"
#include "gl/handles.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace fumon {

/// What a fragment shader of tests/render writes over a target of `width` × `height`, rows upward.
/// `set` gives its program the uniforms. Needs a context.
inline std::vector<glm::vec4> shader_values(const std::string& fragment, int width, int height,
                                            const gl::Constants& constants,
                                            const std::function<void(const gl::Program&)>& set) {
    gl::TextureLayout layout;
    layout.internal_format = GL_RGBA32F;
    layout.type = GL_FLOAT;
    const gl::RenderTarget target(width, height, layout);
    const gl::Program program("common/screen.vert.glsl", "../tests/render/" + fragment, {},
                              constants);
    const gl::VertexArray none;
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(none.name());
    target.bind();
    gl.Disable(GL_DEPTH_TEST);
    program.use();
    set(program);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<glm::vec4> found(static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(height));
    gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, found.data());
    return found;
}

}  // namespace fumon
