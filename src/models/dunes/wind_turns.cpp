#include "models/dunes/wind_turns.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/units.h"

namespace fumon {

namespace {

/// Winds along the grid's axes blow along them exactly.
double without_rounding(double component) {
    constexpr double rounding = 1e-14;
    return std::abs(component) < rounding ? 0.0 : component;
}

}  // namespace

void WindTurns::add(const DuneWind& wind, double step_length) {
    BlowingWind blowing;
    blowing.x = without_rounding(-elementary::sin(wind.from * degree));
    blowing.y = without_rounding(-elementary::cos(wind.from * degree));
    blowing.strength = wind.strength;
    constexpr double most_steps = 1e15;
    const double steps = std::clamp(wind.duration / step_length, 1.0, most_steps);
    const std::int64_t begin = turns_.empty() ? 0 : turns_.back().end;
    turns_.push_back({blowing, begin + std::llround(steps), step_length});
}

const WindTurns::Turn& WindTurns::turn(std::int64_t step) const {
    const std::int64_t within = step % turns_.back().end;
    return *std::ranges::find_if(turns_, [&](const Turn& turn) { return within < turn.end; });
}

std::array<double, 2> WindTurns::drift() const {
    double east = 0.0;
    double north = 0.0;
    double all = 0.0;
    std::int64_t begin = 0;
    for (const Turn& turn : turns_) {
        const double moved =
            turn.wind.strength * turn.step_length * static_cast<double>(turn.end - begin);
        east += moved * turn.wind.x;
        north += moved * turn.wind.y;
        all += moved;
        begin = turn.end;
    }
    const double length = std::sqrt(east * east + north * north);
    if (length <= 1e-3 * all) return {turns_.front().wind.x, turns_.front().wind.y};
    return {east / length, north / length};
}

double WindTurns::time(std::int64_t steps) const {
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
