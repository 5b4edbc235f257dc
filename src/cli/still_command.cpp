#include <fmt/format.h>

#include <filesystem>

#include "base/error.h"
#include "cli/commands.h"
#include "run/drawing.h"
#include "run/still.h"
#include "run/terminal/interrupt.h"
#include "scene/read.h"
#include "scene/terrain_scene.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

bool is_scene(const std::string& path) {
    return fs::path(path).extension() == ".toml";
}

Scene scene_of(const StillOptions& options) {
    if (!is_scene(options.input))
        return terrain_scene(options.input, options.heights, options.work.settings);
    if (!options.heights.empty()) {
        throw InputError(
            "--heights belongs to a PNG terrain; in a scene write bed.heights = [low, high]");
    }
    return read_scene(options.input, options.work.settings);
}

std::int64_t step_of(const StillOptions& options, const Scene& scene) {
    if (!options.step) return scene.run.steps;
    if (*options.step > scene.run.steps) {
        throw InputError(fmt::format(
            "--step {} is after the run's end; {} runs {} steps (lengthen it with --set "
            "run.steps={})",
            *options.step, options.input, scene.run.steps, *options.step));
    }
    return *options.step;
}

}  // namespace

int still_command(const StillOptions& options) {
    const InterruptGuard guard;
    prepare_drawing(options.work);
    PreparedRun prepared = prepare_run(scene_of(options), options.work.threads);
    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(prepared.initial.bed.size()));
    if (!prepared.initial.note.empty()) progress.note(prepared.initial.note);
    const Snapshot first = prepared.model->snapshot();
    const int signal = options.time
                           ? advance_to_time(prepared, *options.time,
                                             fmt::format("--time {}", *options.time), progress)
                           : advance_to(prepared, step_of(options, prepared.scene), progress);
    if (signal != 0) return exit_status_of_signal(signal);
    draw_still(prepared, first, options.output, options.work, progress);
    return 0;
}

}  // namespace fumon
