#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/snapshot.h"

namespace fumon {

/// One of the counts by which a job goes on: steps, frames, runs.
struct JobStage {
    std::string name;  ///< "steps"
    std::int64_t done = 0;
    std::int64_t all = 0;
    std::string pace{};  ///< "4.1 million cell-steps/s"; empty: nothing to tell
};

/// How far a job is.
struct JobState {
    std::vector<JobStage> stages;
    double seconds_left = -1.0;           ///< below 0: not known
    std::vector<std::string> messages{};  ///< the last ones, oldest first
    std::int64_t pictures = 0;            ///< how many newest pictures there have been
    std::string picture_name{};           ///< "frame 12"
    std::string outcome{};                ///< how it ended; empty: it goes on
};

/// What a job tells those who watch it. Any thread may call any of it. Where nobody has asked for
/// state() in the last seconds, the job is asked for no picture and no snapshot.
class JobWatch {
  public:
    // ---- called by the job ----

    void message(const std::string& line);
    void tell(std::vector<JobStage> stages, double seconds_left);
    /// Whether a picture would be looked at: somebody watches, and the last one is three seconds
    /// old.
    [[nodiscard]] bool wants_picture() const;
    void show(std::shared_ptr<const Image> picture, std::string name);
    /// Whether the present state would be looked at.
    [[nodiscard]] bool wants_snapshot() const { return wants_snapshot_.load(); }
    void take(std::shared_ptr<const Snapshot> snapshot);
    /// Whether anybody has asked in the last seconds.
    [[nodiscard]] bool has_clients() const;
    /// Says how the job ended, and waits some seconds until all who watch have heard of it and ask
    /// for nothing more.
    void end(const std::string& outcome);

    // ---- called for those who watch ----

    /// `client` tells them apart; `is_last`: it asks for nothing more once the job has ended.
    [[nodiscard]] JobState state(const std::string& client, bool is_last = true);
    [[nodiscard]] std::shared_ptr<const Image> picture() const;
    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot() const;
    /// Whether what was drawn for those who watch is less than 1 % of the time since.
    [[nodiscard]] bool may_draw() const;
    /// Asks for a newer snapshot as soon as may_draw().
    void ask_for_snapshot();
    /// Counts the seconds that something took to draw.
    void spend(double seconds);

  private:
    using Clock = std::chrono::steady_clock;
    struct Client {
        Clock::time_point asked{};
        bool heard_of_end = false;
    };

    [[nodiscard]] bool is_watched() const;
    [[nodiscard]] bool all_have_heard() const;

    mutable std::mutex mutex_;
    JobState state_;
    std::map<std::string, Client> clients_;
    std::shared_ptr<const Image> picture_;
    std::shared_ptr<const Snapshot> snapshot_;
    Clock::time_point shown_{};
    Clock::time_point next_drawing_{};
    std::atomic<bool> wants_snapshot_{false};
};

}  // namespace fumon
