#pragma once

#include "scene/faults.h"
#include "scene/scene.h"

namespace fumon {

/// Checks the rules that involve several keys of a figure (what a panel of its kind must and cannot
/// have, rising ranges, logarithmic axes above 0) and adds what breaks them to `faults`, located at
/// the key to change. A scene without panels breaks none.
void check_figure(const Scene& scene, Faults& faults);

}  // namespace fumon
