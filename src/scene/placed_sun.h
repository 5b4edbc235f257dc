#pragma once

#include <cstdint>

#include "scene/faults.h"
#include "scene/scene.h"

namespace fumon {

/// Whether sun.place and sun.time say where the sun stands.
bool is_placed(const SunSettings& sun);

/// The sun at a share (0 … 1) of the run's steps, during which the clock goes on by sun.hours. One
/// without place and time stands still.
SunSettings sun_at(const SunSettings& sun, double share);

/// The share of a run's steps at one of them.
double share_of_run(std::int64_t step, std::int64_t last_step);

/// Adds what cannot be of sun.place, sun.time and sun.hours.
void check_sun(const Scene& scene, Faults& faults);

/// Where check_sun() found nothing: gives sun.azimuth and sun.elevation the values that place and
/// time have at the run's start.
void place_sun(SunSettings& sun);

}  // namespace fumon
