#pragma once

#include <span>

#include "keys/key_role.h"
#include "scene/scene.h"

namespace fumon {

/// The scene with only the keys of some roles: others are at their defaults, and lists of tables
/// empty.
Scene only_roles(Scene scene, std::span<const KeyRole> kept);

/// The scene with nothing of what it asks to be written: what is true among its records and files
/// becomes false, every n steps 0, a list of steps empty.
Scene without_files(Scene scene);

}  // namespace fumon
