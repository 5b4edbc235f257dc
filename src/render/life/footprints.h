#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace fumon {

inline constexpr double step_length = 0.75;      // metres, from a footprint to the next
inline constexpr double half_step_width = 0.09;  // of footprints from the line that is walked
inline constexpr double longest_tracks = 2e4;    // metres, of all

/// A footprint in the sand.
struct Footprint {
    glm::dvec2 at{0.0};            ///< its middle: metres, as the track's points
    glm::dvec2 heading{0.0, 1.0};  ///< where the toes point, a unit vector
    bool right = false;            ///< of the right foot
    double depth = 0.0;            ///< metres
    double unevenness = 0.0;       ///< 0 … 1, by which its outline differs from others'
};

/// The length of a track's line, metres; 0 of fewer than two points.
double track_length(const TrackSettings& track);

/// The footprints along a track's line, first to last: left and right of it in turn, step_length
/// apart along it, each a few centimetres and degrees off. The same for the same track and
/// `number`, its place in the scene.
std::vector<Footprint> footprints(const TrackSettings& track, std::uint32_t number);

}  // namespace fumon
