#pragma once

#include <algorithm>
#include <limits>

#include "base/stopwatch.h"

namespace fumon {

/// Of several steps the fastest, which other programs disturbed least.
class Fastest {
  public:
    /// Returns the seconds that this one took.
    template <class Step>
    double time(const Step& step) {
        const Stopwatch watch;
        step();
        const double seconds = watch.seconds();
        seconds_ = std::min(seconds_, seconds);
        return seconds;
    }
    /// Million cell-steps per second.
    [[nodiscard]] double rate(double cells) const { return 1e-6 * cells / seconds_; }

  private:
    double seconds_ = std::numeric_limits<double>::infinity();
};

}  // namespace fumon
