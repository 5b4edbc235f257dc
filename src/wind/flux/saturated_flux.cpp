#include "wind/flux/saturated_flux.h"

#include <cmath>

#include "base/elementary.h"
#include "base/elementary_power.h"

namespace fumon {

namespace {

constexpr double von_karman_constant = 0.4;
constexpr double seconds_per_year = 365.25 * 86400.0;
constexpr double fluid_threshold_number = 0.11;    // Bagnold's A
constexpr double impact_to_fluid_threshold = 0.8;  // of the fluid threshold

double relative_density(const SandAndAir& of) {
    return of.grain_density / of.air_density;
}

double cube_root(double x) {
    return elementary::pow(x, 1.0 / 3.0);
}

/// ∫ exp(−x)/x dx from low to high, by its series.
double exponential_integral(double low, double high) {
    double sum = elementary::log(high / low);
    double of_low = 1.0;
    double of_high = 1.0;
    constexpr int terms = 60;
    for (int k = 1; k <= terms; ++k) {
        of_low *= -low / k;
        of_high *= -high / k;
        sum += (of_high - of_low) / k;
    }
    return sum;
}

/// Scales of saltation that do not depend on the wind.
struct Saltation {
    double threshold = 0.0;      ///< friction velocity, m/s
    double restitution = 0.0;    ///< α, effective
    double slip = 0.0;           ///< Δu, m/s
    double logarithm = 0.0;      ///< ln(z1/z0)
    double weakened_part = 0.0;  ///< what the layer of grains takes from it
};

Saltation saltation_of(const SandAndAir& of) {
    constexpr double shear_restitution = 0.18;
    constexpr double roughness_share = 1.0 / 20.0;  // of the grain's diameter
    constexpr double height_of_layer = 14.0;
    constexpr double reference_height = 35.0;
    const double s = relative_density(of);
    const double viscosity = of.viscosity / of.air_density;
    const double d = of.grain_diameter;
    Saltation salt;
    salt.threshold = impact_threshold(of);
    const double threshold_number = impact_to_fluid_threshold * fluid_threshold_number;
    const double time = cube_root(viscosity / (of.gravity * of.gravity));
    const double length = cube_root(viscosity * viscosity /
                                    (threshold_number * threshold_number * of.gravity * (s - 1.0)));
    salt.restitution = shear_restitution * d / length;
    const double size = d * std::sqrt(of.gravity * d * (s - 1.0)) / (4.0 * viscosity);
    const double root = 0.95 + 5.12 * std::sqrt(2.0 * salt.restitution) / size;
    const double drag = 4.0 / 3.0 * root * root;
    salt.slip = std::sqrt(4.0 / 3.0 * of.gravity * (s - 1.0) * d / (2.0 * salt.restitution * drag));
    const double z0 = d * roughness_share;
    const double z1 = reference_height * length;
    const double layer = height_of_layer * salt.threshold * time;
    salt.logarithm = elementary::log(z1 / z0);
    salt.weakened_part = exponential_integral(z0 / layer, z1 / layer);
    return salt;
}

}  // namespace

double impact_threshold(const SandAndAir& of) {
    return impact_to_fluid_threshold * fluid_threshold_number *
           std::sqrt(of.gravity * of.grain_diameter * (relative_density(of) - 1.0));
}

double saturated_flux(const SandAndAir& of, double friction_velocity) {
    const Saltation salt = saltation_of(of);
    if (friction_velocity <= salt.threshold) return 0.0;
    const double excess = friction_velocity / salt.threshold;
    const double grains =
        friction_velocity / von_karman_constant *
            (salt.logarithm - (1.0 - salt.threshold / friction_velocity) * salt.weakened_part) -
        salt.slip;
    const double stress = of.air_density * salt.threshold * salt.threshold;
    return 2.0 * salt.restitution / of.gravity * stress * (excess * excess - 1.0) *
           std::fmax(grains, 0.0);
}

double friction_velocity(const SandAndAir& of, double speed, double height) {
    return von_karman_constant * speed / elementary::log(height / of.roughness);
}

double yearly_flux(const SandAndAir& of, double friction_velocity) {
    const double bulk = of.packing * of.grain_density;
    return saturated_flux(of, friction_velocity) / bulk * seconds_per_year;
}

}  // namespace fumon
