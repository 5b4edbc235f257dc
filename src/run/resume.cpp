#include "run/resume.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "base/snapshots/ground_range.h"
#include "base/state_archive.h"
#include "files/hash.h"
#include "picture/environment.h"
#include "run/drawing.h"
#include "run/inputs/find_input.h"
#include "run/pipeline.h"
#include "scene/input_maps.h"
#include "scene/json.h"
#include "scene/read.h"
#include "scene/schedule.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// Another compiler and other flags give the same results; other sources may not.
void check_program(const RunCheckpoint& checkpoint, const std::string& file) {
    std::string then = checkpoint.version;
    std::string now = FUMON_VERSION;
    if (then == now && checkpoint.build.sources == this_build().sources) return;
    if (then == now) {
        then += fmt::format(" from sources {}", short_sources(checkpoint.build));
        now = fmt::format("from sources {}", short_sources(this_build()));
    }
    throw InputError(
        fmt::format("{}: was written by fumon {}, this is {}; resume with that version, or run the "
                    "scene from its start with --force",
                    file, then, now));
}

/// `now` is the scene that is asked for.
void check_scene(const Scene& now, const Scene& then, const std::string& file, bool is_longer) {
    const std::string differs = scene_difference(scene_json(then), scene_json(now));
    if (differs.empty()) return;
    throw InputError(fmt::format("{}: cannot be continued: {}; {}, or name another folder", file,
                                 differs,
                                 is_longer ? "of a complete run only run.steps may change"
                                           : "resume without a scene and --set"));
}

/// Makes the scene of a complete run that of one which goes on to the last step of `now`, and keeps
/// what else would follow from that step as it was. Returns a line on it, or nothing.
std::string lengthen(Scene& then, Scene& now, const std::string& file) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(fmt::format("{}: cannot be continued: {}", file, why));
    };
    const std::int64_t previous = then.run.steps;
    if (now.run.steps < previous) {
        refuse(fmt::format("its {} steps are done, and run.steps = {} is fewer", previous,
                           now.run.steps));
    }
    if (now.run.steps == previous) return "";
    if (then.frames.logarithmic > 0) {
        refuse(
            "frames.logarithmic spreads its frames up to its last step; run the scene from its "
            "start with --force");
    }
    const auto& view = then.view;
    if ((then.output.frames || then.output.movie) &&
        (view.camera.turn != 0.0 || view.sun.hours != 0.0 || view.air.cloud_drift != 0.0)) {
        refuse(
            "camera.turn, sun.hours and air.cloud_drift spread over the whole run, and its frames "
            "are drawn; run the scene from its start with --force");
    }
    if (then.output.movie && !then.output.frames && frame_schedule(then).count() > 0) {
        refuse(
            "its movie is made from frames that were not kept (output.frames = false); run the "
            "scene from its start with --force");
    }
    then.run.steps = now.run.steps;
    FrameSettings& frames = then.frames;
    if (frames.every > 0 || !frames.at.empty()) return "";
    frames.every = std::max<std::int64_t>(1, previous / 100);
    if (now.frames.every == 0) now.frames.every = frames.every;
    return fmt::format("frames and measurements go on every {} steps (frames.every)", frames.every);
}

void check_inputs(const std::vector<InputFile>& now, const RunCheckpoint& checkpoint,
                  const std::string& file) {
    bool same = now.size() == checkpoint.inputs.size();
    for (std::size_t i = 0; same && i < now.size(); ++i)
        same = now[i].hash == checkpoint.inputs[i].hash;
    if (same) return;
    throw InputError(fmt::format(
        "{}: cannot be continued: the scene's input files have changed since the run began", file));
}

/// What is restored of a model: refuses numbers that no run has computed, before anything goes on
/// with them.
class FiniteState : public StateArchive {
  public:
    explicit FiniteState(StateArchive& stored) : stored_(stored) {}

    void values(std::string_view name, std::span<double> values) override {
        stored_.values(name, values);
        check(name, values);
    }
    void values(std::string_view name, std::span<std::int64_t> values) override {
        stored_.values(name, values);
    }
    void list(std::string_view name, std::vector<double>& values) override {
        stored_.list(name, values);
        check(name, values);
    }
    void list(std::string_view name, std::vector<std::int64_t>& values) override {
        stored_.list(name, values);
    }
    void text(std::string_view name, std::string& text) override { stored_.text(name, text); }
    [[noreturn]] void refuse(const std::string& why) const override {
        stored_.refuse(why);
        throw InputError(why);  // which refuse() has done: GCC 12 loses sight of it
    }

  private:
    void check(std::string_view name, std::span<const double> values) const {
        for (const double value : values) {
            if (std::abs(value) <= largest_field_value) continue;
            refuse(fmt::format("its {} has a value of {:g}, which is impossible", name, value));
        }
    }

    StateArchive& stored_;
};

