#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fumon {

/// How many days the months and years of dates have.
enum class CalendarKind { gregorian, years_of_365_days, years_of_360_days };

/// The calendar of CF's attribute `calendar`: that of Gregory for "standard", "gregorian",
/// "proleptic_gregorian" and none, which write dates from 1582-10-15 on alike, and for "julian",
/// which files say of such dates.
std::optional<CalendarKind> calendar_kind(std::string_view name);

/// A date and the time of its day.
struct DateTime {
    std::int64_t year = 1970;
    int month = 1;
    int day = 1;
    std::int64_t second = 0;  ///< of the day, 0 … 86,399
};

/// Seconds from 1970-01-01 in a calendar, negative before it.
std::int64_t seconds_of(const DateTime& date, CalendarKind kind);
DateTime date_of(std::int64_t seconds, CalendarKind kind);

/// Seconds from a date of Gregory's calendar to that of the same name in Julius Caesar's, which
/// "standard" dates follow before 1582-10-15: "hours since 1-1-1" begin two days earlier; 0 from
/// then on.
std::int64_t seconds_to_julian(const DateTime& date);

/// A date as units of time have it after "since": "2019-08-31", "2019-8-31T14:00:00Z",
/// "1970-01-01 00:00:00 +02:00", whose zone is taken off; nothing for what is no date within ±10⁶
/// years.
std::optional<DateTime> parse_date(std::string_view text);

/// How fine a date is written.
enum class DateText { days, minutes, seconds };

/// "2019-08-31", "2019-08-31 14:00 UTC".
std::string date_text(const DateTime& date, DateText fineness);

}  // namespace fumon
