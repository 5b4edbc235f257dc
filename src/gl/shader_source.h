#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fumon::gl {

/// Gives the text of the shader file of that name, or nothing where it does not exist.
using ShaderReader = std::function<std::optional<std::string>(std::string_view name)>;

/// How #line directives name files: by name (GL_ARB_shading_language_include) or by number.
enum class LineNames { files, numbers };

/// A shader ready to compile.
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;  ///< the n-th is the file that number n stands for
};

/// A uniform of one number whose value never changes while a program lives.
struct Constant {
    std::string_view uniform;
    float value;
};
using Constants = std::vector<Constant>;

/// Reads `name` and replaces each line `#include "other.glsl"` by that file, once (a file already
/// included is not repeated). #line directives keep the compiler's messages true. The
/// uniforms in `constants` become constants, so that the compiler leaves out what they exclude
/// (llvmpipe does the work of both sides of a branch). Throws Error "file:line: …" for a missing
/// file, a malformed include and an include that comes round to itself.
ShaderSource assemble_shader(std::string_view name, const ShaderReader& read, LineNames names,
                             const Constants& constants = {});

/// The shader files that fumon ships, by data_file("shaders/NAME").
std::optional<std::string> read_shader_file(std::string_view name);

}  // namespace fumon::gl
