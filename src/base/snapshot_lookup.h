#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "base/find_named.h"
#include "base/snapshot.h"

namespace fumon {

/// A snapshot's number of this name, where it has one.
inline std::optional<double> number_of(const Snapshot& snapshot, std::string_view name) {
    const SnapshotNumber* number = find_named(snapshot.numbers, name);
    return number == nullptr ? std::nullopt : std::optional(number->value);
}

/// The values of the field of this name, or null.
inline const Grid* field_of(std::span<const SnapshotField> fields, std::string_view name) {
    const SnapshotField* field = find_named(fields, name);
    return field == nullptr ? nullptr : &field->values;
}

/// A direction on the ground, a unit vector.
struct HorizontalDirection {
    double x = 1.0;  ///< eastward
    double y = 0.0;  ///< northward

    [[nodiscard]] bool is_east() const { return x == 1.0 && y == 0.0; }
};

/// Where the winds of a run move the sand on balance: the direction of the resultant of their
/// drifts; +x where the model tells none. Nothing where they cancel: where the resultant is no more
/// than the share `cancelled` of the sum.
inline std::optional<HorizontalDirection> downwind(const Snapshot& snapshot,
                                                   double cancelled = 0.01) {
    constexpr double rounding = 1e-9;
    if (snapshot.winds.empty()) return HorizontalDirection{};
    double x = 0.0;
    double y = 0.0;
    double potential = 0.0;
    for (const SnapshotWind& wind : snapshot.winds) {
        x += wind.drift * wind.x;
        y += wind.drift * wind.y;
        potential += wind.drift;
    }
    const double resultant = std::sqrt(x * x + y * y);
    if (!(resultant > cancelled * potential)) return std::nullopt;
    if (std::abs(y) < rounding * resultant) return HorizontalDirection{x > 0.0 ? 1.0 : -1.0, 0.0};
    if (std::abs(x) < rounding * resultant) return HorizontalDirection{0.0, y > 0.0 ? 1.0 : -1.0};
    return HorizontalDirection{x / resultant, y / resultant};
}

/// The same; where the winds cancel, the way of the first of them.
inline HorizontalDirection prevailing_direction(const Snapshot& snapshot) {
    const auto way = downwind(snapshot);
    if (way) return *way;
    return {snapshot.winds.front().x, snapshot.winds.front().y};
}

}  // namespace fumon
