#include "picture/frame_rate.h"

#include <algorithm>
#include <cmath>

namespace fumon {

FrameRate frame_rate(double frames_per_second) {
    constexpr double television_tolerance =
        0.005;  // frames per second: rates are quoted to 2 places
    for (const int nominal : {24, 30, 48, 60, 120}) {
        const double television = nominal * 1000.0 / 1001.0;
        if (std::abs(frames_per_second - television) < television_tolerance)
            return {nominal * 1000, 1001};
    }
    constexpr double fastest = 1'000'000.0;  // frames per second
    constexpr int largest_denominator = 1001;
    constexpr double exact = 1e-9;  // relative
    const double rate = std::min(frames_per_second, fastest);
    FrameRate best{1, largest_denominator};
    double smallest_error = std::abs(rate - 1.0 / largest_denominator);
    for (int seconds = 1; seconds <= largest_denominator; ++seconds) {
        const double frames = std::max(1.0, std::round(rate * seconds));
        const double error = std::abs(rate - frames / seconds);
        if (error >= smallest_error) continue;
        best = {static_cast<int>(frames), seconds};
        smallest_error = error;
        if (error <= exact * rate) break;
    }
    return best;
}

}  // namespace fumon
