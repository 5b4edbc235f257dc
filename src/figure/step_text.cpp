#include "figure/step_text.h"

#include <fmt/format.h>

#include <cmath>

namespace fumon {

std::string step_text(const Snapshot& snapshot) {
    if (snapshot.time_unit == "steps") return fmt::format("step {}", snapshot.step);
    return fmt::format("step {}, t = {:.4g} {}", snapshot.step, snapshot.time, snapshot.time_unit);
}

std::string time_text(const Snapshot& snapshot) {
    if (snapshot.time_unit == "steps") return fmt::format("step {}", snapshot.step);
    constexpr double minute = 60.0;
    constexpr double hour = 3600.0;
    if (snapshot.time_unit == "s" && snapshot.time >= 2.0 * hour)
        return fmt::format("t = {:.4g} h", snapshot.time / hour);
    const double minutes = snapshot.time / minute;
    if (snapshot.time_unit == "s" && minutes >= 10.0 && minutes == std::floor(minutes))
        return fmt::format("t = {:g} min", minutes);
    return fmt::format("t = {:.4g} {}", snapshot.time, snapshot.time_unit);
}

}  // namespace fumon
