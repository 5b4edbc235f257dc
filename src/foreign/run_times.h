#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foreign/calendar.h"
#include "foreign/foreign_run.h"

namespace fumon {

/// Times as a file has them.
struct RawTimes {
    std::vector<double> values;  ///< in seconds, or counted
    bool counted = false;        ///< records or numbers without a unit of time
    /// The moment of 0, seconds from 1970-01-01 in `calendar`; none where the file names no date.
    std::optional<std::int64_t> origin{};
    CalendarKind calendar = CalendarKind::gregorian;
    std::string note{};
};

/// Times of a run's records in a unit that suits their span, from those of its files. Times of a
/// date begin at 0 with the first record. Throws InputError naming the first record whose time is
/// missing or does not come after that of the record before it.
ForeignTimes run_times(const RawTimes& raw, const std::string& name);

}  // namespace fumon
