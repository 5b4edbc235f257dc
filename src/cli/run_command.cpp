#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "run/drawing.h"
#include "run/inputs/scene_argument.h"
#include "run/manifest.h"
#include "run/output_files.h"
#include "run/pipeline.h"
#include "run/prepared_run.h"
#include "run/resume.h"
#include "run/terminal/interrupt.h"
#include "scene/json.h"
#include "scene/read.h"
#include "scene/scene_files.h"
#include "scene/terrain_scene.h"
#include "scene/wind_tables.h"

namespace fumon {

namespace {

struct RunOptions {
    std::string scene;
    std::string folder;
    bool force = false;
    std::string resume;              ///< the folder of a run to go on with; empty: a new run
    double checkpoint_every = 10.0;  ///< minutes; 0: no checkpoints
    bool as_json = false;
    WorkOptions work;
};

void declare(CLI::App& command, RunOptions& options) {
    command.add_option("SCENE", options.scene,
                       "a scene file (TOML), the name of one that fumon ships, or a terrain file, "
                       "over which --set model.rain=30 lets an hour of rain fall");
    auto* folder = command.add_option("-o,--output", options.folder, "the folder for the run")
                       ->type_name("DIR");
    auto* force = add_force(command, options.force,
                            "replace the run that the folder holds, and files of "
                            "others that are in its way");
    command
        .add_option("--resume", options.resume,
                    "resume the run in this folder from its checkpoint (no SCENE needed)")
        ->type_name("DIR")
        ->excludes(folder)
        ->excludes(force);
    constexpr double most_minutes = 1e6;
    add_number(command, "--checkpoint-every", options.checkpoint_every, 0, most_minutes,
               "minutes between checkpoints (default 10; 0: none)")
        ->type_name("MINUTES");
    command.add_flag("--json", options.as_json, "print what the run made as JSON");
    add_work_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon run terada-barchans -o out/barchans", "frames, movie, measurements"},
         {"fumon run terada-barchans -o out/wet --set model.creep_rate=0.2", "a number changed"},
         {"fumon run dunes-barchans -o out/dunes --json", "what it made, for a program"},
         {"fumon run --resume out/barchans", "goes on with a run that was stopped"}},
        "Exit status: 0 done, 2 wrong input, 3 could not work, 130/143 interrupted (what was made "
        "is "
        "kept).");
}

void report_outcome(const RunOutcome& outcome, const PreparedRun& prepared, const RunFolder& folder,
                    Progress& progress) {
    progress.clear();
    const Timing& timing = outcome.timing;
    const double cell_steps = static_cast<double>(prepared.initial.bed.size()) *
                              static_cast<double>(outcome.steps_done - outcome.steps_before);
    progress.note(fmt::format(
        "{} steps, {} frames in {} ({:.3g} million cell-steps/s while simulating): {}",
        with_commas(outcome.steps_done), with_commas(outcome.frames), clock_text(timing.wall),
        timing.simulation_wall > 0.0 ? 1e-6 * cell_steps / timing.simulation_wall : 0.0,
        folder.path().string()));
    const ImageSettings& image = prepared.scene.view.image;
    if (const std::string text = padding_text("movie.mp4", outcome.movie, image); !text.empty())
        progress.note(text);
}

void report_renderer_change(const DrawingRecord& now, const RunCheckpoint& previous,
                            Progress& progress) {
    if (previous.frames.frames == 0) return;
    const std::string differs = difference(parse_environment(previous.drawing), now.environment);
    if (differs.empty()) return;
    progress.note(
        fmt::format("frames so far were drawn otherwise ({}): they may differ in single "
                    "pixels",
                    differs));
}

void report_build_change(const BuildIdentity& then, Progress& progress) {
    if (then.tools == this_build().tools) return;
    progress.note(fmt::format(
        "steps so far were computed by a fumon from the same sources built otherwise: {} then, "
        "{} now",
        then.tools, this_build().tools));
}

/// What a run made, for a program; the rest stands in run.json.
void print_json(const RunFolder& folder) {
    const auto manifest = parse_json(read_input_file(folder.manifest()));
    nlohmann::ordered_json json;
    json["folder"] = folder.path().string();
    json["manifest"] = folder.manifest().string();
    for (const char* key :
         {"status", "model", "seed", "steps_planned", "steps_done", "time", "state_sha256",
          "implausible", "error", "measurements", "avalanches", "fields", "movie", "beds"}) {
        if (manifest.contains(key)) json[key] = manifest[key];
    }
    json["frames"] = manifest.contains("frames") ? manifest["frames"].size() : 0;
    if (manifest.contains("performance"))
        json["wall_seconds"] = manifest["performance"]["wall_seconds"];
    std::fputs((json_text(json, 2) + "\n").c_str(), stdout);
}

