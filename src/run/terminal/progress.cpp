#include "run/terminal/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.h"

namespace fumon {

namespace {

/// What remains of some work at its pace so far, in seconds.
double remaining(std::int64_t before, std::int64_t done, std::int64_t all, double seconds) {
    if (done <= before || done >= all) return 0.0;
    return seconds * static_cast<double>(all - done) / static_cast<double>(done - before);
}

}  // namespace

void Progress::expect(std::int64_t steps, std::int64_t frames) {
    steps_ = steps;
    frames_ = frames;
    steps_before_ = steps_done;
    frames_before_ = frames_done;
    watch_ = {};
    status_.restart();
}

void Progress::show() {
    if (status_.due()) status_.show(line());
}

std::string Progress::line() const {
    const std::int64_t steps = steps_done;
    const std::int64_t frames = frames_done;
    const double of_steps = seconds_of_steps;
    const double of_frames = seconds_of_frames;
    std::string text = fmt::format("step {}/{}", with_commas(steps), with_commas(steps_));
    if (cells_ > 0 && of_steps > 0.0) {
        text += fmt::format(" at {:.3g} million cell-steps/s",
                            1e-6 * static_cast<double>(steps - steps_before_) *
                                static_cast<double>(cells_) / of_steps);
    }
    if (frames_ > 0) {
        text += fmt::format(", frame {}/{}", with_commas(frames), with_commas(frames_));
        if (of_frames > 0.0) {
            text += fmt::format(" at {:.2g} frames/s",
                                static_cast<double>(frames - frames_before_) / of_frames);
        }
    }
    const double seconds = watch_.seconds();
    const double left = std::max(remaining(steps_before_, steps, steps_, seconds),
                                 remaining(frames_before_, frames, frames_, seconds));
    if (left > 0.0) text += fmt::format(", {} left", clock_text(left));
    return text;
}

std::string clock_text(double seconds) {
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    constexpr std::int64_t minute = 60;
    constexpr std::int64_t hour = 3600;
    if (whole >= hour)
        return fmt::format("{}:{:02}:{:02}", whole / hour, whole % hour / minute, whole % minute);
    return fmt::format("{}:{:02}", whole / minute, whole % minute);
}

}  // namespace fumon
