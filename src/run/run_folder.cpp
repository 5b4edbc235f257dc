#include "run/run_folder.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/input_file.h"
#include "files/terrain/terrain_format.h"
#include "run/run_checkpoint.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

void remove_with_temporary(const fs::path& file) {
    std::error_code fault;
    fs::remove(file, fault);
    fs::remove(file.string() + ".part", fault);
}

/// Removes files of ours numbered `from` or more (by their beginning and end) from one folder, and
/// nothing else.
void remove_numbered(const fs::path& folder, const std::string& begin, const std::string& end,
                     std::int64_t from = 0) {
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder, fault)) {
        const std::string name = entry.path().filename().string();
        const bool partial = name.ends_with(end + ".part");
        if (!name.starts_with(begin) || (!name.ends_with(end) && !partial)) continue;
        const std::int64_t number = std::atoll(name.c_str() + begin.size());
        if (partial || number >= from) fs::remove(entry.path(), fault);
    }
}

/// Every ending that a file of a bed may have.
std::vector<std::string> bed_endings() {
    std::vector<std::string> endings;
    for (const TerrainFormat& format : terrain_formats())
        endings.insert(endings.end(), format.endings.begin(), format.endings.end());
    return endings;
}

/// Removes the beds of steps from `from` on.
void remove_beds(const fs::path& folder, std::int64_t from) {
    for (const std::string& ending : bed_endings()) remove_numbered(folder, "bed_", ending, from);
}

constexpr const char* movie_frames = "movie_frames";

}  // namespace

void make_folder(const fs::path& folder) {
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault || !fs::is_directory(folder)) {
        throw Error(fmt::format("cannot make the folder {}: {}", folder.string(),
                                fault ? fault.message() : "a file is in the way"));
    }
}

RunParts run_parts(const Scene& scene, double checkpoint_minutes) {
    const OutputSettings& output = scene.output;
    const bool begins_again = checkpoint_minutes > 0.0 && output.movie && !output.frames;
    return {output.frames, begins_again, output.bed_every > 0 || !output.bed_at.empty()};
}

RunFolder::RunFolder(fs::path folder, bool force) : folder_(std::move(folder)), force_(force) {
    std::error_code fault;
    if (fs::exists(folder_, fault) && !fs::is_directory(folder_, fault)) {
        throw InputError(
            fmt::format("{} is a file; name a folder for the run with -o", folder_.string()));
    }
    refuse_former_run();
}

void RunFolder::refuse_former_run() const {
    std::error_code fault;
    if (force_ || !fs::exists(manifest(), fault)) return;
    throw InputError(fmt::format(
        "{} already holds a run; name another folder, or --force replaces it{}", folder_.string(),
        fs::exists(checkpoint(), fault) ? ", and --resume goes on with it" : ""));
}

void RunFolder::create(const RunParts& parts) {
    make_folder(folder_);
    lock_.emplace(folder_);
    refuse_former_run();  // one that began and ended while this one was being set up
    const RecordPaths written = records();
    for (const fs::path& file : {checkpoint(), manifest(), movie(), written.measurements,
                                 written.avalanches, written.fields})
        remove_with_temporary(file);
    remove_numbered(folder_ / "frames", "frame_", ".png");
    remove_beds(folder_ / "beds", 0);
    tidy();
    make_parts(parts);
}

void RunFolder::make_parts(const RunParts& parts) const {
    if (parts.frames) make_folder(folder_ / "frames");
    if (parts.movie_frames) make_folder(folder_ / movie_frames);
    if (parts.beds) make_folder(folder_ / "beds");
}

void RunFolder::enter() {
    std::error_code fault;
    if (!fs::exists(manifest(), fault)) {
        throw InputError(fmt::format("{} holds no run to go on with; start one with -o {}",
                                     folder_.string(), folder_.string()));
    }
    lock_.emplace(folder_);
    if (is_complete() || fs::exists(checkpoint(), fault)) return;
    throw InputError(fmt::format(
        "{}: is not there: the run was stopped before its first checkpoint, or the file "
        "was taken away; run the scene from its start with --force",
        checkpoint().string()));
}

bool RunFolder::is_complete() const {
    const auto json = nlohmann::json::parse(read_input_file(manifest()), nullptr, false);
    return json.is_object() && json.value("status", nlohmann::json()) == "complete";
}

void RunFolder::go_on(const RunParts& parts, const RunCheckpoint& checkpoint) {
    const RecordPaths written = records();
    if (checkpoint.records.measurements.length < 0) remove_with_temporary(written.measurements);
    if (checkpoint.records.avalanches.length < 0) remove_with_temporary(written.avalanches);
    if (checkpoint.records.fields.records < 0) remove_with_temporary(written.fields);
    const std::int64_t frames = checkpoint.frames.frames;
    remove_numbered(folder_ / "frames", "frame_", ".png", frames);
    remove_numbered(folder_ / movie_frames, "frame_", ".png", frames);
    remove_beds(folder_ / "beds", checkpoint.step + 1);
    make_parts(parts);
}

void RunFolder::tidy() const {
    std::error_code fault;
    fs::remove(checkpoint(), fault);
    forget_frames();
    fs::remove(records().fields.string() + ".former", fault);
    remove_numbered(folder_ / movie_frames, "frame_", ".png");
    fs::remove(folder_ / movie_frames, fault);
}

void RunFolder::forget_frames() const {
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
