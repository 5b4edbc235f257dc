#pragma once

#include <span>
#include <string>

#include "models/air/grain_flight.h"

namespace fumon {

/// flights.csv: one row per flight, in SI units except for the angle (degrees): where it began, the
/// bed's height and slope there, the launch angle, its length and duration, and the largest
/// particle Reynolds number on the way, with as many digits as reading back needs.
std::string flight_table(std::span<const Flight> flights);

}  // namespace fumon
