#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
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
#include "models/shared/unstable.h"
#include "run/drawing.h"
#include "run/forecast/run_forecast.h"
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
#include "view/subject/followed_subject.h"
#include "view/view_page.h"
#include "view/watch/job_server.h"

namespace fumon {

namespace {

struct RunOptions {
    std::string scene;
    std::string folder;
    bool force = false;
    std::string resume;              ///< the folder of a run to go on with; empty: a new run
    double checkpoint_every = 10.0;  ///< minutes; 0: no checkpoints
    bool as_json = false;
    WatchOptions watch;
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
                    "resume the run in this folder from its checkpoint (no SCENE needed); "
                    "--set run.steps=N has one that is complete go on to step N")
        ->type_name("DIR")
        ->excludes(folder)
        ->excludes(force);
    constexpr double most_minutes = 1e6;
    add_number(command, "--checkpoint-every", options.checkpoint_every, 0, most_minutes,
               "minutes between checkpoints (default 10; 0: none)")
        ->type_name("MINUTES");
    command.add_flag("--json", options.as_json, "print what the run made as JSON");
    add_watch_options(command, options.watch);
    add_work_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon run terada-barchans -o out/barchans", "frames, movie, measurements"},
         {"fumon run terada-barchans -o out/wet --set model.creep_rate=0.2", "a number changed"},
         {"fumon run dunes-barchans -o out/dunes --json", "what it made, for a program"},
         {"fumon run dunes-barchans -o out/dunes --view", "watched in a browser"},
         {"fumon run --resume out/barchans", "goes on with a run that was stopped"},
         {"fumon run --resume out/barchans --set run.steps=9000", "a complete run made longer"}},
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

/// What a key has in a scene, as JSON; nothing where the scene has no such key.
std::string value_text(const Scene& scene, const std::string& key) {
    auto json = scene_json(scene);
    std::string::size_type begin = 0;
    while (begin <= key.size()) {
        const std::string::size_type end = std::min(key.find('.', begin), key.size());
        const std::string part = key.substr(begin, end - begin);
        if (!json.is_object() || !json.contains(part)) return "";
        json = nlohmann::ordered_json(json[part]);
        begin = end + 1;
    }
    return json.dump();
}

/// What --set changed of the model, with what the scene has itself; empty where it changed nothing.
std::string changed_by_settings(const RunOptions& options, const Scene& scene) {
    std::vector<std::string> changed;
    try {
        const Scene own = read_scene(scene_argument(options.scene), {});
        for (const std::string& setting : options.work.settings) {
            const std::string key = setting.substr(0, setting.find('='));
            const std::string now = value_text(scene, key);
            const std::string before = value_text(own, key);
            if (!key.starts_with("model.") || before.empty() || now == before) continue;
            changed.push_back(
                fmt::format("{} nearer to the scene's own {} than {}", key, before, now));
        }
    } catch (const InputError&) {  // a scene that is none without its settings
        return "";
    }
    return fmt::format("{}", fmt::join(changed, ", "));
}

/// Throws what ended a run; of one that became unstable, with what --set changed as the first
/// remedy.
void rethrow(const RunOutcome& outcome, const RunOptions& options, const Scene& scene) {
    if (!outcome.error) return;
    try {
        std::rethrow_exception(outcome.error);
    } catch (const Unstable& fault) {
        const std::string changed = changed_by_settings(options, scene);
        if (changed.empty()) throw;
        throw Unstable(fault.fault(), fmt::format("{}; or {}", changed, fault.remedies()));
    }
}

/// Says beforehand what a run of more than a few seconds will take. Another model of it makes some
/// steps for that.
void tell_forecast(const PreparedRun& run, const RunOptions& options, Progress& progress) {
    constexpr double most_seconds = 0.5;
    constexpr double soon_done = 5e6;         // steps of cells
    constexpr std::size_t large = 4'000'000;  // cells, of which another model takes much memory
    const std::size_t cells = run.initial.bed.size();
    const double work = static_cast<double>(cells) * static_cast<double>(run.scene.run.steps);
    if (options.work.verbosity == Verbosity::quiet || work < soon_done || cells > large) return;
    const PreparedRun other =
        prepare_run(PreparedScene{run.scene, run.initial}, options.work.threads);
    const auto forecast = forecast_run(other, most_seconds);
    if (!forecast) return;
    if (const std::string text = forecast_text(*forecast); !text.empty()) progress.note(text);
}

/// Takes the port at which a run is shown in a browser. Nobody knows the address before
/// tell_address().
void open_window(std::optional<JobServer>& window, JobWatch& watch, const PreparedRun& prepared,
                 const Snapshot& first, const RunFolder& folder, const RunOptions& options) {
    ViewOptions look;
    look.work = options.work;
    look.watch = &watch;
    window.emplace(
        watch,
        [&, look] {
            return std::make_unique<SubjectPages>(
                watched_subject(folder.path(), prepared.scene, prepared.initial.inputs, first,
                                watch),
                look);
        },
        options.watch.port);
}

void tell_address(const JobServer& window, const RunOptions& options) {
    std::FILE* const out = options.as_json ? stderr : stdout;
    std::fputs(window.address_lines().c_str(), out);
    std::fflush(out);
}

/// For those who watch it.
std::string end_text(const RunOutcome& outcome, const RunFolder& folder) {
    if (outcome.error) return "failed: " + error_text(outcome.error);
    const std::string steps = with_commas(outcome.steps_done);
    if (outcome.signal == 0)
        return fmt::format("complete: {} steps; fumon view {}", steps, folder.path().string());
    return fmt::format("stopped at step {}{}", steps,
                       outcome.checkpoint
                           ? fmt::format("; fumon run --resume {} goes on from step {}",
                                         folder.path().string(), with_commas(*outcome.checkpoint))
                           : "");
}

/// Makes a run that is prepared, in the folder; returns the exit status.
int work(PreparedRun& prepared, RunFolder& folder, const RunOptions& options,
         const ResumedRun* previous) {
    const Scene& scene = prepared.scene;
    JobWatch watch;
    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(prepared.initial.bed.size()),
                      options.watch.on ? &watch : nullptr);
    if (!prepared.initial.note.empty()) progress.note(prepared.initial.note);
    const Snapshot first = prepared.model->snapshot();
    if (const std::string winds = winds_line(first); !winds.empty()) progress.note(winds);

