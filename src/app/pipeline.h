#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "app/frame_painter.h"
#include "app/progress.h"
#include "app/recorder.h"
#include "app/run_folder.h"
#include "files/hash.h"
#include "gl/context.h"
#include "models/model.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// A frame that stands on disk (or went into the movie alone).
struct FrameRecord {
    std::int64_t number = 0;
    std::int64_t step = 0;
    double time = 0.0;
    Sha256 pixels{};
};

struct MovieRecord {
    std::int64_t frames = 0;  ///< 0: there is no movie
    int width = 0;
    int height = 0;
};

/// Where a run's seconds went.
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

/// What a run came to, however it ended. Everything listed is whole and on disk.
struct RunOutcome {
    std::int64_t steps_done = 0;
    double time = 0.0;
    std::vector<FrameRecord> frames;
    std::vector<std::int64_t> bed_steps;
    Recorded recorded;
    MovieRecord movie;
    DrawingRecord drawing;
    Sha256 state{};
    Timing timing;
    int signal = 0;            ///< that stopped the run early, or 0
    std::exception_ptr error;  ///< the first, or none
};

struct PipelineOptions {
    gl::Backend backend = gl::Backend::automatic;
    int threads = 0;  ///< of the renderer's own loops; 0: one per processor
};

/// Runs a scene: simulation thread → bounded queue → drawing thread → bounded queues → encoder
/// threads → files in order. Memory does not grow with the number of frames. The first error stops
/// every stage; an interrupt lets what is in flight finish. `started` is called once when the
/// painter and the view are ready and before the first file is written; nothing is written when it
/// throws or is never reached. Throws only what happens before that; later errors are in the
/// outcome.
RunOutcome run_pipeline(Model& model, const Scene& scene, const std::vector<InputFile>& inputs,
                        RunFolder& folder, const PipelineOptions& options, Progress& progress,
                        const std::function<void(const DrawingRecord&)>& started);

}  // namespace fumon
