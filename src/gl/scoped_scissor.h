#pragma once

#include <glm/glm.hpp>

#include "gl/functions.h"

namespace fumon::gl {

/// Within its life only a rectangle of the bound target is drawn into.
class ScopedScissor {
  public:
    /// The rectangle's lower left corner and its size, texels.
    ScopedScissor(const glm::ivec2& corner, const glm::ivec2& size) {
        functions().Enable(GL_SCISSOR_TEST);
        functions().Scissor(corner.x, corner.y, size.x, size.y);
    }
    ~ScopedScissor() { functions().Disable(GL_SCISSOR_TEST); }
    ScopedScissor(const ScopedScissor&) = delete;
    ScopedScissor& operator=(const ScopedScissor&) = delete;
};

}  // namespace fumon::gl
