#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "film/beds/blended_bed.h"
#include "foreign/foreign_run.h"
#include "measure/measured_rows.h"
#include "run/prepared_run.h"

namespace fumon {

/// A bed that a run has stored.
struct StoredBed {
    std::int64_t step = 0;
    double time = 0.0;
    std::string file;  ///< of its own; empty: in fields.nc
};

/// The scene of a run's folder, finished or not, as its run.json records it, with its inputs found.
/// `settings` as StoredBeds takes them. Throws InputError likewise.
Scene scene_of_run(const std::filesystem::path& folder,
                   const std::vector<std::string>& settings = {});

/// The scene that a fields.nc records, with the defaults of the fumon that wrote it where it lacks
/// keys. Throws InputError likewise.
Scene scene_of_fields(const std::filesystem::path& file,
                      const std::vector<std::string>& settings = {});

/// A bed's file of such a run as a snapshot like `outline`. Throws InputError where it is damaged
/// or of another size.
Snapshot read_stored_bed(const Scene& scene, const std::filesystem::path& file,
                         const Snapshot& outline);

/// The beds that a finished run has stored in its folder, from which films are cut and its frames
/// drawn later: the records of
/// fields.nc (output.fields_every, output.fields_at), else beds/ (output.bed_every, output.bed_at),
/// which hold no water and no air. Runs of a sweep have stored them in its folder.
class StoredBeds {
  public:
    /// Reads run.json and builds the run's model, which is not stepped, for what all its snapshots
    /// have in common. Throws InputError where the folder holds no run, one that is not finished,
    /// or one that stored no beds, and says what to ask for. `settings` ("key.path=VALUE") may
    /// change how the run looks and which files it writes, and nothing that it computed.
    StoredBeds(std::filesystem::path folder, int threads,
               const std::vector<std::string>& settings = {});

    /// The same of run `number` (1, 2 …) of a sweep's folder, from runs/NUMBER-fields.nc.
    static StoredBeds of_sweep(const std::filesystem::path& folder, std::int64_t number,
                               int threads);

    /// The same of a run that is no folder: of another model's files (foreign/open_run.h), or of
    /// fumon's own fields.nc without its folder. Throws InputError.
    static StoredBeds of_files(const std::string& argument, int threads,
                               const std::vector<std::string>& settings = {},
                               const ForeignQuery& query = {});

    /// The same of another model's files alone: one of fumon's own is read as they are, without the
    /// scene that it holds.
    static StoredBeds of_foreign_files(const std::string& argument, const ForeignQuery& query);

    /// The same of a run whose records somebody else reads.
    static StoredBeds of_records(ForeignRun run, const std::vector<std::string>& settings = {});

    /// A folder or what is none, whichever it is.
    static StoredBeds of_argument(const std::string& argument, int threads,
                                  const std::vector<std::string>& settings = {},
                                  const ForeignQuery& query = {});

    /// The same of a run that was simulated into a folder just now. `first`: before its first step;
    /// `written`: the beds alone that it wrote, for a run without fields.nc.
    static StoredBeds recorded(std::string name, std::filesystem::path folder, PreparedRun run,
                               Snapshot first, std::vector<StoredBed> written);

    /// Has the files that looks of a film of unknown origin name read as those of its scene
    /// (Scene::trusted): only such as have one of these hashes.
    void distrust(std::shared_ptr<const std::vector<std::string>> hashes);

    /// What messages call the run: its folder, or "FOLDER, run 3".
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const Scene& scene() const { return run_.scene; }
    [[nodiscard]] const std::vector<InputFile>& inputs() const { return run_.initial.inputs; }
    /// Before the run's first step.
    [[nodiscard]] const Snapshot& first() const { return first_; }
    /// In the order of their steps, at least one.
    [[nodiscard]] const std::vector<StoredBed>& beds() const { return beds_; }
    /// The snapshot of a bed by its number; the last few are kept. Throws InputError for a damaged
    /// file.
    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::size_t number) const;
    /// What lies at a place among the beds, see blended(); the last two are kept.
    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(const RecordPlace& place) const;
    /// The step there, to the nearest.
    [[nodiscard]] std::int64_t step_at(const RecordPlace& place) const;
    /// The same with its bed alone: no fields, numbers or air, most of what reading takes.
    [[nodiscard]] std::shared_ptr<const Snapshot> heights(std::size_t number) const;

    /// For each bed the columns of measurements.csv of these names, as a plot over it takes them:
    /// all rows up to its step. Throws InputError where the run kept no measurements.
    [[nodiscard]] std::vector<MeasuredRows> measurements(
        const std::vector<std::string>& names) const;

    /// The files that are read.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;

    /// Where the run is another model's, what was recognised of it; else null.
    [[nodiscard]] const ForeignRun* foreign() const { return foreign_ ? &*foreign_ : nullptr; }
    /// Where the run is another model's, how it was asked for; else nothing.
    [[nodiscard]] const std::optional<ForeignQuery>& foreign_query() const { return query_; }

  private:
    struct Kept {
        std::size_t number = 0;
        std::shared_ptr<const Snapshot> snapshot;
    };
    /// What lies at a place, between one and other.
    struct Blended {
        RecordPlace place;
        std::shared_ptr<const Snapshot> one;
        std::shared_ptr<const Snapshot> other;
        std::shared_ptr<const Snapshot> snapshot;
    };

    StoredBeds() = default;
    static StoredBeds of_own_fields(const std::filesystem::path& file, int threads,
                                    const std::vector<std::string>& settings);
    static StoredBeds of_foreign(ForeignRun run, const ForeignQuery& query,
                                 const std::vector<std::string>& settings);
    [[nodiscard]] Snapshot read(std::size_t number, const Snapshot& outline) const;
    [[nodiscard]] std::vector<MeasuredRows> measured_rows(
        const std::vector<std::string>& names) const;

    std::string name_;
    std::filesystem::path folder_;
    std::filesystem::path fields_;        ///< within it
    std::filesystem::path measurements_;  ///< likewise
    std::filesystem::path manifest_;
    PreparedRun run_;
    Snapshot first_;
    std::vector<StoredBed> beds_;
    std::optional<ForeignRun> foreign_;  ///< another model's, from which all is read
    std::optional<ForeignQuery> query_;
    mutable std::optional<Snapshot> bare_;  ///< the first one without what heights() leaves out
    mutable std::vector<Kept> kept_;
    mutable std::vector<Kept> kept_heights_;
    mutable std::vector<Blended> blended_;  ///< the frame that is drawn, and the next one
};

}  // namespace fumon
