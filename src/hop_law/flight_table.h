#pragma once

#include <span>
#include <string>

#include "models/air/grain_flight.h"

namespace fumon {

/// flights.csv: a row a flight, in SI units but the angle (degrees): where it began, the bed's
/// height and slope there, the launch angle, its length and time, and the largest particle Reynolds
/// number on the way. All digits that reading back needs.
std::string flight_table(std::span<const Flight> flights);

}  // namespace fumon
