#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "files/folder_lock.h"
#include "run/recorder.h"
#include "run/run_files.h"

namespace fumon {

struct RunCheckpoint;

/// Which folders a run has in its own.
struct RunParts {
    bool frames = false;
    bool movie_frames = false;  ///< of a movie without frames, so that it can be begun again
    bool beds = false;
};

/// `checkpoint_minutes`: between checkpoints; 0: none, so that nothing is kept for them.
RunParts run_parts(const Scene& scene, double checkpoint_minutes);

/// Makes a folder and its parents, if they are not there yet. Throws Error.
void make_folder(const std::filesystem::path& folder);

/// The folder of one run: run.json, frames/frame_000000.png …, movie.mp4, measurements.csv,
/// avalanches.csv, fields.nc, beds/bed_00001000.asc (or another terrain format); and
/// checkpoint.fumon and, while the run is not complete or where frames are drawn, frames.fumon
/// (run/frame_list.h) and, where a movie is made and no frames, movie_frames/frame_000000.png …,
/// from which the movie can be begun again. One program works in it at a time.
class RunFolder {
  public:
    /// Makes nothing yet. Throws InputError when the folder already holds a run and `force` is not
    /// given, or when the path is a file or the root of the file system.
    RunFolder(std::filesystem::path folder, bool force);

    /// Checks, by the rule of OutputClaims, that a run may write its files; a file that is called
    /// as a run calls its own is in the way, too. Throws InputError, and Error where the folder
    /// cannot be written. `inputs`: what the run reads.
    void check(RunFiles planned, std::vector<std::filesystem::path> inputs);

    /// Creates the folder (and its parents), locks it, checks again and deletes the files of an
    /// earlier run, as its run.json lists them, and what is in the way of those that were planned.
    /// Nothing is deleted in a folder that `frames` or `beds` only links to. Throws Error, and
    /// InputError if another program is working in it or has filled it in the meantime.
    void create(const RunParts& parts);

    /// Locks the folder of a run to resume. Throws InputError if it holds no such run or another
    /// program is working in it.
    void enter();
    /// Whether its run.json says that the run is complete.
    [[nodiscard]] bool is_complete() const;
    /// Deletes what the run wrote after its checkpoint. Throws Error.
    void resume(const RunParts& parts, const RunCheckpoint& checkpoint);
    /// Deletes what a complete run no longer needs. `keeps_last_state`: not what it needs to be
    /// gone on with to a later step.
    void tidy(bool keeps_last_state = false) const;
    /// Takes away the list of frames, which a run without a checkpoint needs no more.
    void remove_frame_list() const;

    [[nodiscard]] std::filesystem::path manifest() const { return folder_ / "run.json"; }
    [[nodiscard]] std::filesystem::path movie() const { return folder_ / "movie.mp4"; }
    [[nodiscard]] RecordPaths records() const {
        return {folder_ / "measurements.csv", folder_ / "avalanches.csv", folder_ / "fields.nc"};
    }
    [[nodiscard]] std::filesystem::path frame(std::int64_t number) const {
        return folder_ / frame_name(number);
    }
    [[nodiscard]] std::filesystem::path movie_frame(std::int64_t number) const;
    [[nodiscard]] std::filesystem::path checkpoint() const { return folder_ / "checkpoint.fumon"; }
    [[nodiscard]] std::filesystem::path frame_list() const { return folder_ / "frames.fumon"; }
    /// `ending`: of its terrain format, ".asc".
    [[nodiscard]] std::filesystem::path bed(std::int64_t step, std::string_view ending) const {
        return folder_ / bed_name(step, ending);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

    /// Names within the folder, as the manifest lists them.
    [[nodiscard]] static std::string frame_name(std::int64_t number);
    [[nodiscard]] static std::string bed_name(std::int64_t step, std::string_view ending);

  private:
    void refuse_previous_run() const;
    void check_files() const;
    void remove_previous_files() const;
    void remove_file(const std::string& name) const;
    void make_parts(const RunParts& parts) const;

    std::filesystem::path folder_;
    bool force_;
    RunFiles planned_;
    std::vector<std::filesystem::path> inputs_;
    std::optional<FolderLock> lock_;
};

}  // namespace fumon
