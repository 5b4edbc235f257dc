#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/snapshot.h"
#include "models/dunes/setup/dunes_parameters.h"

namespace fumon {

/// The wind of one step: where it blows to, a unit vector, and its drift in parts of model.flux.
struct BlowingWind {
    double x = 1.0;
    double y = 0.0;
    double strength = 1.0;
    double threshold = 0.0;  ///< (u*t / u*)², 0 where there is none
};

/// Winds that blow in turn, each for as many whole steps as come nearest to its duration, at least
/// one. A gusty wind is another one in each gust: its direction and strength are drawn about the
/// wind's by normal laws (strengths below 0 are calm), from the seed and the gust's first step, so
/// that the wind of a step is the same wherever a run goes on from.
class WindSchedule {
  public:
    /// `step_length(strength)`: how long a step under a wind of that strength takes, years.
    template <class StepLength>
    WindSchedule(std::vector<DuneWind> winds, const StepLength& step_length, std::uint64_t seed = 1)
        : seed_(seed) {
        if (winds.empty()) winds.emplace_back();
        for (const DuneWind& wind : winds) add(wind, step_length(wind.strength));
    }

    [[nodiscard]] BlowingWind at(std::int64_t step) const;
    /// What each wind moves over flat ground, on the mean over all turns, where `flux` is the drift
    /// of a wind of strength 1, m²/yr.
    [[nodiscard]] std::vector<SnapshotWind> drifts(double flux) const;

    /// Years of the first `steps` steps.
    [[nodiscard]] double time(std::int64_t steps) const;

  private:
    struct Turn {
        BlowingWind wind;
        std::int64_t end;    ///< step of the cycle at which it ends
        double step_length;  ///< years
        DuneWind asked;
        std::int64_t gust_steps;  ///< 0 for a wind without gusts
    };

    void add(const DuneWind& wind, double step_length);
    [[nodiscard]] const Turn& turn(std::int64_t step) const;

    std::vector<Turn> turns_;
    std::uint64_t seed_;
};

}  // namespace fumon
