#include <fmt/format.h>

#include <csignal>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/manifest.h"
#include "app/pipeline.h"
#include "app/workshop.h"
#include "scene/read.h"
#include "support/error.h"
#include "support/number_text.h"

namespace fumon {

namespace {

void tell_the_end(const RunOutcome& outcome, const Workshop& workshop, const RunFolder& folder,
                  Progress& progress) {
    progress.clear();
    const Timing& timing = outcome.timing;
    const double cell_steps =
        static_cast<double>(workshop.initial.bed.size()) * static_cast<double>(outcome.steps_done);
    progress.note(
        fmt::format("{} steps, {} frames in {} ({:.3g} million cell-steps/s while simulating): {}",
                    with_commas(outcome.steps_done), with_commas(std::ssize(outcome.frames)),
                    clock_text(timing.wall),
                    timing.simulation_wall > 0.0 ? 1e-6 * cell_steps / timing.simulation_wall : 0.0,
                    folder.path().string()));
    const ImageSettings& image = workshop.scene.view.image;
    if (outcome.movie.frames > 0 &&
        (outcome.movie.width != image.width || outcome.movie.height != image.height)) {
        progress.note(fmt::format(
            "movie.mp4 is {} x {}: H.264 needs even sides, so the edge of the {} x {} frames is "
            "repeated",
            outcome.movie.width, outcome.movie.height, image.width, image.height));
    }
}

}  // namespace

int run_command(const RunOptions& options) {
    const InterruptGuard guard;
    RunFolder folder(options.folder, options.force);
    prepare_drawing(options.work);
    Workshop workshop =
        set_up(read_scene(options.scene, options.work.settings), options.work.threads);
    const Scene& scene = workshop.scene;
    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(workshop.initial.bed.size()));
    if (!workshop.initial.note.empty()) progress.note(workshop.initial.note);

    const ManifestFacts facts{scene, workshop.initial, workshop.pool->size()};
    const auto started = [&](const DrawingRecord& drawing) {
        tell_drawing(drawing, progress);
        if (!drawing.environment.backend.empty())
            progress.verbose(fmt::format("vertical exaggeration {:g}", drawing.exaggeration));
        folder.create(scene.output.frames,
                      scene.output.bed_every > 0 || !scene.output.bed_at.empty());
        write_running_manifest(folder, facts, drawing);
    };
    const RunOutcome outcome =
        run_pipeline(*workshop.model, scene, workshop.initial.inputs, folder,
                     {options.work.backend, options.work.threads}, progress, started);
    if (outcome.error) {
        try {
            write_final_manifest(folder, facts, outcome);
        } catch (const Error&) {
            // The first error tells more; on a full disk the manifest goes on saying "running".
        }
        std::rethrow_exception(outcome.error);
    }
    write_final_manifest(folder, facts, outcome);
    tell_the_end(outcome, workshop, folder, progress);
    if (outcome.signal == 0) return 0;
    progress.note(fmt::format("stopped by {} at step {} of {}; what was made is in {}",
                              outcome.signal == SIGINT ? "an interrupt" : "a request to terminate",
                              with_commas(outcome.steps_done), with_commas(scene.run.steps),
                              folder.path().string()));
    constexpr int status_of_signal = 128;
    return status_of_signal + outcome.signal;
}

}  // namespace fumon
