#pragma once

#include <cstdint>
#include <vector>

namespace fumon {

class KeyTable;

enum class GrainDrag { stokes, schiller_naumann };

/// The grains that fly in a computed air flow (Terada 2025, sections 2.2 and 4), as scenes give
/// them.
struct FlightParameters {
    bool flights = false;                                       ///< whether snapshots hold flights
    std::vector<double> launch_angles{10.0, 20.0, 30.0, 40.0};  ///< to the local bed, degrees
    double grain_diameter = 0.3;                                ///< d, mm
    double grain_density = 2650.0;                              ///< kg/m³
    GrainDrag drag = GrainDrag::stokes;
    double flight_time_step = 1e-5;  ///< Δt_p, s
    std::int64_t shown_paths = 0;    ///< of each angle, in snapshots
};

/// Lists the keys model.* bound to these parameters.
void list_keys(FlightParameters& parameters, KeyTable& table);

/// Throws KeyError where angles are missing or repeated.
void check(const FlightParameters& parameters);

}  // namespace fumon
