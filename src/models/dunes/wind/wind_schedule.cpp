#include "models/dunes/wind/wind_schedule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/random.h"
#include "base/units.h"

namespace fumon {

namespace {

/// Winds along the grid's axes blow along them exactly.
double without_rounding(double component) {
    constexpr double rounding = 1e-14;
    return std::abs(component) < rounding ? 0.0 : component;
}

/// Two independent numbers of the standard normal law (Box & Muller 1958).
std::array<double, 2> normal_pair(RandomStream& stream) {
    const double radius = std::sqrt(-2.0 * elementary::log(1.0 - stream.uniform()));
    const double angle = 2.0 * std::numbers::pi * stream.uniform();
    return {radius * elementary::cos(angle), radius * elementary::sin(angle)};
}

BlowingWind blowing(double from, double strength, const WordOrReal& ratio) {
    const double threshold = ratio.is_word() ? 0.0 : 1.0 / (ratio.value * ratio.value);
    return {without_rounding(-elementary::sin(from * degree)),
            without_rounding(-elementary::cos(from * degree)), strength, threshold};
}

std::int64_t whole_steps(double duration, double step_length) {
    constexpr double most_steps = 1e15;
    return std::llround(std::clamp(duration / step_length, 1.0, most_steps));
}

}  // namespace

void WindSchedule::add(const DuneWind& wind, double step_length) {
    const std::int64_t begin = turns_.empty() ? 0 : turns_.back().end;
    const bool gusty = wind.gust_angle > 0.0 || wind.gust_strength > 0.0;
    turns_.push_back({blowing(wind.from, wind.strength, wind.threshold_ratio),
                      begin + whole_steps(wind.duration, step_length), step_length, wind,
                      gusty ? whole_steps(wind.gust_duration, step_length) : 0});
}

BlowingWind WindSchedule::at(std::int64_t step) const {
    const Turn& now = turn(step);
    if (now.gust_steps == 0) return now.wind;
    const std::int64_t begin = &now == turns_.data() ? 0 : (&now - 1)->end;
    const std::int64_t into_turn = step % turns_.back().end - begin;
    RandomStream stream(seed_, 0, step - into_turn % now.gust_steps, Purpose::gusts);
    const std::array<double, 2> drawn = normal_pair(stream);
    const double strength = 1.0 + now.asked.gust_strength * drawn[1];
    return blowing(now.asked.from + now.asked.gust_angle * drawn[0],
                   now.asked.strength * std::max(strength, 0.0), now.asked.threshold_ratio);
}

const WindSchedule::Turn& WindSchedule::turn(std::int64_t step) const {
    const std::int64_t within = step % turns_.back().end;
    return *std::ranges::find_if(turns_, [&](const Turn& turn) { return within < turn.end; });
}

std::vector<SnapshotWind> WindSchedule::drifts(double flux) const {
    double whole = 0.0;
    for (const Turn& turn : turns_) whole += turn.asked.duration;
    std::vector<SnapshotWind> drifts;
    for (const Turn& turn : turns_) {
        const double drift = flux * turn.wind.strength * turn.asked.duration / whole;
        drifts.push_back({turn.wind.x, turn.wind.y, drift});
    }
    return drifts;
}

double WindSchedule::time(std::int64_t steps) const {
    const std::int64_t cycles = steps / turns_.back().end;
    const std::int64_t within = steps % turns_.back().end;
    double time = 0.0;
    std::int64_t begin = 0;
    for (const Turn& turn : turns_) {
        const std::int64_t of_cycle = turn.end - begin;
        const std::int64_t begun = std::clamp<std::int64_t>(within - begin, 0, of_cycle);
        time += turn.step_length * static_cast<double>(cycles * of_cycle + begun);
        begin = turn.end;
    }
    return time;
}

}  // namespace fumon
