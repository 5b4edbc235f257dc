#pragma once

#include "keys/keys.h"

namespace fumon {

enum class BedLoadLaw { none, meyer_peter_mueller, ashida_michiue };
enum class EntrainmentLaw { none, excess_shear };
enum class BankFailure { none, avalanche };

/// What water carries along its bed and in itself, and what the bed is made of.
struct LoadParameters {
    double morphological_factor = 1.0;
    double bed_start = 0.0;         ///< s: before it the bed stays, and nothing is carried
    double grain_size = 0.5;        ///< d, mm
    double grain_density = 2650.0;  ///< kg/m³
    double porosity = 0.4;          ///< φ of the bed
    double repose_angle = 33.0;     ///< degrees
    BedLoadLaw bed_load = BedLoadLaw::meyer_peter_mueller;
    WordOrReal critical_shields{"auto", 0.047};  ///< θ_c; auto: the law's
    double bed_load_slope = 0.4;                 ///< r of q_b (u/|u| − (r/√θ) ∇z)
    EntrainmentLaw entrainment = EntrainmentLaw::none;
    double entrainment_stress = 1.0;            ///< τ_e, Pa
    double entrainment_rate = 1e-3;             ///< M, kg/(m² s)
    WordOrReal settling_velocity{"auto", 0.0};  ///< w_s, m/s; auto: of the grain size
    double settling_factor = 1.0;               ///< α, concentration at the bed over its mean
    double inflow_concentration = 0.0;          ///< of water that comes in over edges
    BankFailure bank_failure = BankFailure::avalanche;
    WordOrReal base_level{"none", 0.0};  ///< m: no erosion below
};

/// Lists the keys model.* bound to these parameters.
void list_keys(LoadParameters& loads, KeyTable& table);

/// θ_c, with "auto" decided: 0.047 of Meyer-Peter & Müller (1948), 0.05 of Ashida & Michiue (1972).
double critical_shields(const LoadParameters& loads);

/// w_s, m/s, with "auto" decided: Ferguson & Church (2004) in water of 20 °C,
/// w = R g d² / (18 ν + √(0.75 · 1.0 · R g d³)) of natural grains, R = density / 1000 − 1.
double settling_velocity(const LoadParameters& loads, double gravity);

}  // namespace fumon
