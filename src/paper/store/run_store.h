#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/snapshot.h"
#include "files/hash.h"
#include "foreign/foreign_run.h"
#include "run/parallel_runs.h"
#include "run/prepared_run.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// A run from whose results figures are made.
struct StoredRun {
    Scene scene;  ///< made ready: with its bed file as reached from the working folder
    std::set<std::int64_t> steps;  ///< whose fields are wanted
    Sha256 id{};                   ///< of what decides its results, and of fumon's version
    std::string label;             ///< for messages
    double work = 0.0;             ///< cell-steps
    std::shared_ptr<const ForeignRun> results{};  ///< of a file, which no run makes
};

/// The run of a scene, without what does not decide its results (title, looks, figure, files). Of
/// its bed only the files and the scale are used.
StoredRun stored_run(const Scene& scene, const InitialBed& initial);

/// Results that a file holds as a run that is there already.
StoredRun stored_results(const PreparedScene& prepared, std::shared_ptr<const ForeignRun> results);

/// A folder of finished runs, by what decides their results:
///
///     0123456789abcdef/    the first digits of the run's id: measurements.csv, avalanches.csv,
///                          fields.nc, and job.json, which says what they hold and what
///                          snapshots of the run have in common
///
/// A run appears complete or not at all, so a program may be killed at any time, and several
/// programs may work in one folder: a run has a lock file while one of them works on it.
class RunStore {
  public:
    explicit RunStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Whether the run is there, with the fields of all its steps.
    [[nodiscard]] bool holds(const StoredRun& run) const;

    /// Takes away what a program that was killed just after it had stored a run left beside it: its
    /// lock file, and the run as it was before. Nothing happens where another program has the lock.
    void clear_leftovers(const StoredRun& run) const;

    /// What all snapshots of a run that is there have in common (see read_outline); nothing where
    /// it is not there. With it no model need be built to know the columns of a run, its units …
    [[nodiscard]] std::optional<Snapshot> outline(const StoredRun& run) const;

    /// The snapshot of a step whose fields are there. Throws InputError where they are damaged.
    [[nodiscard]] Snapshot snapshot(const StoredRun& run, std::int64_t step) const;

    /// Makes a run, unless it is stored by now. One that is stored with other steps is made again
    /// with both sets of steps. Throws what the run throws.
    Attempt make(const StoredRun& run, int threads, RunRecord& record,
                 std::atomic<double>& cell_steps) const;

    [[nodiscard]] std::filesystem::path measurements(const StoredRun& run) const;
    [[nodiscard]] std::filesystem::path avalanches(const StoredRun& run) const;  ///< may not be

  private:
    /// What job.json says of a run that is whole.
    struct Content {
        std::set<std::int64_t> steps;
        Snapshot outline;
    };

    [[nodiscard]] std::filesystem::path place(const StoredRun& run) const;
    [[nodiscard]] std::filesystem::path beside(const StoredRun& run, std::string_view end) const;
    [[nodiscard]] std::filesystem::path fields(const StoredRun& run) const;
    [[nodiscard]] std::optional<Content> content(const StoredRun& run) const;
    void put(const std::filesystem::path& made, const StoredRun& run) const;

    std::filesystem::path folder_;
};

}  // namespace fumon