    PipelineOptions how{options.work.backend, options.work.threads, options.checkpoint_every};
    std::optional<PreviousRun> from;
    if (previous != nullptr) {
        from.emplace(PreviousRun{previous->checkpoint, previous->first, *previous->rest,
                                 previous->is_longer});
        how.previous = &*from;
        progress.note(fmt::format("resumes at step {} of {}",
                                  with_commas(previous->checkpoint.step),
                                  with_commas(scene.run.steps)));
        if (!previous->note.empty()) progress.note(previous->note);
        report_build_change(previous->checkpoint.build, progress);
    }
    const ManifestFacts facts{scene, prepared.initial, prepared.pool->size(),
                              planned_files(scene, options.checkpoint_every), first.winds};
    std::optional<JobServer> window;
    const auto started = [&](const DrawingRecord& drawing) {
        report_drawing(drawing, progress);
        if (!drawing.environment.backend.empty())
            progress.verbose(fmt::format("vertical exaggeration {:g}", drawing.exaggeration));
        if (options.watch.on) open_window(window, watch, prepared, first, folder, options);
        if (previous == nullptr) {
            folder.create(run_parts(scene, how.checkpoint_minutes));
        } else {
            report_renderer_change(drawing, previous->checkpoint, progress);
            folder.resume(run_parts(scene, how.checkpoint_minutes), previous->checkpoint);
        }
        write_running_manifest(folder, facts, drawing);
        if (window) tell_address(*window, options);
        if (previous == nullptr) tell_forecast(prepared, options, progress);
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
    if (window) window->end(end_text(outcome, folder));
    if (options.as_json) print_json(folder);
    rethrow(outcome, options, scene);
    report_outcome(outcome, prepared, folder, progress);
    if (outcome.signal == 0) {
        folder.tidy(outcome.keeps_last_state);
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
    const auto tell_complete = [&] {
        Progress(options.work.verbosity, 0)
            .note(fmt::format("{}: the run is complete, nothing is left to do", options.resume));
        if (options.as_json) print_json(folder);
        return 0;
    };
    const bool is_complete = folder.is_complete();
    const bool is_kept = std::filesystem::exists(folder.checkpoint());
    const bool is_asked_anew = !options.scene.empty() || !options.work.settings.empty();
    if (is_complete && !(is_kept && is_asked_anew)) {
        if (!options.work.settings.empty()) {
            throw InputError(
                fmt::format("{}: the run is complete, and its last state was not kept (it was made "
                            "with --checkpoint-every 0 or by an earlier fumon, or is larger than "
                            "{} MB); run the scene from its start with --force",
                            options.resume, Checkpointer::most_bytes_kept >> 20U));
        }
        if (is_kept) folder.tidy(true);
        return tell_complete();
    }
    ResumedRun previous = resume_run(folder, scene_argument(options.scene), options.work);
    if (is_complete && !previous.is_longer) return tell_complete();
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
