#pragma once

#include <memory>

#include "base/worker_pool.h"
#include "models/shared/model.h"
#include "run/recorder.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// A scene made ready to run: its initial bed, the threads of its model, and the model.
struct Workshop {
    Scene scene;
    InitialBed initial;
    std::unique_ptr<WorkerPool> pool;
    std::unique_ptr<Model> model;
    /// Where plots stand over the frames: what they show of the steps so far, see run/still.h.
    std::unique_ptr<Recorder> plotted;
};

/// Builds bed and model of a scene and checks its palette and overlays. Throws InputError where
/// they do not fit, located at the scene's model or key.
Workshop set_up(Scene scene, int threads);

}  // namespace fumon
