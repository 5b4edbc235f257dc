#pragma once

#include <vector>

#include "cli/command.h"
#include "picture/compare.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// Every command, in the order in which `fumon --help` lists them.
std::vector<Command> commands();

}  // namespace fumon
