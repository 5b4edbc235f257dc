#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "base/sha256.h"
#include "files/appended_file.h"

namespace fumon {

/// A frame that a run has written, as a file or into its movie alone.
struct FrameRecord {
    std::int64_t number = 0;  ///< from 0 without gaps
    std::int64_t step = 0;
    double time = 0.0;
    Sha256 pixels{};
    Sha256 file{};  ///< of its PNG file's bytes; zeros where there is none
};

/// How far a list of frames has come.
struct FrameCount {
    std::int64_t frames = 0;
    Sha256 hash{};  ///< SHA-256 of their records, where they are listed in a file
};

/// The frames that a run has written, in their order. Their records go to a file, so that memory
/// does not grow with their number: 80 bytes each, the step (int64), the time (float64), the
/// SHA-256 of the pixels and that of the PNG file, numbers little-endian.
class FrameList {
  public:
    /// Without a file frames are only counted. Goes on behind the `previous` ones in the file of a
    /// program that was stopped. Throws InputError where they are not there or have changed, Error
    /// where the file cannot be made or written.
    explicit FrameList(const std::optional<std::filesystem::path>& file,
                       const FrameCount& previous = {});

    /// Throws Error on a full disk or any failed write.
    void add(const FrameRecord& frame);

    [[nodiscard]] std::int64_t frames() const { return frames_; }
    /// 0 where there is no frame.
    [[nodiscard]] std::int64_t last_step() const { return last_step_; }
    /// SHA-256 over the pixel hashes of all frames.
    [[nodiscard]] Sha256 pixels() const { return pixels_.so_far(); }

    /// Puts the file on disk. Throws Error.
    [[nodiscard]] FrameCount sync();
    /// Gives the file its name. Throws Error.
    void commit();

  private:
    void count(const FrameRecord& frame);

    std::optional<AppendedFile> file_;
    std::int64_t frames_ = 0;
    std::int64_t last_step_ = 0;
    Sha256Stream pixels_;
};

/// Reads a list's frames from its file, one after another, also while more are added.
class FrameListReader {
  public:
    /// Throws InputError where there is no such file.
    explicit FrameListReader(const std::filesystem::path& file);
    /// Throws InputError where there is no further one.
    FrameRecord next();

  private:
    std::filesystem::path file_;
    std::ifstream bytes_;
    int reason_ = 0;  ///< why the file could not be opened, an errno value
    std::int64_t frames_ = 0;
};

/// Why the first frames of a list's file are not those that were counted; empty where they are. As
/// `difference` of files/appended_file.h.
std::string difference(const std::filesystem::path& file, const FrameCount& counted);

}  // namespace fumon
