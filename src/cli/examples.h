#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fumon {

/// A command line that can be tried as it stands, and what it does.
struct Example {
    const char* line;  ///< "fumon describe camera"
    const char* what;  ///< some words; may be ""
};

/// What stands under a command's options: "Examples:", a line each, and notes.
void add_examples(CLI::App& command, const std::vector<Example>& examples,
                  const std::string& notes = {});

}  // namespace fumon
