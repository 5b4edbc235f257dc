#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/snapshot.h"

namespace fumon {

/// The file that holds the last state of a run's folder: its fields.nc, else the last bed that it
/// wrote; a path that is no folder is itself. Throws InputError where a folder has neither.
std::filesystem::path last_state_of(const std::filesystem::path& run);

/// A snapshot as a file holds it: a terrain file, or the last record of a fields.nc with its water
/// and what else there is. `heights` and `settings` as terrain_scene takes them; what the user
/// should hear (degrees converted …) goes to standard error. Throws InputError.
Snapshot read_snapshot(const std::string& file, const std::string& heights = {},
                       const std::vector<std::string>& settings = {});

}  // namespace fumon
