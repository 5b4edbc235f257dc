#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/recorder.h"

namespace fumon {

/// Makes a folder and its parents, if they are not there yet. Throws Error.
void make_folder(const std::filesystem::path& folder);

/// The folder of one run: run.json, frames/frame_000000.png …, movie.mp4, measurements.csv,
/// avalanches.csv, fields.nc, beds/bed_00001000.asc.
class RunFolder {
  public:
    /// Makes nothing yet. Throws InputError when the folder already holds a run and `force` is not
    /// given, or when the path is a file.
    RunFolder(std::filesystem::path folder, bool force);

    /// Makes the folder (and its parents) and takes a former run's files away. Throws Error.
    void create(bool with_frames, bool with_beds);

    [[nodiscard]] std::filesystem::path manifest() const { return folder_ / "run.json"; }
    [[nodiscard]] std::filesystem::path movie() const { return folder_ / "movie.mp4"; }
    [[nodiscard]] RecordPaths records() const {
        return {folder_ / "measurements.csv", folder_ / "avalanches.csv", folder_ / "fields.nc"};
    }
    [[nodiscard]] std::filesystem::path frame(std::int64_t number) const {
        return folder_ / frame_name(number);
    }
    [[nodiscard]] std::filesystem::path bed(std::int64_t step) const {
        return folder_ / bed_name(step);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

    /// Names within the folder, as the manifest lists them.
    [[nodiscard]] static std::string frame_name(std::int64_t number);
    [[nodiscard]] static std::string bed_name(std::int64_t step);

  private:
    std::filesystem::path folder_;
};

}  // namespace fumon
