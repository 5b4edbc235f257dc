#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/number_text.h"
#include "foreign/open_run.h"

namespace fumon {

namespace {

constexpr std::size_t most_read_records = 25;

struct ValueRange {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    std::size_t missing = 0;  ///< cells without a value, of the last record
};

/// The values of some records, evenly chosen, among them the first and the last.
ValueRange range_of(const ForeignField& field, std::size_t records) {
    ValueRange range;
    const std::size_t read = field.changes ? std::min(records, most_read_records) : 1;
    for (std::size_t k = 0; k < read; ++k) {
        const Grid values = field.read(read < 2 ? 0 : k * (records - 1) / (read - 1));
        range.missing = 0;
        for (const double value : values.values()) {
            if (!std::isfinite(value)) {
                ++range.missing;
                continue;
            }
            range.low = std::min(range.low, value);
            range.high = std::max(range.high, value);
        }
    }
    return range;
}

std::string moment(const ForeignTimes& times, std::size_t record) {
    if (times.date) return times.date(times.times[record]);
    return times.unit == "steps" ? fmt::format("{:g}", times.times[record])
                                 : fmt::format("{:g} {}", times.times[record], times.unit);
}

std::string times_text(const ForeignTimes& times) {
    const std::size_t count = times.times.size();
    if (count == 1) return fmt::format("1 record, {}", moment(times, 0));
    std::string text =
        fmt::format("{} records, {} to {}", with_commas(static_cast<std::int64_t>(count)),
                    moment(times, 0), moment(times, count - 1));
    if (times.date) text += fmt::format(" ({:g} {})", times.times.back(), times.unit);
    return text + fmt::format("; --step {} to {}", times.steps.front(), times.steps.back());
}

std::string field_line(const ForeignField& field, std::size_t records) {
    const QuantityFacts& facts = facts_of(field.quantity);
    const ValueRange range = range_of(field, records);
    std::string text = fmt::format("{:<10} {}", facts.key, field.name);
    if (!field.dimensions.empty()) text += fmt::format(" ({})", field.dimensions);
    text += fmt::format(": {}, by {}", facts.name, field.reason);
    if (!field.unit.empty()) text += fmt::format("; in \"{}\"", field.unit);
    if (range.low <= range.high)
        text += fmt::format("; {:.6g} to {:.6g} {}", range.low, range.high, facts.unit);
    if (range.missing > 0)
        text += fmt::format(", {} cells without a value",
                            with_commas(static_cast<std::int64_t>(range.missing)));
    return text + (field.changes ? "; changes\n" : "; constant\n");
}

}  // namespace

std::string foreign_description(const ForeignRun& run) {
    std::string text = run.name;
    if (run.files.size() > 1) text += fmt::format(", {} files", run.files.size());
    text += run.model.empty() ? "\n" : fmt::format(", of {}\n", run.model);
    text += fmt::format("{:<10} {} x {} cells", "grid", run.nx, run.ny);
    if (run.scale.in_metres)
        text += fmt::format(" of {:.6g} x {:.6g} m", run.scale.dx, run.scale.dy);
    if (run.scale.place)
        text += fmt::format(", from {:.10g}, {:.10g} {}", run.scale.place->west,
                            run.scale.place->south, run.scale.place->degrees ? "degrees" : "");
    while (text.ends_with(' ')) text.pop_back();
    text += fmt::format("\n{:<10} {}\n", "time", times_text(run.times));
    for (const QuantityFacts& facts : quantities())
        if (const ForeignField* field = run.find(facts.quantity))
            text += field_line(*field, run.times.times.size());
    if (run.has_water())
        text += fmt::format("{:<10} water shallower than {:g} m\n", "dry", run.dry);
    std::string others;
    for (const std::string& other : run.others) others += (others.empty() ? "" : ", ") + other;
    if (!others.empty())
        text += fmt::format("{:<10} {}; --colour NAME shows one, --field QUANTITY=NAME takes one\n",
                            "not taken", others);
    for (const std::string& note : run.notes) text += fmt::format("{:<10} {}\n", "note", note);
    return text;
}

}  // namespace fumon
