#pragma once

#include <string_view>

namespace fumon {

/// A date and time of day with its offset from UTC, after ISO 8601, as days from 2000-01-01 12:00
/// UTC (J2000): "2026-03-20T06:40+00:00", "2026-03-20T06:40:30.5Z", "2026-03-20T06:40+09". Throws
/// InputError, which says what is wrong, for any other text, a day that its month lacks, and years
/// before 1901 or after 2099.
double days_from_2000(std::string_view text);

}  // namespace fumon
