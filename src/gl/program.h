#pragma once

#include <glm/glm.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "gl/handles.h"
#include "gl/shader_source.h"

namespace fumon::gl {

/// A linked vertex and fragment shader, from files in shaders/.
class Program {
  public:
    /// `attributes` are bound to locations 0, 1, …, the uniforms in `constants` keep their values.
    /// Throws Error with the compiler's message (file
    /// and line) where a shader is missing or wrong.
    Program(std::string_view vertex_file, std::string_view fragment_file,
            std::initializer_list<const char*> attributes = {}, const Constants& constants = {});

    void use() const;

    // Uniforms of the program in use; one the compiler dropped is ignored.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const glm::vec2& value) const;
    void set(const char* uniform, const glm::vec3& value) const;
    void set(const char* uniform, const glm::vec4& value) const;
    void set(const char* uniform, const glm::mat4& value) const;

  private:
    [[nodiscard]] GLint location(const char* uniform) const;

    Handle<ProgramKind> program_;
};

}  // namespace fumon::gl
