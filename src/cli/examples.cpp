#include "cli/examples.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace fumon {

void add_examples(CLI::App& command, const std::vector<Example>& examples,
                  const std::string& notes) {
    constexpr std::size_t widest = 60;  // of lines before what stands beside them
    std::size_t width = 0;
    for (const Example& example : examples) {
        const std::size_t length = std::string_view(example.line).size();
        if (length <= widest) width = std::max(width, length);
    }
    std::string text = "Examples:\n";
    for (const Example& example : examples) {
        const bool bare = std::string_view(example.what).empty();
        text += bare ? fmt::format("  {}\n", example.line)
                     : fmt::format("  {:<{}}   {}\n", example.line, width, example.what);
    }
    if (!notes.empty()) text += "\n" + notes;
    command.footer(text);
}

}  // namespace fumon
