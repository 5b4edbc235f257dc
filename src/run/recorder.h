#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "base/avalanche.h"
#include "base/snapshot.h"
#include "files/atomic_file.h"
#include "files/avalanche_table.h"
#include "files/netcdf/netcdf_fields.h"
#include "measure/measured_rows.h"
#include "measure/suite.h"
#include "scene/scene.h"
#include "scene/schedule.h"

namespace fumon {

/// Where a recorder writes.
struct RecordPaths {
    std::filesystem::path measurements;
    std::filesystem::path avalanches;
    std::filesystem::path fields;
};

/// How far a recorder's files had come when a checkpoint was made; −1 where there was none.
struct RecordPositions {
    std::int64_t measurements = -1;  ///< bytes
    std::int64_t avalanches = -1;    ///< bytes
    std::int64_t fields = -1;        ///< records
};

/// What a recorder has written: the files that exist under their final names.
struct Recorded {
    bool measurements = false;
    bool avalanches = false;
    bool fields = false;
};

/// What a simulation writes besides pictures and beds, as its scene wants it:
///
///     measurements.csv   step, time and the measures of MeasureSuite; an empty cell where a
///                        measure has no meaning
///     avalanches.csv     one row an avalanche; no file until there is one
///     fields.nc          every field of the snapshot, as NetCDF
///
/// It also keeps the measurements that plots over the frames show (overlays).
/// The files get their names by commit(); without it they vanish with the recorder.
class Recorder {
  public:
    /// `first` is the run's first snapshot, `resolved` the scene as TOML, for fields.nc. With
    /// positions of a former run, goes on with its files. Throws Error when a file cannot be made,
    /// InputError where one cannot be gone on with.
    Recorder(const Scene& scene, const Snapshot& first, std::string resolved, RecordPaths paths,
             const std::optional<RecordPositions>& former = std::nullopt);
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Whether a step's snapshot is to be recorded.
    [[nodiscard]] bool due(std::int64_t step) const;

    /// Records a snapshot of a step that is due. Throws Error on a full disk or any failed write;
    /// the rows before stay whole.
    void record(const Snapshot& snapshot);

    /// Takes the last step's avalanches, after every step. Throws as record().
    void note(std::span<const Avalanche> avalanches);

    /// The measurements so far that plots over the frames show.
    [[nodiscard]] const MeasuredRows& rows() const { return plotted_.rows(); }

    /// Puts all that was recorded on disk, and tells how far the files have come.
    [[nodiscard]] RecordPositions sync();
    /// Carries what later rows and plots draw on of earlier rows. Throws as StateCarrier.
    void carry(StateCarrier& carrier) {
        suite_.carry(carrier);
        plotted_.carry(carrier);
    }

    /// Gives every file its name, even when one fails; then throws the first Error.
    void commit();
    [[nodiscard]] const Recorded& recorded() const { return recorded_; }

  private:
    void measure(const Snapshot& snapshot);
    void record_fields(const Snapshot& snapshot);
    [[nodiscard]] FieldsText fields_text() const { return {scene_.title, resolved_, scene_.seed}; }

    const Scene& scene_;
    std::string resolved_;
    RecordPaths paths_;
    Schedule measured_;
    Schedule fielded_;
    MeasureSuite suite_;
    RowGatherer plotted_;
    std::optional<AtomicFile> measurements_;
    std::optional<AvalancheFile> avalanches_;
    std::optional<FieldsFile> fields_;
    Recorded recorded_;
};

}  // namespace fumon
