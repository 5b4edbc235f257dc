#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/folder_lock.h"
#include "run/parallel_runs.h"
#include "run/recorder.h"
#include "sweep/sweep_plan.h"

namespace fumon {

/// The folder of a sweep:
///
///     sweep.json      what is swept, and which run has which number
///     runs/0001.csv   measurements of run 1 (0001-avalanches.csv, 0001-fields.nc), and 0001.json,
///                     written last: the run is done, or has failed
///     runs/0001.lock  while a program works on run 1
///     sweep.csv       all measurements, a row a run and recorded step
///     runs.csv        what became of each run
///
/// A run keeps its number: the runs that a later, larger sweep adds get the next ones. Only one
/// program works in a folder at a time, unless all are shards of a sweep: each of those makes runs
/// alone, one of which no two make at once, and the tables are written when they are merged.
class SweepFolder {
  public:
    /// Opens or creates the folder, locks it, numbers the runs and writes sweep.json. Throws
    /// InputError, with nothing changed, if the folder holds a sweep with a run that this plan
    /// lacks (unless `force`, which deletes that sweep's files, as its sweep.json lists them), if
    /// it holds files that are called as a sweep's and belong to none (unless `force`, which
    /// replaces those in the way), if the sweep reads what it would replace, or if another program
    /// is working there; Error where it cannot be written.
    SweepFolder(std::filesystem::path folder, const SweepPlan& plan, bool force);
    /// The same for one of so many shards, or for their merge: never forced. A shard waits while
    /// another one opens the folder, and lets others in afterwards; the last of them to end waits
    /// for those that merge already.
    enum class Use { shard, merge, last_shard };
    SweepFolder(std::filesystem::path folder, const SweepPlan& plan, int shards, Use use);
    SweepFolder(const SweepFolder&) = delete;
    SweepFolder& operator=(const SweepFolder&) = delete;

    /// The plan's runs in the order of their numbers: run n is plan.runs[order()[n - 1]].
    [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }

    /// The record of a run that is done or has failed, else a pending one.
    [[nodiscard]] RunRecord read_record(std::size_t number) const;

    /// Marks a run as done or failed, after its files. Throws Error.
    void write_record(std::size_t number, const RunRecord& record) const;

    /// What a program holds (FileLock) while it works on a run.
    [[nodiscard]] std::filesystem::path run_lock(std::size_t number) const;
    /// Copies the files of a run from another folder of the sweep, where it has another number; its
    /// record last. Throws Error.
    void import_run(std::size_t number, const std::filesystem::path& from,
                    std::size_t number_there) const;
    /// Writes sweep.json as one program alone would have left it. Throws Error.
    void end_sharing() const;

    [[nodiscard]] RecordPaths paths(std::size_t number) const;

    /// Writes runs.csv, and sweep.csv from the files of the runs that are done. Throws Error.
    /// records[n - 1] is run n's.
    void write_runs(const std::vector<RunRecord>& records) const;
    void write_table(const std::vector<RunRecord>& records) const;

    [[nodiscard]] std::filesystem::path table() const { return folder_ / "sweep.csv"; }

  private:
    [[nodiscard]] std::filesystem::path manifest() const { return folder_ / "sweep.json"; }
    [[nodiscard]] std::filesystem::path file(std::size_t number, const char* end) const;
    [[nodiscard]] const SweepRun& run(std::size_t number) const {
        return plan_.runs[order_[number - 1]];
    }
    void open(bool force, int shards, bool alone, std::chrono::seconds wait = {});
    void number_runs();
    void refuse_while_runs_are_made() const;
    /// How many runs the sweep in the folder has; −1 where there is none of fumon's.
    [[nodiscard]] std::int64_t listed() const;
    /// The files that a new sweep replaces, checked by the rule of OutputClaims.
    [[nodiscard]] std::vector<std::filesystem::path> previous_files(bool force) const;
    void remove_files(const std::vector<std::filesystem::path>& files) const;
    void write_manifest(int shards) const;

    std::filesystem::path folder_;
    const SweepPlan& plan_;
    std::vector<std::size_t> order_;
    std::optional<FolderLock> lock_;
};

}  // namespace fumon
