#pragma once

#include <string>

#include "scene/scene.h"

namespace fumon {

/// The resolved scene as TOML: every key with its value, defaults included, in the table's order.
/// Read again it gives the same scene.
std::string to_toml(const Scene& scene);

}  // namespace fumon
