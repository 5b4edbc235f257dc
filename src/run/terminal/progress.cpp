#include "run/terminal/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.h"

namespace fumon {

void Progress::expect(std::int64_t steps, std::int64_t frames) {
    steps_ = steps;
    frames_ = frames;
    watch_ = {};
    status_.restart();
}

void Progress::show() {
    if (status_.due()) status_.show(line());
}

std::string Progress::line() const {
    const double seconds = watch_.seconds();
    const std::int64_t steps = steps_done.load();
    const std::int64_t frames = frames_done.load();
    double share = steps_ > 0 ? static_cast<double>(steps) / static_cast<double>(steps_) : 1.0;
    std::string text = fmt::format("step {}/{}", with_commas(steps), with_commas(steps_));
    if (frames_ > 0) {
        share = std::min(share, static_cast<double>(frames) / static_cast<double>(frames_));
        text += fmt::format("  frame {}/{}  {:.1f} frames/s", with_commas(frames),
                            with_commas(frames_), static_cast<double>(frames) / seconds);
    }
    if (cells_ > 0 && steps > 0) {
        text +=
            fmt::format("  {:.3g} million cell-steps/s",
                        1e-6 * static_cast<double>(steps) * static_cast<double>(cells_) / seconds);
    }
    if (share > 0.0) text += fmt::format("  {} left", clock_text(seconds * (1.0 - share) / share));
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
