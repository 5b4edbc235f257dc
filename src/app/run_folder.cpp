#include "app/run_folder.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "support/error.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

void remove_with_temporary(const fs::path& file) {
    std::error_code fault;
    fs::remove(file, fault);
    fs::remove(file.string() + ".part", fault);
}

/// Removes numbered files of ours (by their beginning and end) from one folder, and nothing else.
void remove_numbered(const fs::path& folder, const std::string& begin, const std::string& end) {
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder, fault)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(begin) && (name.ends_with(end) || name.ends_with(end + ".part"))) {
            fs::remove(entry.path(), fault);
        }
    }
}

}  // namespace

void make_folder(const fs::path& folder) {
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault || !fs::is_directory(folder)) {
        throw Error(fmt::format("cannot make the folder {}: {}", folder.string(),
                                fault ? fault.message() : "a file is in the way"));
    }
}

RunFolder::RunFolder(fs::path folder, bool force) : folder_(std::move(folder)) {
    std::error_code fault;
    if (fs::exists(folder_, fault) && !fs::is_directory(folder_, fault)) {
        throw InputError(
            fmt::format("{} is a file; name a folder for the run with -o", folder_.string()));
    }
    if (!force && fs::exists(manifest(), fault)) {
        throw InputError(
            fmt::format("{} already holds a run; name another folder, or --force replaces it",
                        folder_.string()));
    }
}

void RunFolder::create(bool with_frames, bool with_beds) {
    make_folder(folder_);
    const RecordPaths written = records();
    for (const fs::path& file :
         {manifest(), movie(), written.measurements, written.avalanches, written.fields})
        remove_with_temporary(file);
    remove_numbered(folder_ / "frames", "frame_", ".png");
    remove_numbered(folder_ / "beds", "bed_", ".asc");
    if (with_frames) make_folder(folder_ / "frames");
    if (with_beds) make_folder(folder_ / "beds");
}

std::string RunFolder::frame_name(std::int64_t number) {
    return fmt::format("frames/frame_{:06}.png", number);
}

std::string RunFolder::bed_name(std::int64_t step) {
    return fmt::format("beds/bed_{:08}.asc", step);
}

}  // namespace fumon
