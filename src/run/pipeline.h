#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "files/hash.h"
#include "gl/context.h"
#include "models/shared/model.h"
#include "run/frame_painter.h"
#include "run/recorder.h"
#include "run/run_checkpoint.h"
#include "run/run_folder.h"
#include "run/terminal/progress.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

struct MovieRecord {
    std::int64_t frames = 0;  ///< 0: there is no movie
    int width = 0;
    int height = 0;
};

/// Where a run's time went, since it was started or resumed.
struct Timing {
    double wall = 0.0;
    double simulation_wall = 0.0;  ///< inside the model's steps
    double rendering_wall = 0.0;   ///< inside the renderer
    double encoding_wall =
        0.0;  ///< hashing, encoding and writing frames and movie, one after the other
    double simulation_cpu = 0.0;
    double rendering_cpu = 0.0;
    double encoding_cpu = 0.0;
};

/// The result of a run, however it ended. Every file listed is complete and on disk.
struct RunOutcome {
    std::int64_t steps_done = 0;
    double time = 0.0;
    std::int64_t frames = 0;  ///< their records stand in the folder's list of frames
    std::vector<BedRecord> beds;
    Recorded recorded;
    MovieRecord movie;
    DrawingRecord drawing;
    Sha256 state{};
    std::string plausibility_warning;  ///< the model's, of its last state
    Timing timing;
    std::int64_t steps_before = 0;           ///< done before it was gone on with
    std::vector<std::int64_t> resumed_at;    ///< steps from which it was gone on with
    std::optional<std::int64_t> checkpoint;  ///< the step of the last one that was written
    bool keeps_last_state = false;           ///< it is of the complete run
    int signal = 0;                          ///< that stopped the run early, or 0
    bool cancelled = false;                  ///< it did so within a step: there is no state
    std::exception_ptr error;                ///< the first, or none
};

/// A run to resume from its checkpoint.
struct PreviousRun {
    const RunCheckpoint& checkpoint;
    const Snapshot& first;   ///< the run's, before its first step
    StateArchive& measured;  ///< brings back what the measures remember (Recorder::serialise)
    bool is_longer = false;  ///< it was complete, and goes on to a later step
};

struct PipelineOptions {
    gl::Backend backend = gl::Backend::automatic;
    int threads = 0;                          ///< of the renderer's own loops; 0: one per processor
    double checkpoint_minutes = 0.0;          ///< between checkpoints, of wall time; 0: none
    const PreviousRun* previous = nullptr;    ///< its model has its state already
    std::optional<std::int64_t> last_step{};  ///< else the scene's
};

/// Where a run's outputs go. What has no place is not made.
struct RunOutputs {
    RunFolder* folder = nullptr;  ///< of frames, beds, records and checkpoints
    std::optional<std::filesystem::path> movie{};
};

/// One line on a movie that is larger than its frames; empty where it is not, or was not made.
std::string padding_text(const std::string& file, const MovieRecord& movie,
                         const ImageSettings& frames);

/// A folder for all outputs that a scene wants.
RunOutputs outputs_in(RunFolder& folder, const Scene& scene);

/// Runs a scene: simulation thread → bounded queue → drawing thread → bounded queues → encoder
/// threads → files in order. Memory does not grow with the number of frames. The first error stops
/// every stage; an interrupt lets frames in flight finish and leaves a checkpoint. `started` is
/// called once when the painter and the view are ready and before the first file is written;
/// nothing is written when it throws or is never reached. Throws only errors from before that;
/// later ones are in the outcome.
RunOutcome run_pipeline(Model& model, const Scene& scene, const std::vector<InputFile>& inputs,
                        const RunOutputs& outputs, const PipelineOptions& options,
                        Progress& progress,
                        const std::function<void(const DrawingRecord&)>& started);

}  // namespace fumon
