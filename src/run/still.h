#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/snapshot.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "measure/measured_rows.h"
#include "picture/stills/picture_file.h"
#include "run/frame_painter.h"
#include "run/prepared_run.h"
#include "run/stepper.h"
#include "run/terminal/progress.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// Advances the model to an end, calling others who follow its steps, and gathers what plots over
/// the frames show. Returns the signal that stopped it early, or 0. Throws as Stepper::advance().
int advance(PreparedRun& prepared, const RunEnd& end, std::vector<StepObserver*> others);

/// The same to a step, showing progress.
int advance_to(PreparedRun& prepared, std::int64_t step, Progress& progress);

/// Advances until the model reaches a time. Throws InputError if the run ends before it, naming the
/// option ("--time 5").
int advance_to_time(PreparedRun& prepared, double time, const std::string& asked,
                    Progress& progress);

/// A picture's pixel hash, and what drew it.
struct DrawnStill {
    Sha256 pixels{};
    RenderingEnvironment environment;
};

/// A picture of a snapshot, and what drew it.
struct Drawing {
    Image image;
    DrawingRecord record;
};

/// What the stills of a run have in common: its scene, the files that it read, and what plots over
/// them show. The scene and the files outlive it.
struct StillSubject {
    const Scene& scene;
    const std::vector<InputFile>& inputs;
    MeasuredRows rows{};
    std::string results{};  ///< what is recorded of another model's results (fumon:results)
};

/// Of a run as far as its model has come.
StillSubject still_subject(const PreparedRun& prepared);

/// Draws a snapshot as the run's frame of that step; `first` is the run's first. Needs no model.
Drawing draw_snapshot(const StillSubject& subject, const Snapshot& first, const Snapshot& snapshot,
                      const WorkOptions& work);

/// What a file is called that is to go to standard output.
inline constexpr const char* standard_output = "-";

/// The file of such a picture of a step, in a format, with its metadata, by which `fumon again`
/// makes it; `results` as in StillSubject. Throws as encode_picture().
std::vector<std::uint8_t> still_file(const Scene& scene, const std::vector<InputFile>& inputs,
                                     std::int64_t step, const Drawing& drawing,
                                     PictureFormat format, const std::string& results = {});

/// The light and layers of a snapshot, and what drew them.
struct LayersDrawing {
    LayeredImage layers;
    DrawingRecord record;
};

/// The OpenEXR file of such layers of a step, with its metadata, by which `fumon again` makes it.
std::vector<std::uint8_t> layers_file(const Scene& scene, const std::vector<InputFile>& inputs,
                                      std::int64_t step, const LayersDrawing& drawing,
                                      const std::string& results = {});

/// Lets camera.at and camera.look_at count from the ground of the snapshot that a still draws, see
/// standing_on(). Both snapshots as the model gives them.
void stand_on_drawn_ground(View& view, const Snapshot& first, const Snapshot& drawn);

/// Throws InputError where a still of such snapshots cannot be what the ending of its file says.
void check_still(const Scene& scene, const Snapshot& snapshot, const std::string& file);

/// Draws it and writes that file whole: by its ending a PNG, JPEG, WebP or OpenEXR file; the hash
/// is that of the pixels as they are drawn, or layers_hash().
DrawnStill draw_still(const StillSubject& subject, const Snapshot& first, const Snapshot& snapshot,
                      const std::string& file, const WorkOptions& work, Progress& progress);

}  // namespace fumon
