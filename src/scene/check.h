#pragma once

#include "scene/scene.h"

namespace fumon {

/// Checks the rules that involve several keys (exactly one way to choose frames, low < high, a file
/// for a file bed …). Throws InputError located at the key to change.
void check_scene(const Scene& scene);

}  // namespace fumon
