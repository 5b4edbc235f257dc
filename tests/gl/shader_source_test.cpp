#include "gl/shader_source.h"

#include <gtest/gtest.h>

#include <map>

#include "base/error.h"

namespace fumon::gl {
namespace {

ShaderReader reader(std::map<std::string, std::string, std::less<>> files) {
    return [files = std::move(files)](std::string_view name) -> std::optional<std::string> {
        const auto found = files.find(name);
        if (found == files.end()) return std::nullopt;
        return found->second;
    };
}

std::string failure(const ShaderReader& read) {
    try {
        assemble_shader("a.glsl", read, LineNames::numbers);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(ShaderSource, ReplacesIncludesAndKeepsLinesTrue) {
    const auto read = reader({{"a.glsl", "#version 330 core\nfirst\n#include \"b.glsl\"\nlast\n"},
                              {"b.glsl", "inside\n"}});
    const ShaderSource source = assemble_shader("a.glsl", read, LineNames::numbers);
    EXPECT_EQ(source.text,
              "#version 330 core\n#line 2 0\nfirst\n#line 1 1\ninside\n#line 4 0\nlast\n");
    EXPECT_EQ(source.files, (std::vector<std::string>{"a.glsl", "b.glsl"}));
}

TEST(ShaderSource, NamesFilesWhereTheCompilerUnderstandsNames) {
    const auto read =
        reader({{"a.glsl", "#version 330 core\n#include \"b.glsl\"\n"}, {"b.glsl", "inside\n"}});
    const ShaderSource source = assemble_shader("a.glsl", read, LineNames::files);
    EXPECT_EQ(source.text,
              "#version 330 core\n#extension GL_ARB_shading_language_include : enable\n"
              "#line 1 \"shaders/b.glsl\"\ninside\n");
}

TEST(ShaderSource, MakesConstantsOfUniforms) {
    const auto read = reader({{"a.glsl",
                               "#version 330 core\nuniform int tone;  // of colour\n"
                               "uniform float tones;\nuniform vec3 tone_curve;\n"
                               "#include \"b.glsl\"\n"},
                              {"b.glsl", "uniform   float  rock ;\n"}});
    const Constants constants = {{"tone", 2.0F}, {"rock", 0.1F}};
    const ShaderSource source = assemble_shader("a.glsl", read, LineNames::numbers, constants);
    EXPECT_EQ(source.text,
              "#version 330 core\n#line 2 0\nconst int tone = int(2.0);\nuniform float tones;\n"
              "uniform vec3 tone_curve;\n#line 1 1\nconst float rock = float(0.1);\n");
}

TEST(ShaderSource, IncludesAFileOnce) {
    const auto read = reader({{"a.glsl", "#include \"b.glsl\"\n#include \"c.glsl\"\n"},
                              {"b.glsl", "#include \"c.glsl\"\n"},
                              {"c.glsl", "once\n"}});
    const std::string text = assemble_shader("a.glsl", read, LineNames::numbers).text;
    EXPECT_EQ(text.find("once"), text.rfind("once"));
    EXPECT_NE(text.find("once"), std::string::npos);
}

TEST(ShaderSource, RejectsAMissingInclude) {
    EXPECT_EQ(failure(reader({{"a.glsl", "\n  #include \"b.glsl\"\n"}})),
              "shaders/a.glsl:2: shaders/b.glsl does not exist");
}

TEST(ShaderSource, RejectsACycle) {
    EXPECT_EQ(failure(reader(
                  {{"a.glsl", "#include \"b.glsl\"\n"}, {"b.glsl", "x\n#include \"a.glsl\"\n"}})),
              "shaders/b.glsl:2: circular include: a.glsl → b.glsl → a.glsl");
}

TEST(ShaderSource, RejectsAMalformedInclude) {
    EXPECT_EQ(
        failure(reader({{"a.glsl", "#include b.glsl\n"}})),
        "shaders/a.glsl:1: '#include b.glsl' is not an include; write #include \"file.glsl\"");
}

}  // namespace
}  // namespace fumon::gl
