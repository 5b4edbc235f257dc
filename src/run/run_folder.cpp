#include "run/run_folder.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "files/terrain/terrain_format.h"
#include "outputs/output_claims.h"
#include "run/run_checkpoint.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

void remove_with_temporary(const fs::path& file) {
    std::error_code fault;
    fs::remove(file, fault);
    fs::remove(file.string() + ".part", fault);
}

/// A link to a folder stays.
void remove_empty_folder(const fs::path& folder) {
    std::error_code fault;
    if (!fs::is_symlink(folder, fault)) fs::remove(folder, fault);
}

constexpr const char* movie_frames = "movie_frames";

}  // namespace

void make_folder(const fs::path& folder) {
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault || !fs::is_directory(folder)) {
        throw Error(fmt::format("cannot make the folder {}: {}", folder.string(),
                                fault ? fault.message() : "a file of this name exists"));
    }
}

RunParts run_parts(const Scene& scene, double checkpoint_minutes) {
    const OutputSettings& output = scene.output;
    const bool begins_again = checkpoint_minutes > 0.0 && output.movie && !output.frames;
    return {output.frames, begins_again, output.bed_every > 0 || !output.bed_at.empty()};
}

RunFolder::RunFolder(fs::path folder, bool force) : folder_(std::move(folder)), force_(force) {
    check_output_folder(folder_, "the run");
    refuse_previous_run();
}

void RunFolder::check(RunFiles planned, std::vector<fs::path> inputs) {
    planned_ = std::move(planned);
    inputs_ = std::move(inputs);
    const auto check_part = [this](const char* part, bool is_planned) {
        std::error_code fault;
        if (is_planned && fs::exists(folder_ / part, fault))
            check_output_folder(folder_ / part, "the run");
    };
    check_part("frames", planned_.frames > 0);
    check_part(movie_frames, planned_.movie_frames > 0);
    check_part("beds", !planned_.beds.endings.empty());
    check_files();
}

void RunFolder::check_files() const {
    const RunFiles previous = listed_files(manifest());
    OutputClaims claims(force_);
    claims.reads(inputs_);
    for (const std::string& name : files_named_as_outputs(folder_)) {
        const bool listed = previous.contains(name);
        if (!listed && !force_) refuse_to_replace(folder_ / name);
        if (listed || planned_.contains(name)) claims.check(folder_ / name, true);
    }
}

void RunFolder::refuse_previous_run() const {
    std::error_code fault;
    if (force_ || !fs::exists(manifest(), fault)) return;
    if (listed_files(manifest()).files.empty()) refuse_to_replace(manifest());
    throw InputError(fmt::format(
        "{} already holds a run; name another folder, or replace it with --force{}",
        folder_.string(),
        fs::exists(checkpoint(), fault) && !is_complete() ? ", or continue it with --resume" : ""));
}

void RunFolder::create(const RunParts& parts) {
    make_folder(folder_);
    lock_.emplace(folder_);
    refuse_previous_run();  // one that began and ended while this one was being set up
    check_files();
    remove_previous_files();
    make_parts(parts);
}

void RunFolder::remove_previous_files() const {
    const RunFiles previous = listed_files(manifest());
    for (const std::string& name : files_named_as_outputs(folder_)) {
        const bool goes = previous.contains(name) || planned_.contains(name);
        if (goes && name != "run.json") remove_file(name);
    }
    remove_empty_folder(folder_ / movie_frames);
    remove_file("run.json");  // last: until then it says whose the others are
}

void RunFolder::remove_file(const std::string& name) const {
    const std::string part = name.substr(0, name.find('/'));
    std::error_code fault;
    if (part != name && fs::is_symlink(folder_ / part, fault)) return;
    fs::remove(folder_ / name, fault);
}

void RunFolder::make_parts(const RunParts& parts) const {
    if (parts.frames) make_folder(folder_ / "frames");
    if (parts.movie_frames) make_folder(folder_ / movie_frames);
    if (parts.beds) make_folder(folder_ / "beds");
}

void RunFolder::enter() {
    std::error_code fault;
    if (!fs::exists(manifest(), fault)) {
        throw InputError(fmt::format("{} holds no run to resume; start one with -o {}",
                                     folder_.string(), folder_.string()));
    }
    lock_.emplace(folder_);
    if (is_complete() || fs::exists(checkpoint(), fault)) return;
    throw InputError(
        fmt::format("{}: does not exist: the run was stopped before its first checkpoint, or the "
                    "file was removed; run the scene from its start with --force",
                    checkpoint().string()));
}

bool RunFolder::is_complete() const {
    const auto json = parse_json(read_input_file(manifest()));
    return json.is_object() && json.value("status", nlohmann::ordered_json()) == "complete";
}

void RunFolder::resume(const RunParts& parts, const RunCheckpoint& checkpoint) {
    const RecordPaths written = records();
    if (checkpoint.records.measurements.length < 0) remove_with_temporary(written.measurements);
    if (checkpoint.records.avalanches.length < 0) remove_with_temporary(written.avalanches);
    if (checkpoint.records.fields.records < 0) {
        remove_with_temporary(written.fields);
        remove_fields_pieces(written.fields);
    }
    RunFiles before;
    before.frames = checkpoint.frames.frames;
    before.movie_frames = checkpoint.frames.frames;
    const RunFiles run = listed_files(manifest());
    for (const std::string& name : files_named_as_outputs(folder_)) {
        if (name.find('/') == std::string::npos || !run.contains(name)) continue;
        const std::int64_t step = step_of_bed(name);
        const bool later = step >= 0 ? step > checkpoint.step : !before.contains(name);
        if (later || name.ends_with(".part")) remove_file(name);
    }
    make_parts(parts);
}

void RunFolder::tidy(bool keeps_last_state) const {
    const RunFiles run = listed_files(manifest());
    if (run.frames == 0 && run.contains("movie.mp4")) {  // else they are of others
        for (const std::string& name : files_named_as_outputs(folder_))
            if (name.starts_with(movie_frames)) remove_file(name);
    }
    remove_empty_folder(folder_ / movie_frames);
    remove_fields_pieces(records().fields);
    remove_file("checkpoint.fumon.part");
    if (keeps_last_state) return;
    remove_frame_list();
    remove_file("checkpoint.fumon");
}

void RunFolder::remove_frame_list() const {
    remove_with_temporary(frame_list());
}

fs::path RunFolder::movie_frame(std::int64_t number) const {
    return folder_ / movie_frames / fmt::format("frame_{:06}.png", number);
}

std::string RunFolder::frame_name(std::int64_t number) {
    return fmt::format("frames/frame_{:06}.png", number);
}

std::string RunFolder::bed_name(std::int64_t step, std::string_view ending) {
    return fmt::format("beds/bed_{:08}{}", step, ending);
}

}  // namespace fumon
