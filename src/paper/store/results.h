#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "foreign/foreign_run.h"
#include "run/prepared_run.h"
#include "scene/scene.h"

namespace fumon {

/// Whether what a panel calls its scene is a file of results, another model's or a fields.nc: also
/// where it does not lie there any more.
bool names_results(const std::filesystem::path& file);

/// A scene, as TOML, which shows a file of results by its name.
std::string scene_of_results(const std::string& name);

/// Opens the results that such a scene shows. `field` of a panel is read, too, where it is none of
/// fumon's names. Throws InputError for what is not read, or has no such map.
std::shared_ptr<const ForeignRun> open_results(const Scene& scene, const std::string& field);

/// Such a scene with the bed, grid and last step of its results.
PreparedScene prepare_results(Scene scene, const ForeignRun& results);

/// The steps of results that a panel over the whole run shows: of at most 200 records, or where
/// `every` is above 0 those that are multiples of it.
std::vector<std::int64_t> steps_of_results(const ForeignRun& results, std::int64_t every);

/// The snapshot of a step; of the first record where it is earlier. Throws InputError where there
/// is none of it.
Snapshot snapshot_of_results(const ForeignRun& results, std::int64_t step);

}  // namespace fumon
