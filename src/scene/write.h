#pragma once

#include <string>

#include "keys/keys.h"
#include "scene/scene.h"

namespace fumon {

/// The resolved scene as TOML: every key with its value, defaults included, in the table's order.
/// Read again it gives the same scene.
std::string to_toml(const Scene& scene);

/// One key's value as TOML ("0.1", "[50, 100]", "\"synchronous\"").
std::string value_text(const Key& key);

}  // namespace fumon
