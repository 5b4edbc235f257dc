#include "run/terminal/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "run/terminal/job_watch.h"

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
    constexpr double report_interval_s = 0.2;
    if (watch() != nullptr && since_report_.seconds() >= report_interval_s) report_to_watch();
    if (status_.due()) status_.show(line());
}

void Progress::report_to_watch() {
    since_report_ = {};
    std::vector<JobStage> stages{{"steps", steps_done, steps_, pace_of_steps()}};
    if (frames_ > 0) stages.push_back({"frames", frames_done, frames_, pace_of_frames()});
    watch()->tell(std::move(stages), seconds_left());
}

double Progress::seconds_left() const {
    const double seconds = watch_.seconds();
    return std::max(remaining(steps_before_, steps_done, steps_, seconds),
                    remaining(frames_before_, frames_done, frames_, seconds));
}

std::string Progress::pace_of_steps() const {
    const double seconds = seconds_of_steps;
    if (cells_ <= 0 || !(seconds > 0.0)) return {};
    return fmt::format("{:.3g} million cell-steps/s",
                       1e-6 * static_cast<double>(steps_done - steps_before_) *
                           static_cast<double>(cells_) / seconds);
}

std::string Progress::pace_of_frames() const {
    const double seconds = seconds_of_frames;
    if (!(seconds > 0.0)) return {};
    return fmt::format("{:.2g} frames/s",
                       static_cast<double>(frames_done - frames_before_) / seconds);
}

std::string Progress::line() const {
    const auto at = [](const std::string& pace) { return pace.empty() ? pace : " at " + pace; };
    std::string text = fmt::format("step {}/{}{}", with_commas(steps_done), with_commas(steps_),
                                   at(pace_of_steps()));
    if (frames_ > 0) {
        text += fmt::format(", frame {}/{}{}", with_commas(frames_done), with_commas(frames_),
                            at(pace_of_frames()));
    }
    const double left = seconds_left();
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
