#pragma once

#include <memory>

#include "base/snapshot.h"
#include "base/worker_pool.h"
#include "files/hash.h"
#include "models/shared/model.h"
#include "run/frame_painter.h"
#include "run/progress.h"
#include "run/recorder.h"
#include "run/work_options.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// The measurements on the way to a still's step, taken as the run takes them.
struct PlottedRows {
    PlottedRows(const Scene& scene, const Model& model);

    Scene scene;  ///< writes no file
    Recorder recorder;
};

/// A scene made ready to run: its initial bed, the threads of its model, and the model.
struct Workshop {
    Scene scene;
    InitialBed initial;
    std::unique_ptr<WorkerPool> pool;
    std::unique_ptr<Model> model;
    /// Where plots stand over the frames: what they show of the steps so far, see advance_to().
    std::unique_ptr<PlottedRows> plotted;
};

/// A scene with its initial bed, which is all that a model is built from.
struct PreparedScene {
    Scene scene;
    InitialBed initial;
};

/// Builds the bed of a scene and checks its palette and the keys that overlays name. Throws
/// InputError, located.
PreparedScene prepare(Scene scene);

/// Checks that what a scene shows is in the snapshots of its model, of which `first` is one. Throws
/// InputError, located.
void check_shown(const Scene& scene, const Snapshot& first);

/// Builds the model of a scene, and the bed where it is not there yet, and checks as prepare and
/// check_shown do. Throws InputError where they do not fit, located at the scene's model or key.
Workshop set_up(PreparedScene prepared, int threads);
Workshop set_up(Scene scene, int threads);

/// Advances the model to a step, showing progress, and measures what plots over the frames show.
/// Returns the signal that stopped it early, or 0. Throws Error when the bed is not finite then.
int advance_to(Workshop& workshop, std::int64_t step, Progress& progress);

/// Advances until the model's time reaches the wanted one. Throws InputError where the run ends
/// before, naming what was asked ("--time 5").
int advance_to_time(Workshop& workshop, double time, const std::string& asked, Progress& progress);

/// Pins what will be drawn where that is asked for: before any thread starts.
void prepare_drawing(const WorkOptions& work);

/// Says what draws, what of the user's settings was overridden for it, and why it is not pinned
/// though that was asked for.
void tell_drawing(const DrawingRecord& drawing, Progress& progress);

/// A picture's pixel hash, and what drew it.
struct DrawnStill {
    Sha256 pixels{};
    RenderingEnvironment environment;
};

/// A picture of the model's present state, and what drew it.
struct Drawing {
    Image image;
    DrawingRecord record;
};

/// Draws the model's present state as the run's frame of that step; `first` is the run's first.
Drawing draw_present(Workshop& workshop, const Snapshot& first, const WorkOptions& work);

/// The same, written whole with its metadata.
DrawnStill draw_still(Workshop& workshop, const Snapshot& first, const std::string& file,
                      const WorkOptions& work, Progress& progress);

}  // namespace fumon
