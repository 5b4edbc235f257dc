#pragma once

#include <glm/glm.hpp>

#include "base/snapshot.h"
#include "film/camera/stage.h"

namespace fumon {

/// The share of a picture that a bed must fill at least where a shot's distance is "fill".
inline constexpr double filled_share = 0.68;

/// A unit vector from what is looked at to a camera that stands there, degrees.
glm::dvec3 towards(double azimuth, double elevation);

/// From what a camera looks at, block lengths: as near as the whole block stays in the picture.
double fit_distance(const FilmStage& stage, const glm::dvec3& subject, double azimuth,
                    double elevation, double focal_length);

/// The share of a picture in which the ground of a bed is seen, taken as level, cells without data
/// left out: of a grid of lines of sight.
double ground_share(const FilmStage& stage, const Snapshot& bed, const CameraPose& pose);

/// As far as the bed, looked at as by `pose`, fills filled_share of the picture, and no farther
/// than it fits. `bed`: whose cells without data count.
double fill_distance(const FilmStage& stage, const Snapshot& bed, CameraPose pose, double azimuth,
                     double elevation);

/// As far as a landform of this breadth, block lengths, fills about half of the picture's shorter
/// side.
double near_distance(double breadth, double focal_length);

}  // namespace fumon
