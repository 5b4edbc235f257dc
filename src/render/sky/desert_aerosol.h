#pragma once

#include <glm/glm.hpp>

#include "render/sky/atmosphere.h"

namespace fumon {

/// The lowest air of a desert: what blurs far dunes is what whitens the sky above the horizon.
///
/// On a clear day (`dust` = 1) one sees 30 km far, somewhat farther than the 23 km of the standard
/// atmospheres' clear rural air. The aerosol lies shallow over the ground, as it does while the sun
/// is low, of an optical depth of 0.07 in all. It dims blue light
/// more than red, λ^−0.7 (Ångström 1929; about 0.2 where coarse dust prevails, 1.3 without any).
/// Dust over 1 is coarse: grey in what it dims, and yellow as it absorbs blue light.
namespace desert_aerosol {

inline constexpr double clear_visibility = 30.0;  ///< km, at 550 nm
inline constexpr double height = 0.6;             ///< km, over which it thins by e

/// Of air, per km, where contrast falls to 2 % within so many km (Koschmieder 1924).
double extinction_of_visibility(double kilometres);

/// How far one sees along the ground, km.
double visibility(double dust);

/// Extinction of air near the ground, per km, of the red, green and blue of linear sRGB: of
/// molecules (Rayleigh) and of as much aerosol as leaves a visibility, in km, in green light. The
/// part of the aerosol that `dust` has over 1 is grey.
glm::dvec3 extinction(double visibility, double dust);

/// Extinction along the way from a height in km down to the ground, against that along the ground:
/// (1 − exp(−u)) / u with u = height over desert_aerosol::height, 0.3 % too small at u = 1.
double thinner_from(double eye_height);

}  // namespace desert_aerosol

/// The Earth's air over a desert. Single-scattering albedo is that of AERONET's stations in deserts
/// (Dubovik et al. 2002: Solar Village), the phase function that of the background desert aerosol
/// of d'Almeida, Koepke & Shettle (1991, as the code 6S tabulates it) within an eighth.
Atmosphere desert_air(double dust, const glm::dvec3& ground_albedo);

}  // namespace fumon
