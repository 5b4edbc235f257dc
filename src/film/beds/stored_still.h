#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "film/beds/stored_beds.h"

namespace fumon {

/// The folder of the run that a file or folder is or belongs to: itself, or that of a fields.nc
/// beside its run.json; none for what is no run.
std::optional<std::filesystem::path> run_folder_of(const std::filesystem::path& input);

/// The number of the bed of a step. Throws InputError, naming the steps beside it that there are.
std::size_t bed_of_step(const StoredBeds& beds, std::int64_t step);

/// The number of the bed that was stored nearest to a time, in the model's unit.
std::size_t bed_of_time(const StoredBeds& beds, double time);

}  // namespace fumon
