#pragma once

#include <string>

#include "keys/keys.h"
#include "scene/scene.h"

namespace fumon {

/// The resolved scene as TOML: every key with its value, defaults included, in the table's order.
/// Read again it gives the same scene.
std::string to_toml(const Scene& scene);

/// The keys of a table with their values. A section opens once, where its first key stands,
/// whatever its other keys stand between: TOML refuses one that opens again behind a list of
/// tables.
std::string to_toml(const KeyTable& table, std::string_view left_out = {});

}  // namespace fumon
