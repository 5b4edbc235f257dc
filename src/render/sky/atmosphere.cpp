#include "render/sky/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"

namespace fumon {

AirOptics Atmosphere::optics(double height) const {
    const double h = std::max(height, 0.0);
    const double molecules = elementary::exp(-h / rayleigh_height);
    const double aerosol = elementary::exp(-h / mie_height);
    const double ozone_share = h < ozone_middle
                                   ? (h - ozone_lowest) / (ozone_middle - ozone_lowest)
                                   : (ozone_highest - h) / (ozone_highest - ozone_middle);
    AirOptics of;
    of.rayleigh = rayleigh * molecules;
    of.mie = dust_tint * (mie * aerosol);
    of.mie_extinction = mie_extinction * aerosol;
    of.absorption = ozone * std::max(ozone_share, 0.0);
    return of;
}

Atmosphere dusty_air(double dust, const glm::dvec3& ground_albedo) {
    Atmosphere air;
    air.mie *= dust;
    air.mie_extinction *= dust;
    const glm::dvec3 desert(1.0, 0.9, 0.75);
    const double share = std::clamp(dust - 1.0, 0.0, 1.0);
    air.dust_tint = glm::mix(glm::dvec3(1.0), desert, share);
    air.ground_albedo = ground_albedo;
    return air;
}

Atmosphere martian_air(double dust, const glm::dvec3& ground_albedo) {
    Atmosphere air;
    air.ground = 3390.0;
    air.top = 3490.0;
    air.rayleigh *=
        0.0185;  // 0.8 % of the Earth's molecules, each with 2.3 times the cross-section
    air.rayleigh_height = 11.1;
    air.mie_height = 11.1;
    air.mie = 0.5 / air.mie_height * dust;
    air.mie_extinction = glm::dvec3(air.mie);
    air.dust_tint = {0.97, 0.90, 0.76};  // single-scattering albedo
    air.mie_asymmetry = {0.63, 0.67, 0.76};
    air.ozone = glm::dvec3(0.0);
    air.ground_albedo = ground_albedo;
    return air;
}

RayEnd end_of_ray(const Atmosphere& air, double radius, double up) {
    // r² + 2 r up t + t² = R²
    const double across = radius * radius * (up * up - 1.0);
    const double to_ground = across + air.ground * air.ground;
    if (up < 0.0 && to_ground >= 0.0)
        return {std::max(-radius * up - std::sqrt(to_ground), 0.0), true};
    const double to_top = std::max(across + air.top * air.top, 0.0);
    return {std::max(-radius * up + std::sqrt(to_top), 0.0), false};
}

RayPoint along_ray(double radius, double up, double distance) {
    const double there =
        std::sqrt(radius * radius + 2.0 * radius * up * distance + distance * distance);
    return {there, std::clamp((radius * up + distance) / there, -1.0, 1.0)};
}

double rayleigh_phase(double cosine) {
    return 3.0 / (16.0 * std::numbers::pi) * (1.0 + cosine * cosine);
}

double mie_phase(double cosine, double asymmetry) {
    const double g = asymmetry;
    const double base = 1.0 + g * g - 2.0 * g * cosine;
    return 3.0 / (8.0 * std::numbers::pi) * (1.0 - g * g) * (1.0 + cosine * cosine) /
           ((2.0 + g * g) * base * std::sqrt(base));
}

double henyey_greenstein(double cosine, double asymmetry) {
    const double g = asymmetry;
    const double base = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (4.0 * std::numbers::pi * base * std::sqrt(base));
}

double aerosol_phase(const Atmosphere& air, int band, double cosine) {
    const double g = air.mie_asymmetry[band];
    if (air.mie_back == 0.0) return mie_phase(cosine, g);
    return (1.0 - air.mie_back) * henyey_greenstein(cosine, g) +
           air.mie_back * henyey_greenstein(cosine, back_asymmetry);
}

}  // namespace fumon
