#include "gl/program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "base/error.h"

namespace fumon::gl {

namespace {

LineNames supported_line_names() {
    const Functions& gl = functions();
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* name = gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (name != nullptr && std::string_view(reinterpret_cast<const char*>(name)) ==
                                   "GL_ARB_shading_language_include") {
            return LineNames::files;
        }
    }
    return LineNames::numbers;
}

/// One compiled stage; deleted once the program holds it.
class Stage {
  public:
    Stage(GLenum kind, std::string_view file, const Constants& constants)
        : shader_(functions().CreateShader(kind)) {
        const Functions& gl = functions();
        const LineNames names = supported_line_names();
        const ShaderSource source = assemble_shader(file, read_shader_file, names, constants);
        const char* text = source.text.c_str();
        gl.ShaderSource(shader_, 1, &text, nullptr);
        gl.CompileShader(shader_);
        GLint compiled = GL_FALSE;
        gl.GetShaderiv(shader_, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) return;
        GLint length = 0;
        gl.GetShaderiv(shader_, GL_INFO_LOG_LENGTH, &length);
        std::vector<char> report(static_cast<std::size_t>(length) + 1);
        gl.GetShaderInfoLog(shader_, length, nullptr, report.data());
        gl.DeleteShader(shader_);
        std::string key;
        if (names == LineNames::numbers)
            key = fmt::format(" (files by number: {})", fmt::join(source.files, ", "));
        throw Error(fmt::format("shaders/{} does not compile{}: {}", file, key, report.data()));
    }
    ~Stage() {
        if (!drivers_are_abandoned()) functions().DeleteShader(shader_);
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    [[nodiscard]] GLuint name() const { return shader_; }

  private:
    GLuint shader_;
};

}  // namespace

Program::Program(std::string_view vertex_file, std::string_view fragment_file,
                 std::initializer_list<const char*> attributes, const Constants& constants) {
    const Functions& gl = functions();
    const Stage vertex(GL_VERTEX_SHADER, vertex_file, constants);
    const Stage fragment(GL_FRAGMENT_SHADER, fragment_file, constants);
    gl.AttachShader(program_.name(), vertex.name());
    gl.AttachShader(program_.name(), fragment.name());
    GLuint place = 0;
    for (const char* attribute : attributes)
        gl.BindAttribLocation(program_.name(), place++, attribute);
    gl.LinkProgram(program_.name());
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    GLint length = 0;
    gl.GetProgramiv(program_.name(), GL_INFO_LOG_LENGTH, &length);
    std::vector<char> report(static_cast<std::size_t>(length) + 1);
    gl.GetProgramInfoLog(program_.name(), length, nullptr, report.data());
    throw Error(fmt::format("shaders/{} and shaders/{} do not link: {}", vertex_file, fragment_file,
                            report.data()));
}

void Program::use() const {
    functions().UseProgram(program_.name());
}

GLint Program::location(const char* uniform) const {
    return functions().GetUniformLocation(program_.name(), uniform);
}

void Program::set(const char* uniform, int value) const {
    functions().Uniform1i(location(uniform), value);
}
void Program::set(const char* uniform, float value) const {
    functions().Uniform1f(location(uniform), value);
}
void Program::set(const char* uniform, const glm::vec2& value) const {
    functions().Uniform2f(location(uniform), value.x, value.y);
}
void Program::set(const char* uniform, const glm::vec3& value) const {
    functions().Uniform3f(location(uniform), value.x, value.y, value.z);
}
void Program::set(const char* uniform, const glm::vec4& value) const {
    functions().Uniform4f(location(uniform), value.x, value.y, value.z, value.w);
}
void Program::set(const char* uniform, const glm::mat4& value) const {
    functions().UniformMatrix4fv(location(uniform), 1, GL_FALSE, &value[0][0]);
}

}  // namespace fumon::gl
