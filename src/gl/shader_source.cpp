#include "gl/shader_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/data_files.h"
#include "base/error.h"

namespace fumon::gl {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view line) {
    const auto begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return line.substr(begin, line.find_last_not_of(blanks) - begin + 1);
}

/// "uniform TYPE NAME;", and maybe a comment after it.
struct Declaration {
    std::string_view type;
    std::string_view name;
};

std::optional<Declaration> uniform_in(std::string_view line) {
    constexpr std::string_view keyword = "uniform ";
    const auto end = line.find(';');
    if (!line.starts_with(keyword) || end == std::string_view::npos) return std::nullopt;
    const std::string_view words = trimmed(line.substr(keyword.size(), end - keyword.size()));
    const auto gap = words.find(' ');
    if (gap == std::string_view::npos) return std::nullopt;
    return Declaration{words.substr(0, gap), trimmed(words.substr(gap))};
}

/// A number as GLSL takes it for one that is not whole: "2.0".
std::string floating_text(float value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

class Assembler {
  public:
    Assembler(const ShaderReader& read, LineNames names, const Constants& constants)
        : read_(read), names_(names), constants_(constants) {}

    void add(const std::string& name, const std::string& text) {
        chain_.push_back(name);
        const std::size_t number = source_.files.size();
        source_.files.push_back(name);
        std::istringstream lines(text);
        std::string line;
        bool marked = number == 0;  // the first line of the first file is its #version
        for (int line_number = 1; std::getline(lines, line); ++line_number) {
            const std::string_view content = trimmed(line);
            if (content.starts_with("#include")) {
                include(content, fmt::format("shaders/{}:{}", name, line_number));
                marked = false;
                continue;
            }
            if (!marked) mark(number, line_number);
            marked = true;
            source_.text += with_constant(line);
            source_.text += '\n';
            if (content.starts_with("#version")) {
                if (names_ == LineNames::files)
                    source_.text += "#extension GL_ARB_shading_language_include : enable\n";
                marked = false;
            }
        }
        chain_.pop_back();
    }

    ShaderSource take() { return std::move(source_); }

  private:
    [[nodiscard]] std::string with_constant(const std::string& line) const {
        const auto declared = uniform_in(line);
        if (!declared) return line;
        for (const Constant& constant : constants_) {
            if (constant.uniform != declared->name) continue;
            return fmt::format("const {0} {1} = {0}({2});", declared->type, declared->name,
                               floating_text(constant.value));
        }
        return line;
    }

    void mark(std::size_t number, int line) {
        if (names_ == LineNames::files) {
            source_.text += fmt::format("#line {} \"shaders/{}\"\n", line, source_.files[number]);
        } else {
            source_.text += fmt::format("#line {} {}\n", line, number);
        }
    }

    void include(std::string_view directive, const std::string& where) {
        const std::string_view quoted =
            trimmed(directive.substr(std::string_view("#include").size()));
        if (quoted.size() < 3 || quoted.front() != '"' || quoted.back() != '"') {
            throw Error(fmt::format("{}: '{}' is not an include; write #include \"file.glsl\"",
                                    where, directive));
        }
        const std::string name(quoted.substr(1, quoted.size() - 2));
        if (std::find(chain_.begin(), chain_.end(), name) != chain_.end()) {
            throw Error(fmt::format("{}: circular include: {} → {}", where,
                                    fmt::join(chain_, " → "), name));
        }
        if (std::find(source_.files.begin(), source_.files.end(), name) != source_.files.end())
            return;
        const auto text = read_(name);
        if (!text) throw Error(fmt::format("{}: shaders/{} does not exist", where, name));
        add(name, *text);
    }

    const ShaderReader& read_;
    LineNames names_;
    const Constants& constants_;
    std::vector<std::string> chain_;
    ShaderSource source_;
};

}  // namespace

ShaderSource assemble_shader(std::string_view name, const ShaderReader& read, LineNames names,
                             const Constants& constants) {
    const auto text = read(name);
    if (!text) throw Error(fmt::format("shaders/{} does not exist", name));
    Assembler assembler(read, names, constants);
    assembler.add(std::string(name), *text);
    return assembler.take();
}

std::optional<std::string> read_shader_file(std::string_view name) {
    std::ifstream file;
    try {
        file.open(data_file(fmt::format("shaders/{}", name)), std::ios::binary);
    } catch (const Error&) {
        return std::nullopt;
    }
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace fumon::gl
