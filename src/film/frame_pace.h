#pragma once

#include <cstdint>
#include <string>

namespace fumon {

/// How fast a film's frames are drawn. Those that were kept from before come at once and say
/// nothing of the others.
class FramePace {
  public:
    /// One frame more, ready so many seconds after the film was begun.
    void count(bool drawn, double seconds);
    /// How many are ready.
    [[nodiscard]] std::int64_t done() const { return done_; }
    /// Frames a second; after count().
    [[nodiscard]] double per_second() const;
    /// What the rest of so many frames will take.
    [[nodiscard]] double seconds_left(std::int64_t frames) const;
    /// "frame 12/60 at 1.5 frames/s, 0:32 left" of so many frames.
    [[nodiscard]] std::string text(std::int64_t frames) const;

  private:
    std::int64_t done_ = 0;
    std::int64_t drawn_ = 0;
    double drawing_ = 0.0;  ///< seconds
    double last_ = 0.0;     ///< likewise, when the last frame was ready
};

}  // namespace fumon
