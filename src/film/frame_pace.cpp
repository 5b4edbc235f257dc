#include "film/frame_pace.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.h"
#include "run/terminal/progress.h"

namespace fumon {

void FramePace::count(bool drawn, double seconds) {
    ++done_;
    if (drawn) {
        ++drawn_;
        drawing_ += seconds - last_;
    }
    last_ = seconds;
}

double FramePace::per_second() const {
    const double counted = static_cast<double>(drawn_ > 0 ? drawn_ : done_);
    return counted / std::max(1e-9, drawn_ > 0 ? drawing_ : last_);
}

double FramePace::seconds_left(std::int64_t frames) const {
    return static_cast<double>(frames - done_) / per_second();
}

std::string FramePace::text(std::int64_t frames) const {
    return fmt::format("frame {}/{} at {:.2g} frames/s, {} left", with_commas(done_),
                       with_commas(frames), per_second(), clock_text(seconds_left(frames)));
}

}  // namespace fumon
