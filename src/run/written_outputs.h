#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "run/frame_list.h"

namespace fumon {

/// A bed that a run has written.
struct BedRecord {
    struct File {
        std::string ending;  ///< of its name, ".asc"
        Sha256 hash{};       ///< of its bytes
    };
    std::int64_t step = 0;
    std::vector<File> files;
};

/// The frames and beds of a run on their way: one thread sends them, others write them, and some
/// wait until all that was sent is written.
class WrittenOutputs {
  public:
    /// `beds` were written by a former run.
    explicit WrittenOutputs(std::vector<BedRecord> beds)
        : beds_sent_(beds.size()), beds_(std::move(beds)) {}

    /// Before anything is sent: lists the frames in a file, behind those of a former run. Without
    /// it they are only counted. Throws as FrameList.
    void list_frames(const std::filesystem::path& file, const FrameCount& previous);

    void send_frame();
    void send_bed();
    void add_frame(const FrameRecord& frame);  ///< that is written; throws as FrameList
    void add_bed(BedRecord bed);               ///< likewise

    /// Waits until all that was sent is written. False when aborted.
    [[nodiscard]] bool wait_for_all();
    /// Wakes those who wait.
    void abort();

    /// For threads that have waited, while nothing else is sent.
    [[nodiscard]] FrameList& frames() { return *frames_; }
    [[nodiscard]] const std::vector<BedRecord>& beds() const { return beds_; }

  private:
    std::mutex mutex_;
    std::condition_variable written_;
    bool aborted_ = false;
    std::int64_t frames_sent_ = 0;
    std::size_t beds_sent_;
    std::unique_ptr<FrameList> frames_ = std::make_unique<FrameList>(std::nullopt);
    std::vector<BedRecord> beds_;
};

}  // namespace fumon
