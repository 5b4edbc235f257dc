#include "run/manifest.h"

#include <fmt/format.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "base/thread_clock.h"
#include "files/atomic_file.h"
#include "files/json_text.h"
#include "files/terrain/terrain_format.h"
#include "run/build_identity.h"
#include "run/frame_list.h"
#include "scene/json.h"
#include "wind/drift_json.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

Json manifest_head(const ManifestFacts& facts, const std::string& status,
                   const DrawingRecord& drawing) {
    const InitialBed& initial = facts.initial;
    Json json;
    json["fumon"] = FUMON_VERSION;
    json["sources_sha256"] = this_build().sources;
    json["status"] = status;
    json["title"] = facts.scene.title;
    json["model"] = facts.scene.model.name;
    json["seed"] = facts.scene.seed;
    json["steps_planned"] = facts.scene.run.steps;
    json["grid"] = {{"nx", initial.bed.nx()},
                    {"ny", initial.bed.ny()},
                    {"dx", initial.scale.dx},
                    {"dy", initial.scale.dy},
                    {"length_unit", initial.scale.in_metres ? "m" : "sites"},
                    {"height_unit", initial.scale.height_unit}};
    if (!facts.winds.empty()) json["drift"] = drift_json(facts.winds);
    json["inputs"] = Json::array();
    for (const InputFile& input : initial.inputs) {
        json["inputs"].push_back({{"path", input.path}, {"sha256", input.hash}});
    }
    if (!initial.note.empty()) json["note"] = initial.note;
    if (status != "complete") json["may_write"] = files_json(facts.files);
    json["scene"] = scene_json(facts.scene);
    const RenderingEnvironment& environment = drawing.environment;
    if (!environment.backend.empty()) {
        json["drawing"] = parse_json(environment_text(environment));
        if (!drawing.pinning_obstacle.empty())
            json["drawing"]["why_not_pinned"] = drawing.pinning_obstacle;
        if (!drawing.text_library.empty()) json["drawing"]["text_library"] = drawing.text_library;
        json["drawing"]["vertical_exaggeration"] = drawing.exaggeration;
    }
    return json;
}

Json performance(const ManifestFacts& facts, const RunOutcome& outcome) {
    const Timing& timing = outcome.timing;
    const double cells = static_cast<double>(facts.initial.bed.size());
    Json json;
    json["wall_seconds"] = timing.wall;
    json["simulation_seconds"] = timing.simulation_wall;
    json["simulation_cpu_seconds"] = timing.simulation_cpu;
    json["rendering_seconds"] = timing.rendering_wall;
    json["rendering_cpu_seconds"] = timing.rendering_cpu;
    json["encoding_seconds"] = timing.encoding_wall;
    json["encoding_cpu_seconds"] = timing.encoding_cpu;
    json["cell_steps_per_second"] =
        timing.simulation_wall > 0.0
            ? cells * static_cast<double>(outcome.steps_done - outcome.steps_before) /
                  timing.simulation_wall
            : 0.0;
    json["peak_memory_bytes"] = peak_memory_bytes();
    json["threads"] = facts.threads;
    return json;
}

std::string status_of(const RunOutcome& outcome) {
    if (outcome.error) return "failed";
    return outcome.signal != 0 ? "interrupted" : "complete";
}

/// Written line by line: a run may have very many frames.
void write_frames(AtomicFile& file, const ManifestFacts& facts, const RunFolder& folder,
                  const RunOutcome& outcome) {
    if (outcome.frames == 0) return;
    FrameListReader frames(folder.frame_list());
    for (std::int64_t number = 0; number < outcome.frames; ++number) {
        const FrameRecord frame = frames.next();
        Json entry{{"number", frame.number}, {"step", frame.step}, {"time", frame.time}};
        if (facts.scene.output.frames) entry["file"] = RunFolder::frame_name(frame.number);
        entry["pixels_sha256"] = hex(frame.pixels);
        file.write(fmt::format("{}\n    {}", number == 0 ? "" : ",", json_text(entry, -1)));
    }
}

}  // namespace

void write_running_manifest(const RunFolder& folder, const ManifestFacts& facts,
                            const DrawingRecord& drawing) {
    write_file(folder.manifest(), json_text(manifest_head(facts, "running", drawing), 2) + "\n");
}

void write_final_manifest(const RunFolder& folder, const ManifestFacts& facts,
                          const RunOutcome& outcome) {
    Json json = manifest_head(facts, status_of(outcome), outcome.drawing);
    if (outcome.signal != 0) json["signal"] = outcome.signal == SIGINT ? "SIGINT" : "SIGTERM";
    if (outcome.error) json["error"] = error_text(outcome.error);
    json["steps_done"] = outcome.steps_done;
    json["time"] = outcome.time;
    if (!outcome.error && !outcome.cancelled) json["state_sha256"] = hex(outcome.state);
    if (!outcome.plausibility_warning.empty()) json["implausible"] = outcome.plausibility_warning;
    if (!outcome.resumed_at.empty()) json["resumed_at_steps"] = outcome.resumed_at;
    if (outcome.checkpoint && status_of(outcome) != "complete") {
        json["checkpoint"] = {{"step", *outcome.checkpoint},
                              {"file", folder.checkpoint().filename().string()}};
    }
    const RecordPaths records = folder.records();
    if (outcome.recorded.measurements)
        json["measurements"] = records.measurements.filename().string();
    if (outcome.recorded.avalanches) json["avalanches"] = records.avalanches.filename().string();
    if (outcome.recorded.fields) json["fields"] = records.fields.filename().string();
    if (outcome.movie.frames > 0) {
        json["movie"] = {{"file", folder.movie().filename().string()},
                         {"frames", outcome.movie.frames},
                         {"width", outcome.movie.width},
                         {"height", outcome.movie.height},
                         {"frames_per_second", facts.scene.output.movie_rate}};
    }
    json["beds"] = Json::array();
    for (const BedRecord& bed : outcome.beds) {
        for (const std::string& name : facts.scene.output.bed_format) {
            const std::string_view ending = find_written_format(name)->endings.front();
            json["beds"].push_back(
                {{"step", bed.step}, {"file", RunFolder::bed_name(bed.step, ending)}});
        }
    }
    json["performance"] = performance(facts, outcome);

    std::string text = json_text(json, 2);
    text.resize(text.rfind('\n'));  // the closing brace comes after the frames
    AtomicFile file(folder.manifest());
    file.write(text + ",\n  \"frames\": [");
    write_frames(file, facts, folder, outcome);
    file.write("\n  ]\n}\n");
    file.sync();
    file.commit();
    sync_folder_of(folder.manifest());
}

std::string error_text(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const std::exception& caught) {
        return caught.what();
    } catch (...) {
        return "unknown error";
    }
}

}  // namespace fumon
