#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/avalanche.h"
#include "base/snapshot.h"
#include "base/worker_pool.h"
#include "files/appended_file.h"
#include "files/avalanche_table.h"
#include "files/netcdf/netcdf_fields.h"
#include "measure/measured_rows.h"
#include "measure/suite.h"
#include "run/job_thread.h"
#include "run/stepper.h"
#include "scene/scene.h"
#include "scene/schedule.h"

namespace fumon {

/// Where a recorder writes.
struct RecordPaths {
    std::filesystem::path measurements;
    std::filesystem::path avalanches;
    std::filesystem::path fields;
};

/// How far a recorder's files were when a checkpoint was made, and what they held.
struct RecordPositions {
    FileBeginning measurements;
    FileBeginning avalanches;
    FieldsBeginning fields;
};

/// What a recorder has written: the files that exist under their final names.
struct Recorded {
    bool measurements = false;
    bool avalanches = false;
    bool fields = false;
};

/// What a recorder is made for.
struct Recording {
    std::optional<RecordPaths> files;  ///< none: it writes nothing
    std::string resolved;              ///< the scene as TOML, for fields.nc
    bool plots = false;                ///< frames are drawn: it gathers what plots over them show
    int threads = 1;                   ///< that measure; 0: one per processor
    bool longer = false;               ///< a complete run's files are gone on with
};

/// What a run measures, row by row.
MeasureChoice recorded_measures(const Scene& scene);

/// Writes what a simulation leaves besides pictures and beds, as its scene asks:
///
///     measurements.csv   step, time and the measures of MeasureSuite; an empty cell where a
///                        measure has no meaning
///     avalanches.csv     one row an avalanche; no file until there is one
///     fields.nc          every field of the snapshot, as NetCDF
///
/// It also gathers the measurements that plots over the frames show (overlays).
/// The files get their names by commit(); without it they vanish with the recorder.
///
/// It measures and writes on a thread of its own while the next steps run, one snapshot at a time
/// in the order of the steps: a step whose snapshot comes before the last one is measured waits.
/// What fails there is thrown by the next call that says so, and nothing after it is recorded.
class Recorder : public StepObserver {
  public:
    /// `first` is the run's first snapshot. With positions of a former run, goes on with its files.
    /// Throws Error when a file cannot be made, InputError where one cannot be gone on with.
    Recorder(const Scene& scene, const Snapshot& first, Recording recording,
             const std::optional<RecordPositions>& previous = std::nullopt);

    /// Whether a step's snapshot is to be recorded.
    [[nodiscard]] bool wants(std::int64_t step) const override;

    /// Has a snapshot recorded. Throws Error where an earlier one met a full disk or any failed
    /// write; the rows before that stay whole.
    void take(const SharedSnapshot& snapshot) override;

    /// Takes the step's avalanches. Throws as take().
    void after_step(const Model& model) override;

    /// Waits until all that was taken is recorded. Throws as take().
    void settle() override;

    /// The measurements so far that plots over the frames show. Settles first where there are any.
    [[nodiscard]] const MeasuredRows& rows();

    /// Settles, puts all that was recorded on disk, and tells how far the files have come.
    [[nodiscard]] RecordPositions sync();
    /// Settles, and saves or restores what later rows and plots need from earlier rows. Throws as
    /// StateArchive does.
    void serialise(StateArchive& archive);

    /// Records what was taken and gives every file its final name, even if one fails; then throws
    /// the first Error.
    void commit();
    [[nodiscard]] const Recorded& recorded() const { return recorded_; }

  private:
    /// Has the avalanches since the last call recorded, and a snapshot after them.
    void hand_over(SharedSnapshot snapshot);
    void record(std::span<const Avalanche> avalanches);
    void record(const Snapshot& snapshot);
    void measure(const Snapshot& snapshot);
    void record_fields(const Snapshot& snapshot);

    RecordPaths paths_;
    FieldsText text_;
    Schedule measured_;
    Schedule fielded_;
    bool measures_ = false;
    bool lists_avalanches_ = false;
    std::vector<Avalanche> avalanches_since_;  ///< the last ones that were handed over
    Recorded recorded_;

    // Of the thread while a job is under way.
    MeasureSuite suite_;
    std::optional<WorkerPool> pool_;
    RowGatherer plotted_;
    std::optional<AppendedFile> measurements_;
    std::optional<AvalancheFile> avalanches_;
    std::optional<FieldsFile> fields_;

    JobThread thread_{"fumon-record"};  // last: joined before what it uses goes
};

}  // namespace fumon
