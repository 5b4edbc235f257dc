#pragma once

#include <span>
#include <vector>

#include "models/air/flight_parameters.h"
#include "models/air/grain_flight.h"
#include "models/shared/model.h"
#include "numerics/hop_law.h"

namespace fumon {

/// Flights as hop laws see them (Terada 2025, section 4): lengths in mm, heights in mm above the
/// lowest launch, slopes as they are.
std::vector<HopPoint> hop_points(std::span<const Flight> flights);

/// Flies the grains of `parameters` through a section and adds to it a curve of flight lengths
/// (m) over the launch's column for each angle, "flight_length_10" …, and `shown_paths` paths of
/// each angle. Returns the numbers that go with them: "hop_base" (a of l = a^h − 1 in mm, heights
/// above the bed's lowest point, over all flights; Terada 2025, section 4), "hop_r_squared" of
/// that, "hop_line_r_squared" of the straight line, and "largest_grain_reynolds". On a flat bed
/// the first three are not there. Throws as GrainFlights does.
std::vector<SnapshotNumber> add_flights(SnapshotSection& section,
                                        const FlightParameters& parameters, const Air& air,
                                        WorkerPool& pool);

}  // namespace fumon
