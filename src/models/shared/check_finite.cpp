#include "models/shared/check_finite.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "base/error.h"

namespace fumon {

namespace {

std::string moment(const Snapshot& snapshot) {
    if (snapshot.time_unit == "steps") return fmt::format("step {}", snapshot.step);
    return fmt::format("step {} ({:.6g} {})", snapshot.step, snapshot.time, snapshot.time_unit);
}

void check(const Snapshot& snapshot, const Grid& field, std::string_view name,
           std::string_view place) {
    for (int y = 0; y < field.ny(); ++y) {
        const auto row = field.row(y);
        for (int x = 0; x < field.nx(); ++x) {
            const double value = row[static_cast<std::size_t>(x)];
            if (std::isfinite(value)) continue;
            throw Error(
                fmt::format("{} became {} at {} ({}, {}), {}; try smaller rates (`fumon "
                            "describe` lists the ranges)",
                            name, std::isnan(value) ? "nan" : fmt::format("{}", value), place, x, y,
                            moment(snapshot)));
        }
    }
}

}  // namespace

void check_finite(const Snapshot& snapshot) {
    check(snapshot, snapshot.bed, "the bed height", "cell");
    for (const SnapshotField& field : snapshot.fields)
        check(snapshot, field.values, field.name, "cell");
    if (!snapshot.section) return;
    for (const SnapshotField& field : snapshot.section->fields)
        check(snapshot, field.values, field.name, "node");
}

}  // namespace fumon
