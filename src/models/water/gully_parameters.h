#pragma once

#include <string>
#include <vector>

#include "keys/keys.h"
#include "models/sediment/load_parameters.h"
#include "models/water/water_settings.h"

namespace fumon {

enum class WaterScheme { automatic, cip, cip_as_published, finite_volume };
enum class SedimentTransport { incision, as_printed, conservative, loads, none };
enum class Relief { automatic, gentle, steep };
enum class FrictionLaw { full, half, chezy, manning };
enum class InitialWater { film, level, surface, dry };
enum class InfiltrationLaw { none, constant, horton, green_ampt };
enum class HortonBy { intake, clock };
enum class InitialFlow { automatic, uniform, rest };
enum class EdgeKind { automatic, periodic, open, wall };
enum class StoppingSteps { bed, all };
enum class ShoreVelocity { sloped, even };
enum class ShoreCells { whole, partly_wet, planes };
enum class Substeps { adaptive, fixed };

/// The parameters of the gully model (Saeki & Okamura 2007), in metres and seconds.
struct GullyParameters {
    WaterScheme scheme = WaterScheme::automatic;
    double time_step = 0.1;  ///< s: one step of the model
    Relief relief = Relief::automatic;
    StoppingSteps stopping_steps = StoppingSteps::bed;  ///< of finite volumes
    double limiter_tolerance = 0.0;                     ///< of finite volumes: a share of the depth
    double limiter_steepness = 2.0;                     ///< of finite volumes: θ
    ShoreVelocity shore_velocity = ShoreVelocity::sloped;
    ShoreCells shore_cells = ShoreCells::whole;
    Substeps substeps = Substeps::adaptive;
    double courant_number = 0.4;  ///< of the sub-steps

    WordOrReal slope{"auto", 0.0};  ///< of the mean plane, m/m; auto: 0.04, 0 for a terrain file
    double slope_x = 0.0;           ///< … along x, where it descends eastward
    double channel_depth = 0.0;     ///< m, of a Gaussian trough down the middle of the plane
    double channel_width = 4.0;     ///< m, its standard deviation
    InitialWater initial_water = InitialWater::film;
    double depth = 0.01;   ///< m
    double surface = 0.0;  ///< m
    InitialFlow initial_flow = InitialFlow::automatic;
    EdgeKind edges_x = EdgeKind::automatic;
    EdgeKind edges_y = EdgeKind::automatic;
    double rain = 0.0;               ///< mm/h
    double rain_until = 0.0;         ///< s; 0: as long as the run
    std::vector<double> rain_times;  ///< s, rising; empty: `rain` throughout
    std::vector<double> rain_rates;  ///< mm/h, from these times on
    InfiltrationLaw infiltration = InfiltrationLaw::none;
    double infiltration_rate = 10.0;   ///< mm/h: constant, in the end (Horton), or conductivity
    double infiltration_start = 60.0;  ///< mm/h, at t = 0 (Horton)
    double infiltration_decay = 2.0;   ///< 1/h (Horton)
    HortonBy horton_by = HortonBy::intake;
    double infiltration_recovery = 0.0;  ///< 1/h, of dry ground (Horton)
    double suction_head = 0.1;           ///< ψ, m (Green–Ampt)
    double moisture_deficit = 0.3;       ///< Δθ (Green–Ampt)

    SedimentTransport transport = SedimentTransport::incision;
    FrictionLaw friction = FrictionLaw::full;
    double friction_coefficient = 0.01;  ///< C_f
    double chezy = 40.0;                 ///< C, √m/s
    double manning = 0.03;               ///< n, s/m^(1/3)
    double gravity = 9.8;                ///< g, m/s²

    WordOrReal transport_factor{"auto", 1.0};  ///< K_f; auto: 1, 1e-5 for a terrain file
    double stress_factor = 1.0;                ///< K_t
    double critical_stress = 0.0;              ///< τ_c
    double transport_exponent = 1.0;           ///< p
    double velocity_exponent = 1.8;            ///< q
    double slope_exponent = 2.1;               ///< γ
    WordOrReal bed_diffusion{"auto", 1.0};     ///< D, m²/s; auto: 1, 0 for a terrain file

    LoadParameters loads;  ///< of transport "loads"

    std::vector<RegionSettings> regions;
    std::vector<EdgeSettings> edges;
    std::vector<GaugeSettings> gauges;
    std::vector<MapSettings> maps;
    bool basin = false;  ///< edges that are automatic are walls, and it may be dry for ever
};

/// Those of model "water": a basin with a fixed, level bed.
struct WaterParameters : GullyParameters {
    WaterParameters() {
        scheme = WaterScheme::finite_volume;
        slope = 0.0;
        initial_water = InitialWater::dry;
        transport = SedimentTransport::none;
        basin = true;
    }
};

/// C_f of all laws but Manning's, with the half of it that eq. 9 takes; 0 for Manning's.
double constant_friction(const GullyParameters& parameters);

/// The factor of τ = ρ · factor · |u| u that a coefficient of the friction law gives: C_f, half of
/// it, g/C², or g n², with which Manning's law has ρ · factor · h^(−1/3) · |u| u.
double friction_factor(const GullyParameters& parameters, double coefficient);
/// … and that of the parameters' own coefficient.
double friction_factor(const GullyParameters& parameters);

/// Lists the keys model.* bound to these parameters.
void list_keys(GullyParameters& parameters, KeyTable& table);

}  // namespace fumon
