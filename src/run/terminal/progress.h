#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "base/stopwatch.h"
#include "run/terminal/status_line.h"

namespace fumon {

/// Reports on standard error how far a run is. The pipeline's threads count; one thread prints.
class Progress {
  public:
    /// `watch` is told the same, and outlives this.
    Progress(Verbosity verbosity, std::int64_t cells, JobWatch* watch = nullptr)
        : status_(verbosity, watch), cells_(cells) {}

    /// What is to be done beside what is done by now. Without frames the line shows steps alone.
    void expect(std::int64_t steps, std::int64_t frames);

    std::atomic<std::int64_t> steps_done{0};
    std::atomic<std::int64_t> frames_done{0};
    std::atomic<double> seconds_of_steps{0.0};   ///< spent on those that are shown
    std::atomic<double> seconds_of_frames{0.0};  ///< likewise

    /// Prints the progress line if it is time to. Called often, by one thread.
    void show();

    /// Prints a message above the progress line.
    void note(const std::string& line) { status_.note(line); }        ///< unless quiet
    void verbose(const std::string& line) { status_.verbose(line); }  ///< only when verbose

    /// Clears the progress line.
    void clear() { status_.clear(); }

    /// "step 3/20 at 4.1 million cell-steps/s, frame 2/9 at 1.5 frames/s, 0:07 left": simulation
    /// and drawing go on side by side, each with its own count and its own pace.
    [[nodiscard]] std::string line() const;

    [[nodiscard]] JobWatch* watch() const { return status_.watch(); }

  private:
    void report_to_watch();
    [[nodiscard]] double seconds_left() const;
    [[nodiscard]] std::string pace_of_steps() const;   ///< empty: not known yet
    [[nodiscard]] std::string pace_of_frames() const;  ///< likewise

    StatusLine status_;
    std::int64_t cells_;
    std::int64_t steps_ = 0;
    std::int64_t frames_ = 0;
    std::int64_t steps_before_ = 0;
    std::int64_t frames_before_ = 0;
    Stopwatch watch_;
    Stopwatch since_report_;
};

/// "0:07", "12:34", "3:05:10".
std::string clock_text(double seconds);

}  // namespace fumon
