#pragma once

#include "scene/scene.h"

namespace fumon {

/// The rules that span keys of a figure: what a panel of its kind must have and cannot have, ranges
/// that rise, logarithmic axes above 0. Throws InputError located at the key to change.
void check_figure(const Scene& scene);

}  // namespace fumon
