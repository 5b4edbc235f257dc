#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "files/input_file.h"
#include "film/beds/stored_beds.h"
#include "scene/scene.h"

namespace fumon {

/// What a page shows: a run by its stored beds, or a single bed.
struct PageRun {
    std::string name;  ///< as messages call it
    Scene scene;       ///< its drape and layers are laid already
    std::vector<InputFile> inputs;
    Snapshot first;                            ///< by which the view is framed
    std::vector<StoredBed> beds;               ///< at least one
    std::vector<std::filesystem::path> files;  ///< that are read
    std::function<std::shared_ptr<const Snapshot>(std::size_t bed)> snapshot;
};

struct PageOptions {
    static constexpr std::size_t usual_beds = 100;
    std::size_t beds = usual_beds;         ///< at most; evenly among those of the run
    double exaggeration = 0.0;             ///< vertical; 0: that of the look
    std::size_t most_triangles = 500'000;  ///< of a bed's surface, else it gets coarser
};

/// Of the folder of a finished run, a fields.nc, or results of another model; with `step` of that
/// bed alone. Nothing for what is none of these. Throws InputError as StoredBeds.
std::optional<PageRun> stored_page_run(const std::string& argument, int threads,
                                       const std::vector<std::string>& settings,
                                       std::optional<std::int64_t> step = {});

/// Of a bed that a file holds; `note` gets what the user should hear of its drape and layers.
PageRun single_page_run(std::string name, Scene scene, Snapshot snapshot, std::string& note);

/// The beds of a run that a page of at most so many shows: evenly among all, the first and the
/// last among them; of one the last.
std::vector<std::size_t> thinned_beds(std::size_t all, std::size_t most);

}  // namespace fumon
