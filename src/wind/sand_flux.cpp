#include "wind/sand_flux.h"

#include "wind/direction.h"

namespace fumon {

namespace {

constexpr double knots_per_metre_per_second = 3600.0 / 1852.0;
constexpr double percent = 100.0;
constexpr double drift_potential_divisor = 100.0;  // by Fryberger & Dean, to keep them short
}  // namespace

std::vector<SandFlux> fryberger_fluxes(const WindRose& rose, double threshold_knots) {
    std::vector<SandFlux> fluxes;
    for (const WindClass& wind : rose) {
        const double speed = wind.speed * knots_per_metre_per_second;
        if (speed <= threshold_knots) continue;
        const double weight = speed * speed * (speed - threshold_knots) / drift_potential_divisor;
        fluxes.push_back({opposite(wind.from), weight * wind.share * percent});
    }
    return fluxes;
}

double friction_velocity_of(const WindClass& wind, const SandAndAir& of, double height) {
    return wind.friction_velocity > 0.0 ? wind.friction_velocity
                                        : friction_velocity(of, wind.speed, height);
}

std::vector<SandFlux> saturated_fluxes(const WindRose& rose, const SandAndAir& of, double height) {
    std::vector<SandFlux> fluxes;
    for (const WindClass& wind : rose) {
        const double flux = yearly_flux(of, friction_velocity_of(wind, of, height));
        if (flux > 0.0) fluxes.push_back({opposite(wind.from), flux * wind.share});
    }
    return fluxes;
}

}  // namespace fumon
