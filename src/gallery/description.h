#pragma once

#include <string>

#include "scene/scene.h"

namespace fumon {

/// What a picture of a scene shows, for people who do not see it: "3-D view of 64 × 48 cells of the
/// model sand at step 40, seen from the south-west". `step` is empty where it is not known.
std::string described_picture(const Scene& scene, const std::string& step);

/// The same of a film or a figure.
std::string described_film(const Scene& scene);
std::string described_figure(const Scene& scene);

}  // namespace fumon
