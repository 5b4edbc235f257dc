#pragma once

#include <string>
#include <vector>

#include "gl/context.h"
#include "run/terminal/status_line.h"

namespace fumon {

/// The options of every command that simulates or draws.
struct WorkOptions {
    std::vector<std::string> settings;  ///< key.path=VALUE
    gl::Backend backend = gl::Backend::automatic;
    bool pinned = false;  ///< draw the same pixels on every processor, see gl/pinned.h
    int threads = 0;      ///< 0: one per processor
    Verbosity verbosity = Verbosity::normal;
};

}  // namespace fumon
