#pragma once

#include "run/frame_painter.h"
#include "run/terminal/progress.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// Pins what will be drawn where that is asked for: before any thread starts.
void prepare_drawing(const WorkOptions& work);

/// Says what draws, what of the user's settings was overridden for it, and why it is not pinned
/// though that was asked for.
void tell_drawing(const DrawingRecord& drawing, Progress& progress);

}  // namespace fumon
