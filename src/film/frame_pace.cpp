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

std::string FramePace::text(std::int64_t frames) const {
    const double counted = static_cast<double>(drawn_ > 0 ? drawn_ : done_);
    const double seconds = std::max(1e-9, drawn_ > 0 ? drawing_ : last_);
    const double left = seconds / counted * static_cast<double>(frames - done_);
    return fmt::format("frame {}/{} at {:.2g} frames/s, {} left", with_commas(done_),
                       with_commas(frames), counted / seconds, clock_text(left));
}

}  // namespace fumon
