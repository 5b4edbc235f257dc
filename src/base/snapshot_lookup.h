#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

#include "base/snapshot.h"

namespace fumon {

/// A snapshot's number of this name, where it has one.
inline std::optional<double> number_of(const Snapshot& snapshot, std::string_view name) {
    const auto found =
        std::find_if(snapshot.numbers.begin(), snapshot.numbers.end(),
                     [&](const SnapshotNumber& number) { return number.name == name; });
    if (found == snapshot.numbers.end()) return std::nullopt;
    return found->value;
}

/// The values of the field of this name, or null.
inline const Grid* field_of(std::span<const SnapshotField> fields, std::string_view name) {
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const SnapshotField& field) { return field.name == name; });
    return found == fields.end() ? nullptr : &found->values;
}

}  // namespace fumon
