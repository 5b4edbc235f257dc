#pragma once

#include <string>
#include <vector>

namespace fumon {

/// Reads the command line, runs one command and returns its exit status. Throws InputError for
/// wrong usage and whatever the command throws.
int run_command_line(const std::vector<std::string>& arguments);

}  // namespace fumon
