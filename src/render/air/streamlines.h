#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/air/section_air.h"

namespace fumon {

/// How a section is drawn, and how far apart its streamlines are.
struct StreamlineSettings {
    double pixels_per_metre_x = 1.0;
    double pixels_per_metre_z = 1.0;
    double separation = 16.0;  ///< of neighbouring lines, pixels
};

/// Points along a streamline in metres (x, z), downstream.
using Streamline = std::vector<glm::dvec2>;

/// Evenly spaced streamlines of a section's "velocity_x" and "velocity_z" (Jobard & Lefer 1997,
/// "Creating evenly-spaced streamlines of arbitrary density"): each begins no nearer to another
/// than the separation and ends where it comes nearer than half of it, closes upon itself, or
/// meets the bed, the section's top or its ends. Air that flows back (to −x) is seeded first, so
/// that an eddy shows. Empty without these two fields. Throws Error where a scale or the
/// separation is not above 0.
std::vector<Streamline> streamlines(const SectionAir& air, const StreamlineSettings& settings);

}  // namespace fumon
