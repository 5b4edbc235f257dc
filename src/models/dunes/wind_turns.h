#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/dunes/dunes_parameters.h"

namespace fumon {

/// The wind of one step: where it blows to, a unit vector, and its drift in parts of model.flux.
struct BlowingWind {
    double x = 1.0;
    double y = 0.0;
    double strength = 1.0;
};

/// Winds that blow in turn, each for as many whole steps as come nearest to its duration, at least
/// one.
class WindTurns {
  public:
    /// `step_length(strength)`: how long a step under a wind of that strength takes, years.
    template <class StepLength>
    WindTurns(std::vector<DuneWind> winds, const StepLength& step_length) {
        if (winds.empty()) winds.emplace_back();
        for (const DuneWind& wind : winds) add(wind, step_length(wind.strength));
    }

    [[nodiscard]] const BlowingWind& at(std::int64_t step) const { return turn(step).wind; }
    /// Years of the first `steps` steps.
    [[nodiscard]] double time(std::int64_t steps) const;
    /// Where all winds together move the sand to, a unit vector; that of the first wind where they
    /// cancel out.
    [[nodiscard]] std::array<double, 2> drift() const;

  private:
    struct Turn {
        BlowingWind wind;
        std::int64_t end;    ///< step of the cycle at which it ends
        double step_length;  ///< years
    };

    void add(const DuneWind& wind, double step_length);
    [[nodiscard]] const Turn& turn(std::int64_t step) const;

    std::vector<Turn> turns_;
};

}  // namespace fumon
