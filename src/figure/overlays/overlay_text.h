#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "figure/overlays/overlay.h"

namespace fumon {

/// How the times of a run are written: whole seconds where its steps are whole, else with as many
/// decimals as they need; where the length of a step is not known, as years of dunes, with two
/// decimals below 1 and one below 10.
struct TimeText {
    static constexpr int by_size = -1;
    std::string unit;       ///< "s"; "steps" where there are only steps
    int decimals = 0;       ///< of a time, or by_size
    std::int64_t last = 0;  ///< the run's last step
    /// The run's end; none where the model alone knows how long its steps take.
    std::optional<double> end{};
    /// As Snapshot::date.
    std::function<std::string(double time)> date{};

    /// "300 s"; "1,200 steps".
    [[nodiscard]] std::string operator()(double time) const;
    /// The same in another unit of time, with at most two decimals: "0.08 h". Throws InputError
    /// without a place for what is none, and where there are only steps.
    [[nodiscard]] std::string in(const std::string& wanted, double time) const;
};

/// The time text of a scene's run; `first` gives the unit.
TimeText time_text_of(const Scene& scene, const Snapshot& first);

/// A text with {title}, {seed}, {step}, {time}, {time:h}, {date} and {key} filled in, for a step.
/// Throws InputError without a place for other names.
std::string filled_text(const std::string& text, const Scene& scene, const TimeText& times,
                        std::int64_t step, double time);

/// "overlay.2.text".
std::string overlay_key(std::size_t number, const std::string& key);

}  // namespace fumon
