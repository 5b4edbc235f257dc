#include "figure/panels/step_text.h"

#include <fmt/format.h>

#include <cmath>

namespace fumon {

namespace {

std::string time_with_unit(double time, const std::string& unit) {
    constexpr double minute = 60.0;
    constexpr double hour = 3600.0;
    if (unit == "s" && time >= 2.0 * hour) return fmt::format("t = {:.4g} h", time / hour);
    const double minutes = time / minute;
    if (unit == "s" && minutes >= 10.0 && minutes == std::floor(minutes))
        return fmt::format("t = {:g} min", minutes);
    return "t = " + length_of_time(time, unit);
}

}  // namespace

std::string length_of_time(double time, const std::string& unit) {
    constexpr double microsecond = 1e-6;
    constexpr double millisecond = 1e-3;
    if (unit == "s" && time > 0.0 && time < millisecond)
        return fmt::format("{:.4g} µs", time / microsecond);
    if (unit == "s" && time > 0.0 && time < 1.0)
        return fmt::format("{:.4g} ms", time / millisecond);
    return fmt::format("{:.6g} {}", time, unit);
}

std::string step_text(const Snapshot& snapshot) {
    if (snapshot.time_unit == "steps") return fmt::format("step {}", snapshot.step);
    return fmt::format("step {}, {}", snapshot.step,
                       time_with_unit(snapshot.time, snapshot.time_unit));
}

std::string time_text(const Snapshot& snapshot) {
    if (snapshot.time_unit == "steps") return fmt::format("step {}", snapshot.step);
    return time_with_unit(snapshot.time, snapshot.time_unit);
}

}  // namespace fumon
