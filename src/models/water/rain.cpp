#include "models/water/rain.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "models/water/shallow_water.h"
#include "numerics/time_table.h"

namespace fumon {

Rain::Rain(const GullyParameters& parameters, std::vector<RainMap> maps)
    : rate_(parameters.rain),
      until_(parameters.rain_until),
      times_(parameters.rain_times),
      rates_(parameters.rain_rates),
      maps_(std::move(maps)) {}

Rain::Step Rain::over(double time, double dt) {
    if (maps_.empty()) return {even_rate(time, dt)};
    return of_maps(time, dt);
}

double Rain::even_rate(double time, double dt) const {
    if (!times_.empty())
        return mean_of_steps(times_, rates_, time, time + dt) * millimetre_per_hour;
    const double until = until_ > 0.0 ? until_ : time + dt;
    const double raining = std::clamp(until - time, 0.0, dt) / dt;
    return raining * rate_ * millimetre_per_hour;
}

Grid Rain::between(double from, double until) const {
    if (maps_.empty()) {
        Grid even(1, 1);
        if (until > from) even(0, 0) = (until - from) * even_rate(from, until - from);
        return even;
    }
    constexpr double never = std::numeric_limits<double>::infinity();
    Grid fallen(maps_.front().rate.nx(), maps_.front().rate.ny());
    for (std::size_t k = 0; k < maps_.size(); ++k) {
        const double next = k + 1 < maps_.size() ? maps_[k + 1].from : never;
        const double end = std::min({until, next, until_ > 0.0 ? until_ : never});
        const double seconds = end - std::max(from, maps_[k].from);
        if (!(seconds > 0.0)) continue;
        for (std::size_t cell = 0; cell < fallen.size(); ++cell)
            fallen.values()[cell] += seconds * maps_[k].rate.values()[cell];
    }
    return fallen;
}

Rain::Step Rain::of_maps(double time, double dt) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const double last = until_ > 0.0 ? until_ : never;
    const double end = time + dt;
    Step step;
    for (std::size_t k = 0; k < maps_.size(); ++k) {
        const RainMap& map = maps_[k];
        const double next = k + 1 < maps_.size() ? maps_[k + 1].from : never;
        const double begin = std::max(time, map.from);
        const double until = std::min({end, next, last});
        if (!(until > begin)) continue;
        if (begin == time && until == end) return {0.0, &map.rate, map.volume * dt};
        const double share = (until - begin) / dt;
        if (step.by_cell == nullptr) mean_ = Grid(map.rate.nx(), map.rate.ny());
        for (std::size_t cell = 0; cell < mean_.size(); ++cell)
            mean_.values()[cell] += share * map.rate.values()[cell];
        step.by_cell = &mean_;
        step.volume += share * map.volume * dt;
    }
    return step;
}

}  // namespace fumon
