#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "run/frame_list.h"

namespace fumon {

/// The frames and beds of a run on their way: one thread sends them, others write them, and some
/// wait until all that was sent is written.
class WrittenOutputs {
  public:
    /// Beds of these steps were written by a former run.
    explicit WrittenOutputs(std::vector<std::int64_t> bed_steps)
        : beds_sent_(bed_steps.size()), bed_steps_(std::move(bed_steps)) {}

    /// Before anything is sent: lists the frames in a file, behind so many of a former run. Without
    /// it they are only counted. Throws as FrameList.
    void list_frames(const std::filesystem::path& file, std::int64_t frames_before);

    void send_frame();
    void send_bed();
    void add_frame(const FrameRecord& frame);  ///< that is written; throws as FrameList
    void add_bed(std::int64_t step);           ///< likewise

    /// Waits until all that was sent is written. False when aborted.
    [[nodiscard]] bool wait_for_all();
    /// Wakes those who wait.
    void abort();

    /// For threads that have waited, while nothing else is sent.
    [[nodiscard]] FrameList& frames() { return *frames_; }
    [[nodiscard]] const std::vector<std::int64_t>& bed_steps() const { return bed_steps_; }

  private:
    std::mutex mutex_;
    std::condition_variable written_;
    bool aborted_ = false;
    std::int64_t frames_sent_ = 0;
    std::size_t beds_sent_;
    std::unique_ptr<FrameList> frames_ = std::make_unique<FrameList>(std::nullopt);
    std::vector<std::int64_t> bed_steps_;
};

}  // namespace fumon
