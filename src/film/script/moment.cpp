#include "film/script/moment.h"

#include <charconv>
#include <cmath>
#include <system_error>

#include "base/limits.h"
#include "files/unit_conversion.h"

namespace fumon {

std::optional<WrittenMoment> written_moment(std::string_view text) {
    constexpr double whole_share = 100.0;  // per cent
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, number);
    if (fault != std::errc{} || !std::isfinite(number) || number < 0.0 || number > largest_time)
        return std::nullopt;
    std::string_view unit(stop, static_cast<std::size_t>(end - stop));
    while (unit.starts_with(' ')) unit.remove_prefix(1);
    if (unit == "%")
        return number <= whole_share ? std::optional(WrittenMoment{number, "%"}) : std::nullopt;
    if (unit.empty() || !unit_conversion(unit, "s")) return std::nullopt;
    return WrittenMoment{number, std::string(unit)};
}

bool is_written_share(std::string_view text) {
    const auto moment = written_moment(text);
    return moment && moment->unit == "%";
}

bool is_written_time(std::string_view text) {
    const auto moment = written_moment(text);
    return moment && moment->unit != "%";
}

}  // namespace fumon
