#include "foreign/run_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/truncation.h"
#include "files/unit_conversion.h"

namespace fumon {

namespace {

/// A unit of times and the shortest span that is told in it.
struct SpanUnit {
    const char* unit;
    double from;  ///< seconds
};

constexpr SpanUnit span_units[]{
    {"yr", 9e7}, {"d", 4.5e5}, {"h", 1.2e4}, {"min", 600.0}, {"s", 0.0}};

const char* unit_of_span(double seconds) {
    for (const SpanUnit& one : span_units)
        if (seconds >= one.from) return one.unit;
    return "s";
}

void check_rising(const std::vector<double>& values, const std::string& name) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]))
            throw InputError(
                fmt::format("{}: record {} has no time; write one for every record", name, i + 1));
        if (i == 0 || values[i] > values[i - 1]) continue;
        throw InputError(fmt::format(
            "{}: the time of record {}, {}, does not come after that of record {}, {}; put "
            "the records into the order of their times",
            name, i + 1, values[i], i, values[i - 1]));
    }
}

std::int64_t whole_seconds(double seconds) {
    return truncated(std::floor(seconds + 0.5));
}

/// The coarsest text that tells all records apart by what they have.
DateText fineness_of(const std::vector<double>& seconds, std::int64_t origin) {
    DateText finest = DateText::days;
    for (const double value : seconds) {
        const std::int64_t at = origin + whole_seconds(value);
        if (at % 60 != 0) return DateText::seconds;
        if (at % 86'400 != 0) finest = DateText::minutes;
    }
    return finest;
}

}  // namespace

ForeignTimes run_times(const RawTimes& raw, const std::string& name) {
    check_rising(raw.values, name);
    ForeignTimes times;
    times.note = raw.note;
    for (std::size_t i = 0; i < raw.values.size(); ++i)
        times.steps.push_back(static_cast<std::int64_t>(i));
    times.times = raw.values;
    if (raw.counted || raw.values.empty()) return times;
    constexpr double longest = 1e15;  // seconds, 30 million years
    const double first = raw.values.front();
    if (std::max(std::abs(first), std::abs(raw.values.back())) > longest)
        throw InputError(
            fmt::format("{}: its times are {} s to {} s, which is not a time of a run; "
                        "look at their unit",
                        name, first, raw.values.back()));
    times.unit = unit_of_span(
        std::max(raw.values.back() - first, raw.origin ? 0.0 : std::abs(raw.values.back())));
    const double per_unit = unit_conversion(times.unit == "yr" ? "year" : times.unit, "s")->factor;
    for (double& time : times.times) {
        time = (raw.origin ? time - first : time) / per_unit;
        const double tidy = std::round(time * 1e6) / 1e6;  // seconds of single precision
        constexpr double least = 0.1;                      // seconds, that move no date
        if (std::abs(tidy - time) <
            std::min(1e-9 * std::max(1.0, std::abs(time)), least / per_unit))
            time = tidy;
    }
    if (!raw.origin) return times;
    const DateText fineness = fineness_of(raw.values, *raw.origin);
    times.date = [=, origin = *raw.origin, calendar = raw.calendar](double time) {
        return date_text(date_of(origin + whole_seconds(first + time * per_unit), calendar),
                         fineness);
    };
    return times;
}

}  // namespace fumon
