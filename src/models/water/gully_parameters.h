#pragma once

#include <string>

#include "keys/keys.h"

namespace fumon {

enum class WaterScheme { automatic, cip, cip_as_published, finite_volume };
enum class SedimentTransport { incision, as_printed, conservative, none };
enum class Relief { automatic, gentle, steep };
enum class FrictionLaw { full, half };
enum class InitialWater { film, level, dry };
enum class InitialFlow { automatic, uniform, rest };
enum class EdgeKind { automatic, periodic, open, wall };
enum class StoppingSteps { bed, all };
enum class Substeps { adaptive, fixed };

/// The parameters of the gully model (Saeki & Okamura 2007), in metres and seconds.
struct GullyParameters {
    WaterScheme scheme = WaterScheme::automatic;
    double time_step = 0.1;  ///< s: one step of the model
    Relief relief = Relief::automatic;
    StoppingSteps stopping_steps = StoppingSteps::bed;  ///< of finite volumes
    Substeps substeps = Substeps::adaptive;
    double courant_number = 0.4;  ///< of the sub-steps

    WordOrReal slope{"auto", 0.0};  ///< of the mean plane, m/m; auto: 0.04, 0 for a terrain file
    double channel_depth = 0.0;     ///< m, of a Gaussian trough down the middle of the plane
    double channel_width = 4.0;     ///< m, its standard deviation
    InitialWater initial_water = InitialWater::film;
    double depth = 0.01;  ///< m
    InitialFlow initial_flow = InitialFlow::automatic;
    EdgeKind edges_x = EdgeKind::automatic;
    EdgeKind edges_y = EdgeKind::automatic;
    double rain = 0.0;        ///< mm/h
    double rain_until = 0.0;  ///< s; 0: as long as the run

    FrictionLaw friction = FrictionLaw::full;
    double friction_coefficient = 0.01;  ///< C_f
    double gravity = 9.8;                ///< g, m/s²

    SedimentTransport transport = SedimentTransport::incision;
    WordOrReal transport_factor{"auto", 1.0};  ///< K_f; auto: 1, 1e-5 for a terrain file
    double stress_factor = 1.0;                ///< K_t
    double critical_stress = 0.0;              ///< τ_c
    double transport_exponent = 1.0;           ///< p
    double velocity_exponent = 1.8;            ///< q
    double slope_exponent = 2.1;               ///< γ
    WordOrReal bed_diffusion{"auto", 1.0};     ///< D, m²/s; auto: 1, 0 for a terrain file
};

/// Lists the keys model.* bound to these parameters.
void list_keys(GullyParameters& parameters, KeyTable& table);

}  // namespace fumon
