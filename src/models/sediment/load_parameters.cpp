#include "models/sediment/load_parameters.h"

#include <cmath>

#include "models/sediment/water_density.h"

namespace fumon {

void list_keys(LoadParameters& loads, KeyTable& table) {
    table.real("model.morphological_factor", loads.morphological_factor,
               {.range = {0, 1e6},
                .help = "for transport \"loads\": the bed changes this many times as fast as the "
                        "water computes, so that one storm stands for many"});
    table.real(
        "model.bed_start", loads.bed_start,
        {.unit = "s",
         .range = {0, 1e9},
         .help =
             "for transport \"loads\": until this time of the water (rounded up to a whole step) "
             "the bed stays and nothing is carried, so that the water finds its way first"});
    table.real("model.grain_size", loads.grain_size,
               {.unit = "mm", .range = {1e-3, 1000}, .help = "d of the bed's grains"});
    table.real("model.grain_density", loads.grain_density,
               {.unit = "kg/m^3", .range = {1001, 20000}, .help = "of a grain; water has 1000"});
    table.real("model.porosity", loads.porosity, {.range = {0, 0.9}, .help = "phi of the bed"});
    table.real("model.repose_angle", loads.repose_angle,
               {.unit = "deg",
                .range = {5, 85},
                .help = "banks steeper than this collapse; grains move more easily as the bed's "
                        "descent along the flow nears it"});
    table.choice("model.bed_load", loads.bed_load,
                 {{BedLoadLaw::none, "none", "none"},
                  {BedLoadLaw::meyer_peter_mueller, "meyer-peter-mueller",
                   "8 (theta - theta_c)^1.5 (Meyer-Peter & Mueller 1948)"},
                  {BedLoadLaw::ashida_michiue, "ashida-michiue",
                   "17 theta^1.5 (1 - theta_c/theta) (1 - sqrt(theta_c/theta)) (Ashida & Michiue "
                   "1972), over a bed without forms"}},
                 {.help = "q_b over sqrt((s - 1) g d^3), of transport \"loads\""});
    table.word_or_real("model.critical_shields", loads.critical_shields,
                       {{"auto", "0.047, or 0.05 of ashida-michiue"}},
                       {.range = {0, 10}, .help = "theta_c on a level bed"});
    table.real("model.bed_load_slope", loads.bed_load_slope,
               {.range = {0, 10},
                .help = "r: bed load turns down the slope as q_b (u/|u| - r/sqrt(theta) grad z)"});
    table.choice("model.entrainment", loads.entrainment,
                 {{EntrainmentLaw::none, "none", "no suspended load, unless it comes in"},
                  {EntrainmentLaw::excess_shear, "excess-shear",
                   "M (tau/tau_e - 1) where tau > tau_e (Partheniades 1965)"}},
                 {.help = "what the bed gives to the water, of transport \"loads\""});
    table.real("model.entrainment_stress", loads.entrainment_stress,
               {.unit = "Pa", .range = {0, 1e4, true}, .help = "tau_e"});
    table.real("model.entrainment_rate", loads.entrainment_rate,
               {.unit = "kg/(m^2 s)", .range = {0, 1e3}, .help = "M"});
    table.word_or_real("model.settling_velocity", loads.settling_velocity,
                       {{"auto", "of model.grain_size (Ferguson & Church 2004), at 20 deg C"}},
                       {.unit = "m/s", .range = {0, 10}, .help = "w_s of suspended grains"});
    table.real(
        "model.settling_factor", loads.settling_factor,
        {.range = {0, 100}, .help = "alpha: what settles is alpha w_s times the concentration"});
    table.real("model.inflow_concentration", loads.inflow_concentration,
               {.range = {0, 0.6},
                .help = "suspended grains, volume over volume, of water that comes in over edges"});
    table.choice("model.bank_failure", loads.bank_failure,
                 {{BankFailure::none, "none", "slopes of any steepness stand"},
                  {BankFailure::avalanche, "avalanche",
                   "what is steeper than model.repose_angle slides down to it after each step"}},
                 {.help = "of transport \"loads\""});
    table.word_or_real("model.base_level", loads.base_level,
                       {{"none", "erosion goes as deep as the water can"}},
                       {.unit = "m",
                        .range = {-1e5, 1e5},
                        .help = "height, that of the mean plane included, below which nothing is "
                                "eroded"});
}

double critical_shields(const LoadParameters& loads) {
    if (!loads.critical_shields.is_word()) return loads.critical_shields.value;
    return loads.bed_load == BedLoadLaw::ashida_michiue ? 0.05 : 0.047;
}

double settling_velocity(const LoadParameters& loads, double gravity) {
    if (!loads.settling_velocity.is_word()) return loads.settling_velocity.value;
    constexpr double viscosity = 1e-6;  // m²/s
    constexpr double viscous = 18.0;
    constexpr double drag = 1.0;
    const double d = 1e-3 * loads.grain_size;
    const double weight = (loads.grain_density / water_density - 1.0) * gravity * d * d;
    return weight / (viscous * viscosity + std::sqrt(0.75 * drag * weight * d));
}

}  // namespace fumon
