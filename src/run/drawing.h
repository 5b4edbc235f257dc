#pragma once

#include <string>

#include "run/frame_painter.h"
#include "run/terminal/progress.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// Pins rendering if the options ask for it. Call it before any thread starts.
void prepare_drawing(const WorkOptions& work);

/// Why this processor draws no pinned pixels though the options ask for them; else empty.
[[nodiscard]] std::string why_processor_is_not_pinned(const WorkOptions& work);

/// Reports which renderer draws, which of the user's settings were overridden, and, if pinning was
/// asked for but is not possible, why.
void report_drawing(const DrawingRecord& drawing, Progress& progress);

}  // namespace fumon
