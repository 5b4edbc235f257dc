#pragma once

#include <cstdint>

#include "models/air/flight_parameters.h"

namespace fumon {

class KeyTable;

enum class AirSchemeKind { staircase, boundary_fitted };
enum class AirBedShape { automatic, cosine, given };
enum class AirAdvection { upwind, second_order };
enum class BedPressure { one_sided, extrapolated };

/// The parameters of the air over a bed (Terada 2025, section 2); by default those of its table 2.
struct AirflowParameters {
    std::int64_t nz = 30;  ///< nodes from the bed's lowest point up to one below the lid
    AirBedShape bed = AirBedShape::automatic;
    double bed_amplitude = 0.25;  ///< h0, mm
    std::int64_t bed_waves = 1;   ///< k_bed: over the whole width
    std::int64_t bed_row = 0;     ///< of an initial bed of several rows
    double time_step = 5e-6;      ///< Δt, s
    double lid_speed = 1.0;       ///< u0, m/s
    double density = 1.3;         ///< ρ, kg/m³
    double viscosity = 1.5e-5;    ///< ν, m²/s
    AirSchemeKind scheme = AirSchemeKind::staircase;
    AirAdvection advection = AirAdvection::upwind;
    BedPressure bed_pressure = BedPressure::one_sided;
    bool until_steady = false;
    double steady_tolerance = 1e-3;
    FlightParameters flight;
};

/// Lists the keys model.* bound to these parameters.
void list_keys(AirflowParameters& parameters, KeyTable& table);

}  // namespace fumon
