#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/state_archive.h"
#include "base/stopwatch.h"
#include "models/shared/model.h"
#include "run/build_identity.h"
#include "run/frame_list.h"
#include "run/recorder.h"
#include "run/run_folder.h"
#include "run/stepper.h"
#include "run/written_outputs.h"
#include "scene/initial_bed.h"

namespace fumon {

/// The progress of a run between two steps: all outputs of the steps up to `step` are on disk, and
/// later ones are ignored. In the file the states of the model and of its measures follow
/// (Model::serialise, Recorder::serialise). Random numbers need no entry, since they are functions
/// of seed and step.
struct RunCheckpoint {
    std::string version;            ///< of the fumon that wrote it
    BuildIdentity build;            ///< likewise
    std::string scene;              ///< resolved, as TOML: all that decides results and outputs
    std::vector<InputFile> inputs;  ///< what the scene reads
    std::string drawing;            ///< what drew the frames, in words
    std::int64_t step = 0;
    RecordPositions records;
    FrameCount frames;  ///< their records, with their hashes, stand in the list of frames
    std::vector<BedRecord> beds;
    std::vector<std::int64_t> resumed_at;  ///< steps from which the run was gone on with

    /// Throws as StateArchive.
    void serialise(StateArchive& archive);
};

/// Decides when the next checkpoint is due: a number of minutes after the last one, but late enough
/// that writing checkpoints takes at most a fiftieth of the run.
class CheckpointClock {
  public:
    /// No minutes: never.
    explicit CheckpointClock(double minutes) : interval_(60.0 * minutes) {}

    [[nodiscard]] bool on() const { return interval_ > 0.0; }
    [[nodiscard]] bool due() const { return on() && since_last_.seconds() >= wait_; }
    void begin() { since_begin_ = {}; }
    void end();

  private:
    double interval_;  ///< seconds
    double wait_ = interval_;
    Stopwatch since_begin_;
    Stopwatch since_last_;
};

/// Writes a run's checkpoints into DIR/checkpoint.fumon when they are due, and where an interrupt
/// comes.
class Checkpointer : public StepObserver {
  public:
    /// `clock` says when; `fixed` is what a checkpoint holds that stays the same over the run;
    /// `report` takes what is to be told of one that cannot be written.
    Checkpointer(const RunFolder& folder, const RunParts& parts, const CheckpointClock& clock,
                 RunCheckpoint fixed, WrittenOutputs& written, Recorder& recorder,
                 std::function<void(const std::string&)> report);

    /// Writes a checkpoint once all outputs of the steps so far are written. A disk that is full
    /// for it does not end the run: the former one stays.
    void before_step(Model& model, bool interrupted) override;

    /// Writes a checkpoint of a complete run's last state, from which it can be gone on with to a
    /// later step, unless that is larger than `most_bytes_kept`. Whether it is there.
    bool keep_last_state(Model& model);

    static constexpr std::uint64_t most_bytes_kept = std::uint64_t{64} << 20U;

    /// The step of the last one that was written.
    [[nodiscard]] std::optional<std::int64_t> last() const { return last_; }

  private:
    bool try_to_write(Model& model, std::string_view consequence);
    void write(Model& model);
    void sync_to_disk();

    const RunFolder& folder_;
    RunParts parts_;
    CheckpointClock clock_;
    RunCheckpoint now_;
    WrittenOutputs& written_;
    Recorder& recorder_;
    std::function<void(const std::string&)> report_;
    std::optional<std::int64_t> last_;
    std::int64_t frames_on_disk_;
    std::size_t beds_on_disk_;
};

}  // namespace fumon
