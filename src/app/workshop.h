#pragma once

#include <memory>

#include "app/commands.h"
#include "files/hash.h"
#include "models/model.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"
#include "support/worker_pool.h"

namespace fumon {

/// A scene made ready to run: its initial bed, the threads of its model, and the model.
struct Workshop {
    Scene scene;
    InitialBed initial;
    std::unique_ptr<WorkerPool> pool;
    std::unique_ptr<Model> model;
};

/// Builds bed and model of a scene and checks its palette. Throws InputError where they do not fit,
/// located at the scene's model or key.
Workshop set_up(Scene scene, int threads);

/// Advances the model to a step, showing progress. Returns the signal that stopped it early, or 0.
/// Throws Error when the bed is not finite then.
int advance_to(Workshop& workshop, std::int64_t step, Progress& progress);

/// Draws the model's present state, as the run's frame of that step, and writes it whole with its
/// metadata. Returns the picture's pixel hash.
Sha256 draw_still(Workshop& workshop, const Snapshot& first, const std::string& file,
                  const WorkOptions& work, Progress& progress);

}  // namespace fumon
