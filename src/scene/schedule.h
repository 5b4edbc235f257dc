#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace fumon {

/// At which steps of a run something is due: every n steps from 0 on, or at listed steps.
class Schedule {
  public:
    Schedule() = default;
    Schedule(std::int64_t every, std::vector<std::int64_t> at, std::int64_t last_step);

    [[nodiscard]] bool due(std::int64_t step) const;
    /// How many steps of 0 … last_step are due.
    [[nodiscard]] std::int64_t count() const;

  private:
    std::int64_t every_ = 0;
    std::vector<std::int64_t> at_;  ///< sorted, distinct, within the run
    std::int64_t last_step_ = 0;
};

/// When frames are taken. Without any frames key: every hundredth of the run (at least every step).
/// Logarithmic: step 0 and `logarithmic` steps spaced evenly in their logarithm from 1 to the run's
/// end, rounded; those that round to the same step count once.
Schedule frame_schedule(const Scene& scene);

/// When the bed is written as a file.
Schedule bed_schedule(const Scene& scene);

/// When all fields are recorded in fields.nc.
Schedule fields_schedule(const Scene& scene);

/// When the bed is measured: with every frame, or by output.measure_every.
Schedule measurement_schedule(const Scene& scene);

}  // namespace fumon
