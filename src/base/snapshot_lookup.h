#pragma once

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

}  // namespace fumon
