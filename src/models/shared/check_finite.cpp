#include "models/shared/check_finite.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "base/limits.h"
#include "base/snapshots/ground_range.h"
#include "models/shared/unstable.h"

namespace fumon {

namespace {

std::string moment(const Snapshot& snapshot) {
    if (snapshot.time_unit == "steps") return fmt::format("step {}", snapshot.step);
    return fmt::format("step {} ({:.6g} {})", snapshot.step, snapshot.time, snapshot.time_unit);
}

void check(const Snapshot& snapshot, const Grid& field, std::string_view name,
           std::string_view place, double most, double factor) {
    const std::size_t cell = first_beyond(field, most);
    if (cell == field.size()) return;
    const auto nx = static_cast<std::size_t>(field.nx());
    const double value = factor * field.values()[cell];
    throw Unstable(fmt::format("{} became {} at {} ({}, {}), {}", name,
                               std::isnan(value) ? "nan" : fmt::format("{}", value), place,
                               cell % nx, cell / nx, moment(snapshot)),
                   "smaller rates (`fumon describe` lists the ranges)");
}

}  // namespace

void check_finite(const Snapshot& snapshot) {
    const double unit = snapshot.scale.height_unit;
    check(snapshot, snapshot.bed, "the bed height", "cell", largest_height / unit, unit);
    for (const SnapshotField& field : snapshot.fields)
        check(snapshot, field.values, field.name, "cell", largest_field_value, 1.0);
    if (!snapshot.section) return;
    for (const SnapshotField& field : snapshot.section->fields)
        check(snapshot, field.values, field.name, "node", largest_field_value, 1.0);
}

}  // namespace fumon