/// Compares what a run left with what its checkpoint counts.
class LeftOutputs {
  public:
    LeftOutputs(const RunFolder& folder, const RunCheckpoint& checkpoint)
        : folder_(folder), checkpoint_(checkpoint) {}

    void check_records(const Snapshot& first) {
        const RecordPaths files = folder_.records();
        const RecordPositions& records = checkpoint_.records;
        check_table(files.measurements, records.measurements);
        check_table(files.avalanches, records.avalanches);
        if (records.fields.records >= 0) {
            const auto [left, differs] = difference(files.fields, first, records.fields);
            note(left, differs);
        }
    }

    void check_beds() {
        for (const BedRecord& bed : checkpoint_.beds) {
            for (const BedRecord::File& file : bed.files)
                check_whole(folder_.bed(bed.step, file.ending), file.hash);
        }
    }

    void check_frames(bool as_frames) {
        const std::string differs = difference(folder_.frame_list(), checkpoint_.frames);
        if (checkpoint_.frames.frames > 0) note(surviving_file(folder_.frame_list()), differs);
        if (checkpoint_.frames.frames == 0 || !differs.empty()) return;
        FrameListReader frames(folder_.frame_list());
        for (std::int64_t number = 0; number < checkpoint_.frames.frames; ++number) {
            check_whole(as_frames ? folder_.frame(number) : folder_.movie_frame(number),
                        frames.next().file);
        }
    }

    /// Throws InputError where anything differs.
    void finish() const {
        if (first_.empty()) return;
        throw InputError(fmt::format(
            "{}{}; restore it as it was, or run the scene from its start with --force", first_,
            others_ == 0 ? ""
                         : fmt::format(" (and {} more {})", others_,
                                       others_ == 1 ? "file differs" : "files differ")));
    }

  private:
    void check_table(const fs::path& file, const FileBeginning& table) {
        if (table.length >= 0) note(surviving_file(file), difference(file, table));
    }

    void check_whole(const fs::path& file, const Sha256& hash) {
        std::error_code fault;
        if (!fs::exists(file, fault)) {
            note(file, "does not exist");
        } else if (!fs::is_regular_file(file, fault)) {
            note(file, "is not a file");
        } else if (file_hash(file) != hash) {
            note(file, "has changed since it was written");
        }
    }

    void note(const fs::path& file, const std::string& differs) {
        if (differs.empty()) return;
        if (!first_.empty()) {
            ++others_;
        } else {
            first_ = fmt::format("{}: {}", file.string(), differs);
        }
    }

    const RunFolder& folder_;
    const RunCheckpoint& checkpoint_;
    std::string first_;
    int others_ = 0;
};

/// What a resumed run cannot make again must be as it was.
void check_outputs(const RunFolder& folder, const Scene& scene, const RunCheckpoint& checkpoint,
                   const Snapshot& first) {
    LeftOutputs outputs(folder, checkpoint);
    outputs.check_records(first);
    outputs.check_beds();
    outputs.check_frames(scene.output.frames);
    outputs.finish();
}

}  // namespace

ResumedRun resume_run(const RunFolder& folder, const std::string& asked,
                      const WorkOptions& options) {
    const std::string file = folder.checkpoint().string();
    ResumedRun resumed;
    resumed.rest = open_checkpoint(folder.checkpoint());
    RunCheckpoint& checkpoint = resumed.checkpoint;
    checkpoint.serialise(*resumed.rest);
    check_program(checkpoint, file);
    WorkOptions work = options;
    work.pinned = work.pinned || parse_environment(checkpoint.drawing).pinned;
    prepare_drawing(work);

    Scene then = parse_scene(checkpoint.scene, file, "");
    Scene scene = asked.empty() ? parse_scene(checkpoint.scene, file, "", options.settings)
                                : read_scene(asked, options.settings);
    if (asked.empty()) find_inputs(scene, checkpoint.inputs, folder.checkpoint(), "run");
    const bool was_complete = folder.is_complete();
    resumed.is_longer = was_complete && scene.run.steps != then.run.steps;
    if (was_complete) resumed.note = lengthen(then, scene, file);
    PreparedRun& run = resumed.run;
    run = prepare_run(std::move(scene), options.threads);
    check_scene(run.scene, then, file, was_complete);
    check_inputs(run.initial.inputs, checkpoint, file);
    if (!checkpoint.inputs.empty()) {  // as the run's pictures name them
        run.initial.inputs = checkpoint.inputs;
        name_inputs(run.scene, checkpoint.inputs, &InputFile::path);
    }
    resumed.first = run.model->snapshot();
    check_outputs(folder, run.scene, checkpoint, resumed.first);
    FiniteState state(*resumed.rest);
    run.model->serialise(state);
    if (run.model->steps_done() != checkpoint.step)
        resumed.rest->refuse("its model is at a different step");
    if (const std::string fault = beyond_ground(run.model->snapshot()); !fault.empty())
        resumed.rest->refuse("its state is invalid: " + fault);
    return resumed;
}

}  // namespace fumon
