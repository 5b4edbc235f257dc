#include "models/air/airflow_parameters.h"

#include "base/limits.h"
#include "keys/keys.h"

namespace fumon {

namespace {

void list_bed_keys(AirflowParameters& air, KeyTable& table) {
    constexpr double most_waves = 1e4;
    table.choice(
        "model.bed", air.bed,
        {{AirBedShape::automatic, "auto", "cosine where the initial bed is level, else given"},
         {AirBedShape::cosine, "cosine", "h0 (cos(2 pi k x / W) + 1) (Terada 2025, eq. 5)"},
         {AirBedShape::given, "given",
          "a row of the initial bed, lowered until its lowest point is 0"}},
        {.help = "the fixed bed under the air"});
    table.real("model.bed_amplitude", air.bed_amplitude,
               {.unit = "mm", .range = {0, 1e6}, .help = "h0 of the cosine: half its height"});
    table.integer("model.bed_waves", air.bed_waves,
                  {.range = {1, most_waves},
                   .help = "k of the cosine, and of the wave fitted to the bed's shear stress"});
    table.integer("model.bed_row", air.bed_row,
                  {.range = {0, largest_grid_side - 1},
                   .help = "which row of a given bed of several, from the south"});
}

}  // namespace

void list_keys(AirflowParameters& air, KeyTable& table) {
    constexpr double fewest_nodes = 4;
    constexpr double most_nodes = 4096;
    table.integer("model.nz", air.nz,
                  {.unit = "cells",
                   .range = {fewest_nodes, most_nodes},
                   .help = "height of the lid above the bed's lowest point; a cell is as high as "
                           "it is long"});
    list_bed_keys(air, table);
    table.real("model.time_step", air.time_step,
               {.unit = "s",
                .range = {0, 1, true},
                .help = "of one step; the lid must move less than a cell in it"});
    table.real("model.lid_speed", air.lid_speed,
               {.unit = "m/s", .range = {0, 1000}, .help = "u0, toward +x"});
    table.real("model.density", air.density,
               {.unit = "kg/m^3", .range = {0, 1e5, true}, .help = "rho of the air"});
    table.real("model.viscosity", air.viscosity,
               {.unit = "m^2/s", .range = {0, 1e3, true}, .help = "nu of the air"});
    table.choice("model.scheme", air.scheme,
                 {{AirSchemeKind::staircase, "staircase",
                   "projection on a square grid (Terada 2025, section 3)"},
                  {AirSchemeKind::boundary_fitted, "boundary-fitted",
                   "stream function and vorticity on a grid that follows the bed: no steps, second "
                   "order"}},
                 {.help = "how the air is advanced"});
    table.choice(
        "model.advection", air.advection,
        {{AirAdvection::upwind, "upwind", "first order, as published (Terada 2025, eq. 30)"},
         {AirAdvection::second_order, "second-order",
          "linear upwind, which is less viscous; first order at nodes that lack one of "
          "their second neighbours, next to bed and lid"}},
        {.help = "differences of the staircase's advection term"});
    table.choice("model.bed_pressure", air.bed_pressure,
                 {{BedPressure::one_sided, "one-sided", "that of the node above: no gradient"},
                  {BedPressure::extrapolated, "extrapolated",
                   "2 p1 - p2 of the nodes above (Terada 2025, eq. 26); unstable where the "
                   "pressure is solved exactly, as it is here: ends in an error"}},
                 {.help = "the staircase's pressure at the node just under the bed"});
    table.boolean("model.until_steady", air.until_steady,
                  {.help = "hold the flow once it is steady: later steps change nothing"});
    table.real("model.steady_tolerance", air.steady_tolerance,
               {.range = {0, 1, true},
                .help = "steady once mean and amplitude of the bed's shear stress change by less "
                        "than this part of the mean in (H - mean h)^2 / (pi^2 nu), the time in "
                        "which a disturbance decays to 1/e"});
    list_keys(air.flight, table);
}

}  // namespace fumon
