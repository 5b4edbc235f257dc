#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"

namespace fumon {

/// The file that holds the last state of a run's folder: its fields.nc, else the last bed that it
/// wrote; a path that is no folder is itself. Throws InputError where a folder has neither.
std::filesystem::path last_state_of(const std::filesystem::path& run);

/// As last_state_of(), for a step: its fields.nc, else beds/bed_STEP. Throws InputError where a
/// folder has neither.
std::filesystem::path state_of_step(const std::filesystem::path& run, std::int64_t step);

/// The record of a step, or the last one, of another model's NetCDF file, with its water. Nothing
/// of other files, of a bed alone where no step is asked for, and of what is not recognised. Throws
/// InputError where it has no such step.
std::optional<Snapshot> foreign_state(const std::string& file,
                                      std::optional<std::int64_t> step = {});

/// A snapshot as a file holds it: a terrain file, or the last record of a fields.nc with its water
/// and what else there is, or of another model's file with its water. `heights` and `settings` as
/// terrain_scene takes them; what the user should hear (degrees converted …) goes to standard
/// error. Throws InputError. With `remarks` off it says nothing.
Snapshot read_snapshot(const std::string& file, const std::string& heights = {},
                       const std::vector<std::string>& settings = {}, bool remarks = true);

}  // namespace fumon
