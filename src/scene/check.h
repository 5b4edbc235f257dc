#pragma once

#include <set>
#include <string>

#include "scene/faults.h"
#include "scene/scene.h"

namespace fumon {

/// Checks the rules that involve several keys (exactly one way to choose frames, low < high, a file
/// for a file bed …) and adds what breaks them to `faults`, located at the key to change. Rules on
/// a section among `faulty` ("bed") are passed over: what they would say may follow from its
/// faults.
void check_scene(const Scene& scene, const std::set<std::string>& faulty, Faults& faults);

}  // namespace fumon
