#include "models/water/gully_parameters.h"

#include "keys/keys.h"

namespace fumon {

namespace {

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
         {InitialWater::dry, "dry", "none: it takes rain"}},
        {.help = "the water at the start"});
    table.real("model.depth", gully.depth,
               {.unit = "m", .range = {0, 1e4}, .help = "h of the water at the start"});
    table.choice("model.initial_flow", gully.initial_flow,
                 {{InitialFlow::automatic, "auto", "uniform on a slope, rest elsewhere"},
                  {InitialFlow::uniform, "uniform", "sqrt(g h S / C_f) down the mean plane"},
                  {InitialFlow::rest, "rest", "none"}},
                 {.help = "the water's velocity at the start"});
    const std::vector<Choice<EdgeKind>> edges{
        {EdgeKind::automatic, "auto", "periodic, but open for a terrain file"},
        {EdgeKind::periodic, "periodic", "what leaves comes in on the other side"},
        {EdgeKind::open, "open", "water leaves freely, none comes in"},
        {EdgeKind::wall, "wall", "nothing passes"}};
    table.choice("model.edges_x", gully.edges_x, edges, {.help = "west and east edge"});
    table.choice("model.edges_y", gully.edges_y, edges, {.help = "south and north edge"});
    table.real("model.rain", gully.rain,
               {.unit = "mm/h", .range = {0, 1e5}, .help = "on every cell"});
    table.real("model.rain_until", gully.rain_until,
               {.unit = "s", .range = {0, 1e12}, .help = "when the rain ends; 0: never"});
    table.choice("model.friction", gully.friction,
                 {{FrictionLaw::full, "full", "tau = rho C_f |u| u (eq. 6)"},
                  {FrictionLaw::half, "half", "tau = rho C_f |u| u / 2 (eq. 9)"}},
                 {.help = "the paper has both"});
    table.real("model.friction_coefficient", gully.friction_coefficient,
               {.range = {0, 10}, .help = "C_f"});
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
                       {{"auto", "1, or 0 where the bed is a terrain file or fixed"}},
                       {.unit = "m^2/s", .range = {0, 1e6}, .help = "D"});
}

}  // namespace

void list_keys(GullyParameters& gully, KeyTable& table) {
    list_flow_keys(gully, table);
    list_sediment_keys(gully, table);
}

}  // namespace fumon
