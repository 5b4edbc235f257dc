#include "run/resume.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include "base/error.h"
#include "picture/environment.h"
#include "run/drawing.h"
#include "run/pipeline.h"
#include "scene/find_input.h"
#include "scene/json.h"
#include "scene/read.h"

namespace fumon {

namespace {

void check_version(const RunCheckpoint& checkpoint, const std::string& file) {
    if (checkpoint.version == FUMON_VERSION) return;
    throw InputError(
        fmt::format("{}: was written by fumon {}, this is {}; go on with that version, or run the "
                    "scene from its start with --force",
                    file, checkpoint.version, FUMON_VERSION));
}

/// `now` is the scene that is asked for.
void check_scene(const Scene& now, const RunCheckpoint& checkpoint, const std::string& file) {
    const Scene then = parse_scene(checkpoint.scene, file, "");
    const std::string differs = scene_difference(scene_json(then), scene_json(now));
    if (differs.empty()) return;
    throw InputError(fmt::format(
        "{}: cannot go on with it: {}; resume without a scene and --set, or name another folder",
        file, differs));
}

void check_inputs(const std::vector<InputFile>& now, const RunCheckpoint& checkpoint,
                  const std::string& file) {
    bool same = now.size() == checkpoint.inputs.size();
    for (std::size_t i = 0; same && i < now.size(); ++i)
        same = now[i].hash == checkpoint.inputs[i].hash;
    if (same) return;
    throw InputError(fmt::format(
        "{}: cannot go on with it: the files that the scene reads are no longer those of the run",
        file));
}

void check_frames(const RunFolder& folder, const Scene& scene, const RunCheckpoint& checkpoint) {
    check_frame_list(folder.frame_list(), checkpoint.frames);
    for (std::int64_t number = 0; number < checkpoint.frames.frames; ++number) {
        const auto file = scene.output.frames ? folder.frame(number) : folder.movie_frame(number);
        std::error_code fault;
        if (std::filesystem::is_regular_file(file, fault)) continue;
        throw InputError(fmt::format(
            "{}: is not there, but the checkpoint counts it; bring it back, or run the scene from "
            "its start with --force",
            file.string()));
    }
}

}  // namespace

ResumedRun resume_run(const RunFolder& folder, const std::string& asked,
                      const WorkOptions& options) {
    const std::string file = folder.checkpoint().string();
    ResumedRun resumed;
    resumed.rest = open_checkpoint(folder.checkpoint());
    RunCheckpoint& checkpoint = resumed.checkpoint;
    checkpoint.carry(*resumed.rest);
    check_version(checkpoint, file);
    WorkOptions work = options;
    work.pinned = work.pinned || parse_environment(checkpoint.drawing).pinned;
    prepare_drawing(work);

    Scene scene = asked.empty() ? parse_scene(checkpoint.scene, file, "", options.settings)
                                : read_scene(asked, options.settings);
    if (asked.empty() && !checkpoint.inputs.empty())
        scene.bed.file = find_input(checkpoint.inputs.front(), folder.checkpoint(), "run").string();
    PreparedRun& run = resumed.run;
    run = prepare_run(std::move(scene), options.threads);
    check_scene(run.scene, checkpoint, file);
    check_inputs(run.initial.inputs, checkpoint, file);
    check_frames(folder, run.scene, checkpoint);
    if (!checkpoint.inputs.empty()) {  // as the run's pictures name them
        run.initial.inputs = checkpoint.inputs;
        run.scene.bed.file = checkpoint.inputs.front().path;
    }
    resumed.first = run.model->snapshot();
    run.model->carry(*resumed.rest);
    if (run.model->steps_done() != checkpoint.step)
        resumed.rest->refuse("its model stands at another step");
    return resumed;
}

}  // namespace fumon
