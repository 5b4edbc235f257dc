#include "figure/panels/step_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "base/find_named.h"
#include "figure/words/words.h"

namespace fumon {

namespace {

std::string time_with_unit(double time, const std::string& unit) {
    constexpr double minute = 60.0;
    constexpr double hour = 3600.0;
    if (unit == "s" && time >= 2.0 * hour)
        return phrase("t = {}", fmt::format("{:.4g} {}", time / hour, unit_word("h")));
    const double minutes = time / minute;
    if (unit == "s" && minutes >= 10.0 && minutes == std::floor(minutes))
        return phrase("t = {}", fmt::format("{:g} {}", minutes, unit_word("min")));
    return phrase("t = {}", length_of_time(time, unit));
}

struct TimeUnit {
    std::string_view name;
    double seconds;
};

constexpr double seconds_per_day = 86400.0;
constexpr std::array<TimeUnit, 8> time_units{{{"µs", 1e-6},
                                              {"us", 1e-6},
                                              {"ms", 1e-3},
                                              {"s", 1.0},
                                              {"min", 60.0},
                                              {"h", 3600.0},
                                              {"d", seconds_per_day},
                                              {"yr", 365.25 * seconds_per_day}}};

}  // namespace

std::optional<double> time_factor(const std::string& unit, const std::string& wanted) {
    const TimeUnit* from = find_by(time_units, &TimeUnit::name, unit);
    const TimeUnit* to = find_by(time_units, &TimeUnit::name, wanted);
    if (from == nullptr || to == nullptr) return std::nullopt;
    return from->seconds / to->seconds;
}

std::optional<std::string> time_in(double time, const std::string& unit,
                                   const std::string& wanted) {
    const std::optional<double> factor = time_factor(unit, wanted);
    if (!factor) return std::nullopt;
    return fmt::format("{:.6g} {}", time * *factor, unit_word(wanted));
}

std::string natural_time(double time, const std::string& unit) {
    const TimeUnit* given = find_by(time_units, &TimeUnit::name, unit);
    if (given == nullptr || time == 0.0) return length_of_time(time, unit);
    const double seconds = std::abs(time) * given->seconds;
    const auto in = [&](const char* wanted) { return *time_in(time, unit, wanted); };
    const auto whole = [&](double of) { return seconds / of == std::floor(seconds / of); };
    constexpr double tenth_of_year = 36.525 * seconds_per_day;
    if (seconds < 1.0) return length_of_time(time * given->seconds, "s");
    if (seconds >= tenth_of_year) return in("yr");
    if (seconds >= 2.0 * seconds_per_day || (seconds >= seconds_per_day && whole(seconds_per_day)))
        return in("d");
    if (seconds >= 2.0 * 3600.0 || (seconds >= 3600.0 && whole(1800.0))) return in("h");
    return seconds >= 600.0 || (seconds >= 60.0 && whole(60.0)) ? in("min") : in("s");
}

std::string length_of_time(double time, const std::string& unit) {
    constexpr double microsecond = 1e-6;
    constexpr double millisecond = 1e-3;
    if (unit == "s" && time > 0.0 && time < millisecond)
        return fmt::format("{:.4g} {}", time / microsecond, unit_word("µs"));
    if (unit == "s" && time > 0.0 && time < 1.0)
        return fmt::format("{:.4g} {}", time / millisecond, unit_word("ms"));
    return fmt::format("{:.6g} {}", time, unit_word(unit));
}

std::string step_text(const Snapshot& snapshot) {
    if (snapshot.time_unit == "steps") return phrase("step {}", snapshot.step);
    return phrase("step {}, {}", snapshot.step, time_with_unit(snapshot.time, snapshot.time_unit));
}

std::string time_text(const Snapshot& snapshot) {
    if (snapshot.time_unit == "steps") return phrase("step {}", snapshot.step);
    return time_with_unit(snapshot.time, snapshot.time_unit);
}

}  // namespace fumon