/// Makes a run that is prepared, in the folder; returns the exit status.
int work(PreparedRun& prepared, RunFolder& folder, const RunOptions& options,
         const ResumedRun* previous) {
    const Scene& scene = prepared.scene;
    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(prepared.initial.bed.size()));
    if (!prepared.initial.note.empty()) progress.note(prepared.initial.note);
    const Snapshot first = prepared.model->snapshot();
    if (const std::string winds = winds_line(first); !winds.empty()) progress.note(winds);

    PipelineOptions how{options.work.backend, options.work.threads, options.checkpoint_every};
    std::optional<PreviousRun> from;
    if (previous != nullptr) {
        from.emplace(PreviousRun{previous->checkpoint, previous->first, *previous->rest});
        how.previous = &*from;
        progress.note(fmt::format("resumes at step {} of {}",
                                  with_commas(previous->checkpoint.step),
                                  with_commas(scene.run.steps)));
        report_build_change(previous->checkpoint.build, progress);
    }
    const ManifestFacts facts{scene, prepared.initial, prepared.pool->size(),
                              planned_files(scene, options.checkpoint_every), first.winds};
    const auto started = [&](const DrawingRecord& drawing) {
        report_drawing(drawing, progress);
        if (!drawing.environment.backend.empty())
            progress.verbose(fmt::format("vertical exaggeration {:g}", drawing.exaggeration));
        if (previous == nullptr) {
            folder.create(run_parts(scene, how.checkpoint_minutes));
        } else {
            report_renderer_change(drawing, previous->checkpoint, progress);
            folder.resume(run_parts(scene, how.checkpoint_minutes), previous->checkpoint);
        }
        write_running_manifest(folder, facts, drawing);
    };
    const RunOutcome outcome = run_pipeline(*prepared.model, scene, prepared.initial.inputs,
                                            outputs_in(folder, scene), how, progress, started);
    const bool complete = !outcome.error && outcome.signal == 0;
    if (complete) sync_to_disk(folder, run_parts(scene, how.checkpoint_minutes), outcome);
    try {
        write_final_manifest(folder, facts, outcome);
    } catch (const Error&) {
        // The run's error tells more; on a full disk the manifest goes on saying "running".
        if (!outcome.error) throw;
    }
    if (!outcome.checkpoint) folder.remove_frame_list();
    if (options.as_json) print_json(folder);
    if (outcome.error) std::rethrow_exception(outcome.error);
    report_outcome(outcome, prepared, folder, progress);
    if (outcome.signal == 0) {
        folder.tidy();
        return 0;
    }
    progress.note(fmt::format(
        "stopped by {} at step {} of {}; results so far are in {}{}",
        outcome.signal == SIGINT ? "an interrupt" : "a request to terminate",
        with_commas(outcome.steps_done), with_commas(scene.run.steps), folder.path().string(),
        outcome.checkpoint ? fmt::format("; fumon run --resume {} continues from step {}",
                                         folder.path().string(), with_commas(*outcome.checkpoint))
                           : ""));
    return exit_status_of_signal(outcome.signal);
}

int resume(const RunOptions& options) {
    RunFolder folder(options.resume, true);
    folder.enter();
    if (folder.is_complete()) {
        Progress(options.work.verbosity, 0)
            .note(fmt::format("{}: the run is complete, nothing is left to do", options.resume));
        if (options.as_json) print_json(folder);
        if (std::filesystem::exists(folder.checkpoint())) folder.tidy();
        return 0;
    }
    ResumedRun previous = resume_run(folder, scene_argument(options.scene), options.work);
    return work(previous.run, folder, options, &previous);
}

PreparedRun prepare(const RunOptions& options) {
    const ExitOnSignal nothing_is_written;
    Scene scene = is_terrain_name(options.scene, options.work.settings)
                      ? terrain_run(terrain_argument(options.scene), options.work.settings)
                      : read_scene(scene_argument(options.scene), options.work.settings);
    return prepare_run(std::move(scene), options.work.threads);
}

int perform(const RunOptions& options) {
    const InterruptGuard guard;
    if (!options.resume.empty()) return resume(options);
    if (options.scene.empty()) throw InputError("fumon run: name a scene, or --resume DIR");
    if (options.folder.empty()) throw InputError("fumon run: name a folder for the run with -o");
    RunFolder folder(options.folder, options.force);
    prepare_drawing(options.work);
    PreparedRun prepared = prepare(options);
    std::vector<std::filesystem::path> inputs = scene_files(prepared.scene);
    inputs.emplace_back(scene_argument(options.scene));
    folder.check(planned_files(prepared.scene, options.checkpoint_every), std::move(inputs));
    return work(prepared, folder, options, nullptr);
}

}  // namespace

Command run_command() {
    return make_command<RunOptions>(
        "run", "run a scene: frames, movie, measurements and manifest into a folder", declare,
        perform);
}

}  // namespace fumon
