#pragma once

#include <memory>

#include "base/worker_pool.h"
#include "models/shared/model.h"
#include "run/recorder.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// A scene with its initial bed, which is all that a model is built from.
struct PreparedScene {
    Scene scene;
    InitialBed initial;
};

/// A run before its first step: a scene, its initial bed, the threads of its model, and the model.
struct PreparedRun {
    Scene scene;
    InitialBed initial;
    std::unique_ptr<WorkerPool> pool;
    std::unique_ptr<Model> model;
    /// Where plots stand over the frames: what they show of the steps so far, see run/still.h.
    std::unique_ptr<Recorder> plotted;
};

/// Builds the bed of a scene and checks its palette and the keys that overlays name. Throws
/// InputError, located.
PreparedScene prepare_scene(Scene scene);

/// The same with a bed that is there already, of whatever origin.
PreparedScene prepare_scene(Scene scene, InitialBed initial);

/// Checks that what a scene shows is in the snapshots of its model, of which `first` is one. Throws
/// InputError, located.
void check_shown(const Scene& scene, const Snapshot& first);

/// Builds the model of a scene, and the bed where it is not there yet, and checks as
/// prepare_scene and check_shown do. Throws InputError where they do not fit, located at the
/// scene's model or key.
PreparedRun prepare_run(PreparedScene prepared, int threads);
PreparedRun prepare_run(Scene scene, int threads);

}  // namespace fumon
