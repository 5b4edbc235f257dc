#pragma once

#include "figure/section_lines.h"

namespace fumon {

/// The grains' paths, coloured by launch angle; a panel that reaches as far as they do.
LinePanel paths_panel(const Snapshot& snapshot, double unit, const std::string& symbol);

}  // namespace fumon
