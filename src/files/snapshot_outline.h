#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/snapshot.h"

namespace fumon {

/// What all snapshots of a run have in common, as JSON: size, units, scale, whether there is a
/// mask, and the names and units of fields, numbers and the section's curves.
nlohmann::ordered_json outline_json(const Snapshot& snapshot);

/// The same as a snapshot without values: a bed of zeros, a mask of zeros where there is one, and
/// fields, numbers and a section that have names and units alone. The landform is left as it is.
/// Throws nlohmann::json::exception where something is not there, InputError for a size that no
/// bed has.
Snapshot read_outline(const nlohmann::ordered_json& json);

}  // namespace fumon
