#pragma once

#include <filesystem>

#include "run/terminal/job_watch.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// What a viewer is asked for besides what it shows.
struct ViewOptions {
    std::filesystem::path save;  ///< the folder that the page may write to; empty: it may not
    bool trust = false;          ///< pictures of any size, and models of any
    bool force = false;          ///< files of others in that folder are replaced
    WorkOptions work{};
    bool computes = false;      ///< with other values of the model's keys, too: ScenePages
    bool drops = false;         ///< terrain may be dropped on the page: DroppedTerrain
    JobWatch* watch = nullptr;  ///< of the run that this program computes; nullptr: none
};

}  // namespace fumon
