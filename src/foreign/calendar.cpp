#include "foreign/calendar.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstddef>

namespace fumon {

namespace {

constexpr std::int64_t seconds_per_day = 86'400;
constexpr std::array<int, 12> days_before_month{0,   31,  59,  90,  120, 151,
                                                181, 212, 243, 273, 304, 334};

std::int64_t floor_of(std::int64_t number, std::int64_t divisor) {
    return number / divisor - (number % divisor < 0 ? 1 : 0);
}

/// Of Gregory's calendar, with years that begin in March (Hinnant 2013, "chrono-compatible
/// low-level date algorithms").
std::int64_t gregorian_days(std::int64_t year, int month, int day) {
    const std::int64_t y = month <= 2 ? year - 1 : year;
    const std::int64_t era = floor_of(y, 400);
    const std::int64_t of_era = y - era * 400;
    const std::int64_t of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
    return era * 146'097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719'468;
}

DateTime gregorian_date(std::int64_t days) {
    const std::int64_t shifted = days + 719'468;
    const std::int64_t era = floor_of(shifted, 146'097);
    const std::int64_t of_era = shifted - era * 146'097;
    const std::int64_t year_of_era =
        (of_era - of_era / 1'460 + of_era / 36'524 - of_era / 146'096) / 365;
    const std::int64_t of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    const std::int64_t from_march = (5 * of_year + 2) / 153;
    DateTime date;
    date.day = static_cast<int>(of_year - (153 * from_march + 2) / 5 + 1);
    date.month = static_cast<int>(from_march < 10 ? from_march + 3 : from_march - 9);
    date.year = year_of_era + era * 400 + (date.month <= 2 ? 1 : 0);
    return date;
}

std::int64_t days_of(const DateTime& date, CalendarKind kind) {
    if (kind == CalendarKind::gregorian) return gregorian_days(date.year, date.month, date.day);
    const auto month = static_cast<std::size_t>(date.month - 1);
    if (kind == CalendarKind::years_of_365_days)
        return (date.year - 1970) * 365 + days_before_month[month] + date.day - 1;
    return (date.year - 1970) * 360 + static_cast<std::int64_t>(month) * 30 + date.day - 1;
}

DateTime date_of_days(std::int64_t days, CalendarKind kind) {
    if (kind == CalendarKind::gregorian) return gregorian_date(days);
    DateTime date;
    const std::int64_t length = kind == CalendarKind::years_of_365_days ? 365 : 360;
    date.year = 1970 + floor_of(days, length);
    const auto of_year = static_cast<int>(days - (date.year - 1970) * length);
    if (kind == CalendarKind::years_of_360_days) {
        date.month = of_year / 30 + 1;
        date.day = of_year % 30 + 1;
        return date;
    }
    std::size_t month = days_before_month.size() - 1;
    while (days_before_month[month] > of_year) --month;
    date.month = static_cast<int>(month) + 1;
    date.day = of_year - days_before_month[month] + 1;
    return date;
}

/// Takes a whole number off a text's front; nothing where there is none.
std::optional<std::int64_t> take_number(std::string_view& text) {
    std::int64_t number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

bool take(std::string_view& text, char letter) {
    if (!text.starts_with(letter)) return false;
    text.remove_prefix(1);
    return true;
}

/// Seconds of "14:00", "14:00:30.5" at a text's front; nothing where there is no such time.
std::optional<std::int64_t> take_clock(std::string_view& text) {
    std::int64_t seconds = 0;
    std::int64_t unit = 3'600;
    do {
        const auto part = take_number(text);
        if (!part || *part < 0 || *part > 60) return std::nullopt;
        seconds += *part * unit;
        unit /= 60;
    } while (unit > 0 && take(text, ':'));
    if (take(text, '.')) take_number(text);  // parts of a second are not written
    return seconds;
}

}  // namespace

std::optional<CalendarKind> calendar_kind(std::string_view name) {
    if (name.empty() || name == "standard" || name == "gregorian" ||
        name == "proleptic_gregorian" || name == "julian")
        return CalendarKind::gregorian;
    if (name == "noleap" || name == "365_day") return CalendarKind::years_of_365_days;
    if (name == "360_day") return CalendarKind::years_of_360_days;
    return std::nullopt;
}

std::int64_t seconds_of(const DateTime& date, CalendarKind kind) {
    return days_of(date, kind) * seconds_per_day + date.second;
}

DateTime date_of(std::int64_t seconds, CalendarKind kind) {
    const std::int64_t days = floor_of(seconds, seconds_per_day);
    DateTime date = date_of_days(days, kind);
    date.second = seconds - days * seconds_per_day;
    return date;
}

std::int64_t seconds_to_julian(const DateTime& date) {
    constexpr std::int64_t first_gregorian = 1582 * 10'000 + 1'015;
    if (date.year * 10'000 + date.month * 100 + date.day >= first_gregorian) return 0;
    const std::int64_t year = date.month <= 2 ? date.year - 1 : date.year;
    return (floor_of(year, 100) - floor_of(year, 400) - 2) * seconds_per_day;
}

std::optional<DateTime> parse_date(std::string_view text) {
    while (take(text, ' ')) {
    }
    DateTime date;
    const auto year = take_number(text);
    constexpr std::int64_t farthest = 1'000'000;
    if (!year || *year < -farthest || *year > farthest || !take(text, '-')) return std::nullopt;
    const auto month = take_number(text);
    if (!month || *month < 1 || *month > 12 || !take(text, '-')) return std::nullopt;
    const auto day = take_number(text);
    if (!day || *day < 1 || *day > 31) return std::nullopt;
    date.year = *year;
    date.month = static_cast<int>(*month);
    date.day = static_cast<int>(*day);
    take(text, 'T');
    while (take(text, ' ')) {
    }
    if (text.empty()) return date;
    const auto clock = take_clock(text);
    if (!clock) return std::nullopt;
    date.second = *clock;
    while (take(text, ' ')) {
    }
    const bool west = text.starts_with('-');
    if (west || text.starts_with('+')) {
        text.remove_prefix(1);
        std::int64_t zone = 0;
        if (text.size() >= 4 && text.find(':') == std::string_view::npos) {  // "+0200"
            const auto both = take_number(text);
            zone = both && *both < 2'400 ? *both / 100 * 3'600 + *both % 100 * 60 : 0;
        } else {
            zone = take_clock(text).value_or(0);
        }
        date = date_of(seconds_of(date, CalendarKind::gregorian) + (west ? zone : -zone),
                       CalendarKind::gregorian);
    }
    return date;
}

std::string date_text(const DateTime& date, DateText fineness) {
    std::string text = fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
    if (fineness == DateText::days) return text;
    text += fmt::format(" {:02}:{:02}", date.second / 3'600, date.second / 60 % 60);
    if (fineness == DateText::seconds) text += fmt::format(":{:02}", date.second % 60);
    return text + " UTC";
}

}  // namespace fumon
