#include "run/drawing.h"

#include <fmt/format.h>

#include "gl/pinned.h"

namespace fumon {

void prepare_drawing(const WorkOptions& work) {
    if (work.pinned) gl::pin_rendering();
}

std::string why_processor_is_not_pinned(const WorkOptions& work) {
    return work.pinned ? gl::pinning_obstacle("llvmpipe") : "";
}

void report_drawing(const DrawingRecord& drawing, Progress& progress) {
    const RenderingEnvironment& environment = drawing.environment;
    if (environment.backend.empty()) return;
    progress.verbose(fmt::format("{}: {}{}{}{}", environment.backend, environment.renderer,
                                 environment.gl_version.empty() ? "" : ", OpenGL ",
                                 environment.gl_version, environment.pinned ? ", pinned" : ""));
    for (const std::string& line : gl::overridden_by_pinning())
        progress.verbose("--pinned: " + line);
    if (!drawing.pinning_obstacle.empty()) {
        progress.note(fmt::format("not pinned, and recorded so: {}", drawing.pinning_obstacle));
    }
}

}  // namespace fumon
