#pragma once

#include <optional>
#include <string>

#include "base/snapshot.h"

namespace fumon {

/// "12.5 s", "50 µs", "2.5 ms": seconds in µs and ms below a millisecond and a second.
std::string length_of_time(double time, const std::string& unit);

/// A time in the unit that suits it: "2.5 ms", "90 s", "20 min", "1.5 h", "3 d", "0.25 yr".
std::string natural_time(double time, const std::string& unit);

/// How many of a wanted unit of time one of a given unit is: 1/3600 of "s" in "h"; nothing where
/// either is none of the known units, see time_in().
std::optional<double> time_factor(const std::string& unit, const std::string& wanted);

/// A time in a unit of one's own, of the units of time that are known: µs, ms, s, min, h, d, yr (of
/// 365.25 d); nothing where either is none of them.
std::optional<std::string> time_in(double time, const std::string& unit, const std::string& wanted);

/// "step 1200", and with its time where the model has one: "step 40, t = 8 s".
std::string step_text(const Snapshot& snapshot);

/// The time alone: "t = 12.5 s", in µs and ms below a millisecond and a second, "t = 20 min" for
/// whole minutes from ten on, "t = 2.5 h" from two hours on; "step 1200" where the model counts
/// steps only.
std::string time_text(const Snapshot& snapshot);

}  // namespace fumon
