#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "keys/key_role.h"
#include "scene/scene.h"

namespace fumon {

/// The resolved scene as nested JSON: every key with its value, defaults included.
nlohmann::ordered_json scene_json(const Scene& scene);

/// The same of the keys of some roles alone.
nlohmann::ordered_json scene_json(const Scene& scene, std::span<const KeyRole> roles);

/// JSON as text, UTF-8; file names need not be that: what is not is replaced. Indented where
/// `indent` is not below 0.
std::string json_text(const nlohmann::ordered_json& json, int indent = -1);

/// The first key at which two such scenes differ, in words ("its scene has run.steps = 100, now
/// 200"); empty where they agree. bed.file is passed over: what a file holds counts, not its path.
std::string scene_difference(const nlohmann::ordered_json& previous,
                             const nlohmann::ordered_json& now);

}  // namespace fumon
