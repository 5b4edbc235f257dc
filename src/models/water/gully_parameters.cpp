#include "models/water/gully_parameters.h"

#include "base/limits.h"
#include "keys/keys.h"

namespace fumon {

namespace {

/// What the ground does to the water.
void list_ground_keys(GullyParameters& gully, KeyTable& table) {
    table.real_list("model.rain_times", gully.rain_times, 0, 100000,
                    {.unit = "s",
                     .range = {-largest_time, largest_time},
                     .help = "at which the rain changes, rising; none before the first; empty: "
                             "model.rain throughout"});
    table.real_list("model.rain_rates", gully.rain_rates, 0, 100000,
                    {.unit = "mm/h",
                     .range = {0, 1e5},
                     .help = "each from its time of model.rain_times to the next"});
    table.choice("model.infiltration", gully.infiltration,
                 {{InfiltrationLaw::none, "none", "the ground takes no water"},
                  {InfiltrationLaw::constant, "constant", "model.infiltration_rate"},
                  {InfiltrationLaw::horton, "horton",
                   "falls from model.infiltration_start to model.infiltration_rate as e^(-kt) "
                   "(Horton 1933)"},
                  {InfiltrationLaw::green_ampt, "green-ampt",
                   "K (1 + psi dtheta / F), F what the cell has taken (Green & Ampt 1911)"}},
                 {.help = "how much water the ground takes where there is some"});
    table.real("model.infiltration_rate", gully.infiltration_rate,
               {.unit = "mm/h",
                .range = {0, 1e5},
                .help = "constant; in the end (horton); or the conductivity K (green-ampt)"});
    table.real("model.infiltration_start", gully.infiltration_start,
               {.unit = "mm/h", .range = {0, 1e6}, .help = "at t = 0, of horton"});
    table.real("model.infiltration_decay", gully.infiltration_decay,
               {.unit = "1/h", .range = {0, 1e6}, .help = "k of horton"});
    table.choice(
        "model.horton_by", gully.horton_by,
        {{HortonBy::intake, "intake",
          "what a cell has taken: where less water comes than it could take, its capacity "
          "falls more slowly"},
         {HortonBy::clock, "clock", "the time since the start, rain or not"}},
        {.help = "by what the capacity of horton falls", .earlier = {"0.3.0", "\"clock\""}});
    table.real("model.infiltration_recovery", gully.infiltration_recovery,
               {.unit = "1/h",
                .range = {0, 1e6},
                .help = "k of the capacity of horton that ground without water gets back, toward "
                        "model.infiltration_start as e^(-kt) (Rossman & Huber 2016)"});
    table.real("model.suction_head", gully.suction_head,
               {.unit = "m", .range = {0, 100}, .help = "psi of green-ampt"});
    table.real("model.moisture_deficit", gully.moisture_deficit,
               {.range = {0, 1}, .help = "dtheta of green-ampt: porosity less water content"});
    table.choice("model.friction", gully.friction,
                 {{FrictionLaw::full, "full", "tau = rho C_f |u| u (eq. 6)", "1"},
                  {FrictionLaw::half, "half", "tau = rho C_f |u| u / 2 (eq. 9)", "1"},
                  {FrictionLaw::chezy, "chezy", "tau = rho g |u| u / C^2", "m^(1/2)/s"},
                  {FrictionLaw::manning, "manning",
                   "tau = rho g n^2 |u| u / h^(1/3); of finite volumes", "s/m^(1/3)"}},
                 {.help = "full and half are the paper's, which has both"});
    table.real("model.friction_coefficient", gully.friction_coefficient,
               {.range = {0, 10}, .help = "C_f of full and half"});
    table.real("model.chezy", gully.chezy,
               {.unit = "m^(1/2)/s", .range = {0, 1e4, true}, .help = "C"});
    table.real("model.manning", gully.manning,
               {.unit = "s/m^(1/3)", .range = {0, 10}, .help = "n"});
}

void list_flow_keys(GullyParameters& gully, KeyTable& table) {
    table.choice(
        "model.scheme", gully.scheme,
        {{WaterScheme::automatic, "auto", "cip on a periodic plane, finite-volume elsewhere"},
         {WaterScheme::cip, "cip",
          "CIP advection of the velocities, the depth by conserved fluxes"},
         {WaterScheme::cip_as_published, "cip-as-published",
          "CIP advection of depth too (Saeki & Okamura 2007, eqs. 10, 11): loses water"},
         {WaterScheme::finite_volume, "finite-volume",
          "second order, well-balanced, for wet and dry ground and open edges"}},
        {.help = "how the water is advanced"});
    table.choice(
        "model.relief", gully.relief,
        {{Relief::automatic, "auto", "steep for a terrain file, gentle elsewhere"},
         {Relief::gentle, "gentle",
          "central differences, as published: for planes of some hundredths, with diffusion"},
         {Relief::steep, "steep",
          "S toward the lower neighbours; no cell is cut below them, and conserved sediment goes "
          "to them alone; in CIP no bank presses on water below it: stable on any terrain"}},
        {.help = "what the grid's differences are made for; as-printed transport is central on "
                 "either"});
    table.choice(
        "model.stopping_steps", gully.stopping_steps,
        {{StoppingSteps::bed, "bed",
          "the bed's own: a shore climbs a slope that the grid resolves"},
         {StoppingSteps::all, "all",
          "what limited reconstruction leaves too: a moving shore loses momentum"}},
        {.help = "of finite volumes: the steps at which water that does not pass loses its "
                 "momentum",
         .earlier = {"0.2.0", "\"all\""}});
    table.real("model.limiter_tolerance", gully.limiter_tolerance,
               {.range = {0, 0.1},
                .help = "of finite volumes: what changes from cell to cell by less than this share "
                        "of the depth is not limited; 0.01 for calm flow, in which the limiter "
                        "keeps ripples standing"});
    table.real("model.limiter_steepness", gully.limiter_steepness,
               {.range = {1, 2},
                .help = "of finite volumes: slopes within cells over the smaller of the "
                        "differences to both sides; 1 where a jump that stands still keeps "
                        "sending waves"});
    table.choice("model.shore_velocity", gully.shore_velocity,
                 {{ShoreVelocity::sloped, "sloped", "as elsewhere"},
                  {ShoreVelocity::even, "even",
                   "has no slope: a shore that moves over a smooth bed sends fewer waves"}},
                 {.help = "of finite volumes: the velocity within cells whose water is thinner "
                          "than twice the bed's steps"});
    table.choice("model.shore_cells", gully.shore_cells,
                 {{ShoreCells::whole, "whole", "is wet from side to side"},
                  {ShoreCells::partly_wet, "partly-wet",
                   "is wet up to a line within it, by its depth and that of the next: a shore "
                   "that moves over a smooth bed stays as sharp as a cell"},
                  {ShoreCells::planes, "planes",
                   "likewise, but where the grid resolves the bed its water has the surface and "
                   "velocity of the deeper water, so that a shore may lie aslant; depths are "
                   "means over the cell there"}},
                 {.help = "of finite volumes: a cell beyond which the bed rises above its water"});
    table.real("model.time_step", gully.time_step,
               {.unit = "s", .range = {0, 1000, true}, .help = "of one step"});
    table.choice(
        "model.substeps", gully.substeps,
        {{Substeps::adaptive, "adaptive", "as many as model.courant_number demands"},
         {Substeps::fixed, "fixed", "one a step, as published; refused beyond Courant number 1"}},
        {.help = "how a step is divided"});
    table.real("model.courant_number", gully.courant_number,
               {.range = {0, 0.5, true},
                .help = "largest (|u| + sqrt(g h)) dt / dx + the same in y, of a sub-step"});
    table.word_or_real("model.slope", gully.slope,
                       {{"auto", "0.04, or 0 where the bed is a terrain file"}},
                       {.unit = "m/m",
                        .range = {0, 1},
                        .help = "of the mean plane, which descends southward; the bed is the "
                                "departure from it"});
    table.real(
        "model.slope_x", gully.slope_x,
        {.unit = "m/m",
         .range = {-1, 1},
         .help = "of the mean plane along x, where it descends eastward; of finite volumes"});
    table.real("model.channel_depth", gully.channel_depth,
               {.unit = "m",
                .range = {0, 1000},
                .help = "of a Gaussian trough along y, cut into the initial bed at its middle; "
                        "0: none"});
    table.real("model.channel_width", gully.channel_width,
               {.unit = "m", .range = {0, 1e6, true}, .help = "the trough's standard deviation"});
    table.choice(
        "model.initial_water", gully.initial_water,
        {{InitialWater::film, "film", "model.depth everywhere"},
         {InitialWater::level, "level",
          "a level surface with model.depth in the mean over all cells: deeper in the trough, none "
          "on what stands above it"},
         {InitialWater::surface, "surface",
          "a level surface at model.surface; what stands above it is dry"},
         {InitialWater::dry, "dry", "none: it takes rain, [[water]] or [[edge]]"}},
        {.help = "the water at the start"});
    table.real("model.depth", gully.depth,
               {.unit = "m", .range = {0, 1e4}, .help = "h of the water at the start"});
    table.real("model.surface", gully.surface,
               {.unit = "m",
                .range = {-1e5, 1e5},
                .help = "height of the water's surface of model.initial_water = \"surface\""});
    table.choice("model.initial_flow", gully.initial_flow,
                 {{InitialFlow::automatic, "auto", "uniform on a slope, rest elsewhere"},
                  {InitialFlow::uniform, "uniform", "sqrt(g h S / C_f) down the mean plane"},
                  {InitialFlow::rest, "rest", "none"}},
                 {.help = "the water's velocity at the start"});
    const std::vector<Choice<EdgeKind>> edges{
        {EdgeKind::automatic, "auto",
         "open for a terrain file; else walls in model water and where [[edge]] says more; else "
         "periodic"},
        {EdgeKind::periodic, "periodic", "what leaves comes in on the other side"},
        {EdgeKind::open, "open", "water leaves freely, none comes in"},
        {EdgeKind::wall, "wall", "nothing passes"}};
    table.choice("model.edges_x", gully.edges_x, edges, {.help = "west and east edge"});
    table.choice("model.edges_y", gully.edges_y, edges, {.help = "south and north edge"});
    table.real("model.rain", gully.rain,
               {.unit = "mm/h", .range = {0, 1e5}, .help = "on every cell"});
    table.real("model.rain_until", gully.rain_until,
               {.unit = "s", .range = {0, 1e12}, .help = "when the rain ends; 0: never"});
    list_ground_keys(gully, table);
    table.real("model.gravity", gully.gravity,
               {.unit = "m/s^2", .range = {0, 100, true}, .help = "g"});
}

void list_sediment_keys(GullyParameters& gully, KeyTable& table) {
    table.choice("model.transport", gully.transport,
                 {{SedimentTransport::incision, "incision",
                   "dz/dt = -|q_s| / (1 m) + D lap z: detachment, on any grid alike"},
                  {SedimentTransport::as_printed, "as-printed",
                   "eq. 12 with its + signs: the published figures; a sink -|q_s|/dx that depends "
                   "on the grid"},
                  {SedimentTransport::conservative, "conservative",
                   "dz/dt = -div q_s + D lap z: keeps sediment; no channels grow"},
                  {SedimentTransport::loads, "loads",
                   "bed load and suspended load of grains, which settle again: model.bed_load, "
                   "model.entrainment; keeps sediment; of finite volumes"},
                  {SedimentTransport::none, "none", "a fixed bed, which does not diffuse either"}},
                 {.help = "how flow changes the bed"});
    table.word_or_real("model.transport_factor", gully.transport_factor,
                       {{"auto", "1, or 1e-5 where the bed is a terrain file"}},
                       {.range = {0, 1e9},
                        .help = "K_f of q_s = K_f (K_t U^q S^gamma - tau_c)^p; 1 suits slopes of "
                                "some hundredths"});
    table.real("model.stress_factor", gully.stress_factor,
               {.range = {0, 1e9}, .help = "K_t; the paper says 0, which would stop everything"});
    table.real("model.critical_stress", gully.critical_stress,
               {.range = {0, 1e9}, .help = "tau_c: no transport below"});
    table.real("model.transport_exponent", gully.transport_exponent,
               {.range = {0.1, 10}, .help = "p"});
    table.real("model.velocity_exponent", gully.velocity_exponent,
               {.range = {0, 10}, .help = "q, of the speed U"});
    table.real("model.slope_exponent", gully.slope_exponent,
               {.range = {0, 10}, .help = "gamma, of the steepness S, mean slope included"});
    table.word_or_real("model.bed_diffusion", gully.bed_diffusion,
                       {{"auto", "1, or 0 where the bed is a terrain file, fixed or of loads"}},
                       {.unit = "m^2/s", .range = {0, 1e6}, .help = "D"});
}

}  // namespace

double constant_friction(const GullyParameters& parameters) {
    return parameters.friction == FrictionLaw::manning ? 0.0 : friction_factor(parameters);
}

double friction_factor(const GullyParameters& parameters, double coefficient) {
    switch (parameters.friction) {
        case FrictionLaw::full:
            return coefficient;
        case FrictionLaw::half:
            return 0.5 * coefficient;
        case FrictionLaw::chezy:
            return parameters.gravity / (coefficient * coefficient);
        case FrictionLaw::manning:
            return parameters.gravity * (coefficient * coefficient);
    }
    return coefficient;
}

double friction_factor(const GullyParameters& parameters) {
    switch (parameters.friction) {
        case FrictionLaw::full:
        case FrictionLaw::half:
            return friction_factor(parameters, parameters.friction_coefficient);
        case FrictionLaw::chezy:
            return friction_factor(parameters, parameters.chezy);
        case FrictionLaw::manning:
            return friction_factor(parameters, parameters.manning);
    }
    return 0.0;
}

void list_keys(GullyParameters& gully, KeyTable& table) {
    list_flow_keys(gully, table);
    list_sediment_keys(gully, table);
    list_keys(gully.loads, table);
    // After all of [model], which a written scene cannot open twice.
    table.tables("water", gully.regions,
                 "water at the start, in the order written, each over those before", list_region);
    table.tables("edge", gully.edges,
                 "a stretch of the grid's edge with a kind of its own; of finite volumes",
                 list_edge);
    table.tables("gauge", gully.gauges,
                 "a place whose water is noted: columns of measurements.csv and fields.nc",
                 list_gauge);
    table.tables("map", gully.maps,
                 "rain, roughness or the water at the start, cell by cell from a file", list_map);
}

}  // namespace fumon
