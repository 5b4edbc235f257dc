#include "models/air/flight_parameters.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "keys/keys.h"

namespace fumon {

namespace {

constexpr std::size_t most_angles = 90;

}  // namespace

void list_keys(FlightParameters& flight, KeyTable& table) {
    table.boolean("model.flights", flight.flights,
                  {.help = "fly a grain from every column at every launch angle, in the flow as it "
                           "is when a frame is taken (Terada 2025, section 4)"});
    table.real_list("model.launch_angles", flight.launch_angles, 1, most_angles,
                    {.unit = "degrees",
                     .range = {0, 180, true},
                     .help = "theta, between the launch and the bed's slope; 180 is upwind"});
    table.real("model.grain_diameter", flight.grain_diameter,
               {.unit = "mm", .range = {0, 10, true}, .help = "d"});
    table.real("model.grain_density", flight.grain_density,
               {.unit = "kg/m^3", .range = {0, 30000, true}, .help = "of the grains; quartz 2650"});
    table.choice("model.drag", flight.drag,
                 {{GrainDrag::stokes, "stokes",
                   "3 pi rho nu d: particle Reynolds numbers below 2 (Terada 2025, eq. 12)"},
                  {GrainDrag::schiller_naumann, "schiller-naumann",
                   "Stokes times 1 + 0.15 Re^0.687: below 800 (Schiller & Naumann 1933)"}},
                 {.help = "the air's drag on a grain"});
    table.real("model.flight_time_step", flight.flight_time_step,
               {.unit = "s",
                .range = {0, 1, true},
                .help = "of the grains' explicit Euler steps (eqs. 41, 44)"});
    table.integer("model.shown_paths", flight.shown_paths,
                  {.range = {0, 10000},
                   .help = "paths of grains shown for each angle, launched evenly along the bed"});
}

void check(const FlightParameters& flight) {
    if (flight.launch_angles.empty()) {
        throw KeyError("model.launch_angles",
                       "model.launch_angles is empty; give at least one, such as [10, 20, 30, 40]");
    }
    std::vector<double> angles = flight.launch_angles;
    std::sort(angles.begin(), angles.end());
    const auto twice = std::adjacent_find(angles.begin(), angles.end());
    if (twice != angles.end()) {
        throw KeyError(
            "model.launch_angles",
            fmt::format("model.launch_angles has {:g} degrees twice; name it once", *twice));
    }
}

}  // namespace fumon
