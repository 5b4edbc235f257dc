#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fumon {

/// One line that says what is wrong with a command line that could not be read, and what would be
/// right: "fumon run: --thread: no such option; did you mean \"--threads\"?".
std::string usage_fault(const CLI::App& app, const std::vector<std::string>& arguments,
                        const CLI::ParseError& fault);

}  // namespace fumon
