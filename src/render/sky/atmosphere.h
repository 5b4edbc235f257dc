#pragma once

#include <glm/glm.hpp>

namespace fumon {

/// g of what aerosol scatters backward.
inline constexpr double back_asymmetry = -0.6;

/// What air does to light along each kilometre, in red, green and blue.
struct AirOptics {
    glm::dvec3 rayleigh{0.0};        ///< scattered by molecules
    glm::dvec3 mie{0.0};             ///< scattered by aerosol
    glm::dvec3 mie_extinction{0.0};  ///< scattered and absorbed by aerosol
    glm::dvec3 absorption{0.0};      ///< by ozone

    [[nodiscard]] glm::dvec3 extinction() const { return rayleigh + mie_extinction + absorption; }
    [[nodiscard]] glm::dvec3 scattering() const { return rayleigh + mie; }
};

/// A planet's air: Rayleigh scattering, aerosol and ozone, the first two thinning exponentially
/// with height. Lengths in kilometres, coefficients per kilometre in linear sRGB. The defaults are
/// the Earth's of Hillaire (2020).
struct Atmosphere {
    double ground = 6360.0;  ///< radius
    double top = 6460.0;     ///< radius
    glm::dvec3 rayleigh{0.005802, 0.013558, 0.033100};
    double rayleigh_height = 8.0;
    double mie = 0.003996;
    glm::dvec3 mie_extinction{0.004440};
    double mie_height = 1.2;
    glm::dvec3 mie_asymmetry{0.8};  ///< g, of forward scattering
    double mie_back = 0.0;          ///< share of it that is scattered backward, by back_asymmetry
    glm::dvec3 dust_tint{1.0};      ///< of what aerosol scatters
    glm::dvec3 ozone{0.000650, 0.001881, 0.000085};
    double ozone_lowest = 10.0;  ///< the ozone's layer is a tent
    double ozone_middle = 25.0;
    double ozone_highest = 40.0;
    glm::dvec3 ground_albedo{0.3};
    /// Light scattered more than once is followed by its direction (ScatteredLight); else taken as
    /// isotropic (Hillaire).
    bool follows_directions = false;

    /// At a height above the ground, in km.
    [[nodiscard]] AirOptics optics(double height) const;
};

/// The Earth's air with `dust` times its aerosol, over 1 tinted as desert dust, which absorbs blue
/// light more than red.
Atmosphere dusty_air(double dust, const glm::dvec3& ground_albedo);

/// The air of Mars with `dust` times its usual optical depth of 0.5 (Lemmon et al. 2015): carbon
/// dioxide at 6 mbar, and fine dust that absorbs blue light and scatters it more forward (Tomasko
/// et al. 1999), so that a low sun stands in a blue glow.
Atmosphere martian_air(double dust, const glm::dvec3& ground_albedo);

/// How far a ray travels within the air, and whether it ends on the ground. `radius`: of the point
/// from which it leaves; `up`: the cosine of its zenith angle there.
struct RayEnd {
    double distance = 0.0;
    bool on_ground = false;
};
RayEnd end_of_ray(const Atmosphere& air, double radius, double up);

/// The radius, and the cosine of the zenith angle, at a distance along a ray.
struct RayPoint {
    double radius = 0.0;
    double up = 0.0;
};
RayPoint along_ray(double radius, double up, double distance);

/// Phase functions, per steradian, of the cosine of the angle between light and view.
double rayleigh_phase(double cosine);
/// Cornette & Shanks (1992).
double mie_phase(double cosine, double asymmetry);
/// Henyey & Greenstein (1941).
double henyey_greenstein(double cosine, double asymmetry);
/// Of an air's aerosol in one band: Cornette & Shanks', or, where it has a lobe backward, that of
/// two lobes of Henyey & Greenstein (Kattawar 1975).
double aerosol_phase(const Atmosphere& air, int band, double cosine);

}  // namespace fumon
