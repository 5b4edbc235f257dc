#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace fumon {

/// The beds of a run that may not have written them yet.
struct PlannedBeds {
    std::int64_t every = 0;  ///< steps, as Schedule has them
    std::vector<std::int64_t> at;
    std::int64_t last_step = -1;
    std::set<std::string> endings;  ///< ".asc", ".prj"
};

/// Names of files within a run's folder. One under its temporary name (NAME.part) belongs to it.
struct RunFiles {
    std::set<std::string> files;    ///< "run.json", "movie.mp4", "beds/bed_00000010.asc" …
    std::int64_t frames = 0;        ///< frames/frame_000000.png …, so many
    std::int64_t movie_frames = 0;  ///< movie_frames/frame_000000.png …, so many

    PlannedBeds beds{};

    [[nodiscard]] bool contains(const std::string& name) const;
};

/// All that a run of the scene may write. `checkpoint_minutes`: between checkpoints; 0: none.
RunFiles planned_files(const Scene& scene, double checkpoint_minutes);

/// As a manifest has them, and back. Throws nlohmann::json::exception for anything else.
nlohmann::ordered_json files_json(const RunFiles& files);

/// The files that a run.json lists: of a complete run what it made, of another what it may have
/// made. None where it is not there or is no manifest of fumon's.
RunFiles listed_files(const std::filesystem::path& manifest);

/// The files in a folder that are called as a run calls its own, in the order of their names:
/// numbers have the digits that a run gives them and nothing else.
std::vector<std::string> files_named_as_outputs(const std::filesystem::path& folder);

/// The step of a name like "beds/bed_00000010.asc", whole or partial; −1 of any other.
std::int64_t step_of_bed(const std::string& name);

}  // namespace fumon
