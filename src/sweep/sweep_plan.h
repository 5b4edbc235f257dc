#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "files/hash.h"
#include "run/prepared_run.h"
#include "run/run_identity.h"
#include "scene/initial_bed.h"
#include "scene/read.h"
#include "scene/scene.h"
#include "sweep/sweep_axis.h"

namespace fumon {

/// One run of a sweep.
struct SweepRun {
    std::size_t combination = 0;  ///< of the axes' values; the last axis varies fastest
    std::int64_t seed = 0;
    Sha256 id{};        ///< of all that decides its results: the scene and the files it reads
    double work = 0.0;  ///< cell-steps, for telling how far the sweep is
};

/// What a sweep is to do: all combinations of values, each with every seed, seeds fastest.
struct SweepPlan {
    SceneText scene;
    std::vector<Override> settings;  ///< of --set
    std::vector<SweepAxis> axes;
    SeedRange seeds;
    std::vector<SweepRun> runs;

    nlohmann::ordered_json base;  ///< the resolved scene, without what varies and how it looks
    std::vector<InputFile> inputs;
    std::vector<std::string> notes;  ///< what the user should hear before the start
    /// Of the first combination, where SweepRequest::finished was asked; its values may be missing.
    std::optional<Snapshot> first;
};

/// What is wanted of a sweep.
struct SweepRequest {
    SceneText scene;
    std::vector<Override> settings;
    std::vector<std::string> over;  ///< empty: the scene's own sweep.over
    std::string over_place;         ///< where it stands, for messages; empty: "--over N"
    std::string seeds;              ///< as read_seeds takes them; empty: the scene's sweep.seeds
    /// What snapshots look like of a run that is finished already, so that no model need be built
    /// to see that it is right; nothing of others. May be empty.
    std::function<std::optional<Snapshot>(const PreparedScene&)> finished{};
};

/// Reads the scene, and builds bed and model of every combination once, with the first seed; of a
/// combination whose run is finished (SweepRequest::finished) the bed alone. Throws
/// InputError for the first one that is wrong, located at the value, and for two that are the same.
/// Nothing when interrupted.
std::optional<SweepPlan> make_plan(const SweepRequest& request);

/// The scene of one run.
Scene scene_of(const SweepPlan& plan, const SweepRun& run);

/// The paths of all varied keys, in the order of the axes.
std::vector<std::string> varied_keys(const SweepPlan& plan);

/// Their values in a run, as the user wrote them.
std::vector<std::string> values_of(const SweepPlan& plan, const SweepRun& run);

/// "model.creep_rate=0.2, seed 3".
std::string run_label(const SweepPlan& plan, const SweepRun& run);

}  // namespace fumon
