#pragma once

#include <filesystem>

#include "run/terminal/job_watch.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// What a viewer is asked for besides what it shows.
struct ViewOptions {
    std::filesystem::path save;  ///< the folder that the page may write to; empty: it may not
    bool trust = false;          ///< pictures of any size
    bool force = false;          ///< files of others in that folder are replaced
    WorkOptions work{};
    JobWatch* watch = nullptr;  ///< of the run that this program computes; nullptr: none
};

}  // namespace fumon
