#pragma once

#include <span>

#include "keys/key_role.h"
#include "scene/scene.h"

namespace fumon {

/// The scene with only the keys of some roles: others are at their defaults, and lists of tables
/// empty.
Scene only_roles(Scene scene, std::span<const KeyRole> kept);

}  // namespace fumon
