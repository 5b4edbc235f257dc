#pragma once

#include <string>

#include "base/snapshot.h"

namespace fumon {

/// "12.5 s", "50 µs", "2.5 ms": seconds in µs and ms below a millisecond and a second.
std::string length_of_time(double time, const std::string& unit);

/// "step 1200", and with its time where the model has one: "step 40, t = 8 s".
std::string step_text(const Snapshot& snapshot);

/// The time alone: "t = 12.5 s", in µs and ms below a millisecond and a second, "t = 20 min" for
/// whole minutes from ten on, "t = 2.5 h" from two hours on; "step 1200" where the model counts
/// steps only.
std::string time_text(const Snapshot& snapshot);

}  // namespace fumon
