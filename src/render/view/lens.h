#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "base/snapshot.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// Throws KeyError where the camera's lens does not fit a bed: an f-number needs metres.
void check_lens(const View& view, const Snapshot& first);

/// The radius of a camera's lens, block lengths; 0 of a pinhole.
double lens_radius(const CameraSettings& settings, const Block& block, const Camera& camera);

/// Ground that rays may meet, block lengths.
struct RayGround {
    std::function<double(const glm::dvec2&)> height;  ///< z at a point from the bed's middle
    double highest = 0.0;
    double step = 1e-3;     ///< of a ray at first
    double growth = 1e-3;   ///< of its steps, per length
    double farthest = 1e3;  ///< where rays end
};

/// The depth at which the ray through a point of the picture (−1 … 1 rightward and upward) meets
/// ground, seen through a pinhole; infinite where it meets none.
double depth_of_ground(const Camera& camera, const glm::dvec2& position, const RayGround& ground);

/// The diameter of the widest circle of confusion of a picture that is so many pixels high, in
/// pixels: of ground on a lattice of rays, and of the sky where one of these sees it.
double widest_circle_of_confusion(const Camera& camera, const RayGround& ground,
                                  double pixels_high);

/// How many of a lens's points make a blur of that width look even: neighbours lie 1.5 pixels
/// apart; 16 to 128.
int enough_lens_points(double widest_pixels);

/// Some points of a lens and points within a pixel, of the same number.
struct LensPoint {
    glm::dvec2 on_disc;   ///< of radius 1
    glm::dvec2 in_pixel;  ///< −1/2 … 1/2
};

/// As many of them, each with the same share of the disc: on a spiral that turns by the golden
/// angle from one to the next (Vogel 1979, "A better way to construct the sunflower head"). Within
/// the pixel those of Sobol's sequence in two dimensions (1967), from its second on.
std::vector<LensPoint> lens_points(int count);

}  // namespace fumon
