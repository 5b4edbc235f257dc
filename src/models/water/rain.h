#pragma once

#include <vector>

#include "base/grid.h"
#include "models/water/gully_parameters.h"

namespace fumon {

/// Rain that falls as a map has it, from a time on until the next map's.
struct RainMap {
    double from = 0.0;    ///< s
    Grid rate;            ///< m/s
    double volume = 0.0;  ///< on all cells, m³/s
};

/// The rain of a run by time: even over all cells (model.rain or model.rain_times), or cell by cell
/// as maps have it.
class Rain {
  public:
    Rain(const GullyParameters& parameters, std::vector<RainMap> maps);

    /// The mean of a sub-step.
    struct Step {
        double even = 0.0;              ///< m/s
        const Grid* by_cell = nullptr;  ///< m/s, instead of the even rain where it is not null
        double volume = 0.0;            ///< of that, m³ in the sub-step
    };

    /// Of the `dt` seconds after a time, s. What it points to stays until the next call.
    Step over(double time, double dt);

    /// What falls between two times, s, in metres: on every cell, or one value for all.
    [[nodiscard]] Grid between(double from, double until) const;

  private:
    [[nodiscard]] double even_rate(double time, double dt) const;
    Step of_maps(double time, double dt);

    double rate_;   // mm/h
    double until_;  // s; 0: never
    std::vector<double> times_;
    std::vector<double> rates_;
    std::vector<RainMap> maps_;
    Grid mean_;  // where a sub-step sees more than one of them
};

}  // namespace fumon
