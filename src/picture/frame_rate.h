#pragma once

namespace fumon {

/// A frame rate as movies need it: `frames` in `seconds`.
struct FrameRate {
    int frames = 0;
    int seconds = 1;
    friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

/// The sensible fraction of a positive decimal rate: whole numbers as they are; 23.976 (or 23.98),
/// 29.97, 47.95, 59.94 and 119.88 as 24, 30, 48, 60 and 120 × 1000/1001 (SMPTE ST 12-1); any other
/// as the nearest fraction with a denominator up to 1001. The rate is at most 1,000,000.
FrameRate frame_rate(double frames_per_second);

}  // namespace fumon
