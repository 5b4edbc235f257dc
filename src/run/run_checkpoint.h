#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/state_carrier.h"
#include "base/stopwatch.h"
#include "models/shared/model.h"
#include "run/frame_record.h"
#include "run/recorder.h"
#include "run/run_folder.h"
#include "scene/initial_bed.h"

namespace fumon {

/// What a run has done so far, between two steps: all outputs of the steps up to `step` are on
/// disk, and nothing else counts. In the file the model's state and what its measures remember
/// follow (Model::carry, Recorder::carry). Random numbers need no place in it: they are functions
/// of seed and step.
struct RunCheckpoint {
    std::string version;            ///< of the fumon that wrote it
    std::string scene;              ///< resolved, as TOML: all that decides results and outputs
    std::vector<InputFile> inputs;  ///< what the scene reads
    std::string drawing;            ///< what drew the frames, in words
    std::int64_t step = 0;
    RecordPositions records;
    std::vector<FrameRecord> frames;
    std::vector<std::int64_t> bed_steps;
    std::vector<std::int64_t> resumed_at;  ///< steps from which the run was gone on with

    /// Throws as StateCarrier.
    void carry(StateCarrier& carrier);
};

/// When the next checkpoint is due: so many minutes after the last one, but late enough that
/// writing them takes at most a fiftieth of the run.
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

/// Writes a run's checkpoints into DIR/checkpoint.fumon. Lives on the simulation's thread.
class Checkpointer {
  public:
    /// `minutes` between checkpoints; 0: none.
    Checkpointer(const RunFolder& folder, const RunParts& parts, double minutes)
        : folder_(folder), parts_(parts), clock_(minutes) {}

    [[nodiscard]] bool on() const { return clock_.on(); }
    [[nodiscard]] bool due() const { return clock_.due(); }

    /// As many frames and beds are on disk since an earlier checkpoint.
    void skip(std::size_t frames, std::size_t beds) {
        frames_on_disk_ = frames;
        beds_on_disk_ = beds;
    }

    /// Puts all outputs that it counts on disk, then the checkpoint, whole or not at all; fills in
    /// version, step and positions. Throws Error, and leaves the former one.
    void write(RunCheckpoint now, Model& model, Recorder& recorder);

  private:
    void put_on_disk(const RunCheckpoint& now);

    const RunFolder& folder_;
    RunParts parts_;
    CheckpointClock clock_;
    std::size_t frames_on_disk_ = 0;
    std::size_t beds_on_disk_ = 0;
};

/// A frame that the run wrote before its checkpoint. Throws Error where it is no longer the same.
Image read_frame(const RunFolder& folder, const RunParts& parts, const RunCheckpoint& checkpoint,
                 std::int64_t number);

}  // namespace fumon
