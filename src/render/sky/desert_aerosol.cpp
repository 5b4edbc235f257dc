#include "render/sky/desert_aerosol.h"

#include <algorithm>

#include "base/elementary.h"
#include "base/elementary_power.h"

namespace fumon {

namespace {

constexpr double contrast_log = 3.912;            // −ln of the 2 % of contrast that is still seen
constexpr double molecules = 0.013558;            // extinction per km at 550 nm (Atmosphere)
constexpr double exponent = 0.7;                  // Ångström's, of a clear day
constexpr glm::dvec3 bands{680.0, 550.0, 440.0};  // nm, of Atmosphere
constexpr glm::dvec3 primaries{612.0, 550.0, 465.0};  // nm, about the middles of sRGB's
// Dust above that of a clear day: as deep in all as the dust of dusty_air(), for each unit.
constexpr double more_dust = 3.0 * 0.004440 * 1.2 / desert_aerosol::height;

double clear_aerosol() {
    return contrast_log / desert_aerosol::clear_visibility - molecules;
}

/// Extinction by aerosol at 550 nm, per km: fine and coarse of a clear day, and dust besides.
struct Amounts {
    double clear = 0.0;
    double dust = 0.0;
};

Amounts amounts(double dust) {
    return {clear_aerosol() * std::min(dust, 1.0), more_dust * std::max(dust - 1.0, 0.0)};
}

glm::dvec3 power(const glm::dvec3& wavelengths, double by) {
    glm::dvec3 result(1.0);
    for (int band = 0; band < 3; ++band)
        result[band] = elementary::pow(wavelengths[band] / 550.0, by);
    return result;
}

}  // namespace

double desert_aerosol::extinction_of_visibility(double kilometres) {
    return contrast_log / kilometres;
}

double desert_aerosol::visibility(double dust) {
    const Amounts of = amounts(dust);
    return contrast_log / (molecules + of.clear + of.dust);
}

glm::dvec3 desert_aerosol::extinction(double visibility, double dust) {
    const double all = extinction_of_visibility(visibility);
    const double scattered_by_molecules = std::min(molecules, all);
    const Amounts of = amounts(dust);
    const double coarse = of.dust / std::max(of.clear + of.dust, 1e-9);
    return scattered_by_molecules * power(primaries, -4.0) +
           (all - scattered_by_molecules) *
               glm::mix(power(primaries, -exponent), glm::dvec3(1.0), coarse);
}

double desert_aerosol::thinner_from(double eye_height) {
    const double u = std::max(eye_height, 0.0) / height;
    return 1.0 / (1.0 + u * (0.5 + u / 12.0));
}

Atmosphere desert_air(double dust, const glm::dvec3& ground_albedo) {
    const glm::dvec3 scattered_when_clear(0.96, 0.94, 0.92);
    const glm::dvec3 scattered_by_dust(0.90, 0.81, 0.675);  // as in dusty_air()
    const Amounts of = amounts(dust);
    const glm::dvec3 clear = of.clear * power(bands, -exponent);
    Atmosphere air;
    air.mie_height = desert_aerosol::height;
    air.mie_extinction = clear + of.dust;
    air.mie = 1.0;
    air.dust_tint = clear * scattered_when_clear + of.dust * scattered_by_dust;
    air.mie_back = 0.02;
    air.mie_asymmetry = {0.675, 0.69, 0.71};  // 0.65, 0.66 and 0.68 in the mean
    air.ground_albedo = ground_albedo;
    air.follows_directions = true;
    return air;
}

}  // namespace fumon
