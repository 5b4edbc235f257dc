#include "scene/sun/utc_time.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "base/error.h"

namespace fumon {

namespace {

/// Takes a text from its front.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    [[nodiscard]] bool done() const { return rest_.empty(); }

    [[nodiscard]] bool take(char letter) {
        if (rest_.empty() || rest_.front() != letter) return false;
        rest_.remove_prefix(1);
        return true;
    }

    /// A number of so many digits.
    [[nodiscard]] std::optional<int> take_number(std::size_t digits) {
        if (rest_.size() < digits) return std::nullopt;
        int number = 0;
        for (const char letter : rest_.substr(0, digits)) {
            if (letter < '0' || letter > '9') return std::nullopt;
            number = 10 * number + (letter - '0');
        }
        rest_.remove_prefix(digits);
        return number;
    }

    /// The digits after a decimal point; at least one.
    [[nodiscard]] std::optional<double> take_fraction() {
        double value = 0.0;
        double unit = 1.0;
        bool any = false;
        while (const std::optional<int> digit = take_number(1)) {
            unit /= 10.0;
            value += unit * *digit;
            any = true;
        }
        return any ? std::optional(value) : std::nullopt;
    }

  private:
    std::string_view rest_;
};

[[noreturn]] void refuse(std::string_view text) {
    throw InputError(
        fmt::format("\"{}\" is not a time with its offset from UTC; write one as "
                    "\"2026-03-20T06:40+00:00\" or \"2026-03-20T06:40Z\"",
                    text));
}

/// "Z", "+05", "+05:30", "+0530": minutes east.
std::optional<int> take_offset(Scanner& scanner) {
    if (scanner.take('Z') || scanner.take('z')) return 0;
    const bool west = scanner.take('-');
    if (!west && !scanner.take('+')) return std::nullopt;
    const std::optional<int> hours = scanner.take_number(2);
    if (!hours) return std::nullopt;
    int minutes = 0;
    if (!scanner.done()) {
        (void)scanner.take(':');
        const std::optional<int> read = scanner.take_number(2);
        if (!read) return std::nullopt;
        minutes = *read;
    }
    constexpr int most_hours = 14;  // Kiribati's
    if (*hours > most_hours || minutes > 59) return std::nullopt;
    return (west ? -1 : 1) * (60 * *hours + minutes);
}

}  // namespace

double days_from_2000(std::string_view text) {
    Scanner scanner(text);
    const auto number_before = [&](std::size_t digits, char end) {
        const std::optional<int> number = scanner.take_number(digits);
        if (!number || (end != '\0' && !scanner.take(end))) refuse(text);
        return *number;
    };
    const int year = number_before(4, '-');
    const int month = number_before(2, '-');
    const int day = number_before(2, '\0');
    if (!scanner.take('T') && !scanner.take('t') && !scanner.take(' ')) refuse(text);
    const int hour = number_before(2, ':');
    const int minute = number_before(2, '\0');
    double seconds = 0.0;
    if (scanner.take(':')) {
        seconds = number_before(2, '\0');
        if (scanner.take('.')) {
            const std::optional<double> fraction = scanner.take_fraction();
            if (!fraction) refuse(text);
            seconds += *fraction;
        }
    }
    const std::optional<int> offset = take_offset(scanner);
    if (!offset || !scanner.done()) refuse(text);
    if (year < 1901 || year > 2099)
        throw InputError(fmt::format("the year of \"{}\" is outside 1901 … 2099", text));
    const std::chrono::year_month_day date{std::chrono::year(year),
                                           std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok() || hour > 23 || minute > 59 || seconds >= 60.0) {
        throw InputError(
            fmt::format("\"{}\" does not exist: months have 28 to 31 days, days 24 "
                        "hours from 00:00 on",
                        text));
    }
    const double of_day = (hour - 12) / 24.0 + (minute - *offset) / 1440.0 + seconds / 86400.0;
    const auto days =
        std::chrono::sys_days(date) - std::chrono::sys_days(std::chrono::year(2000) / 1 / 1);
    return static_cast<double>(days.count()) + of_day;
}

}  // namespace fumon
