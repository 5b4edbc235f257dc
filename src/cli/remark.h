#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace fumon {

/// Gives a command -q, after which it makes no remarks.
void add_quiet(CLI::App& command);

/// Whether -q was given.
bool makes_no_remarks();

/// Says on standard error what is neither a fault nor what was asked for, unless -q was given.
void remark(const std::string& text);

/// From here on there are no remarks.
void make_no_remarks();

}  // namespace fumon
