#pragma once

#include <span>
#include <vector>

#include "wind/wind_rose.h"

namespace fumon {

/// What all winds move together.
struct Drift {
    double potential = 0.0;  ///< the sum of all fluxes (DP, where they are vector units)
    double resultant = 0.0;  ///< the length of their vector sum (RDP)
    double toward = 0.0;     ///< where that points, degrees clockwise from north; NaN for none
};

Drift drift_of(std::span<const SandFlux> fluxes);

/// Along which dunes' crests run under several winds. Directions in degrees clockwise from north;
/// several where they are equally favoured, none where all are (a rose of equal winds from all
/// sides, or no sand that moves).
struct CrestDirections {
    /// Of crests, from 0 up to 180: where the gross transport across them, Σ Q |sin(θ − α)|, is
    /// largest (Rubin & Hunter 1987).
    std::vector<double> gross_normal_transport{};
    /// Of crests on a bed all of sand: where Σ Q (|sin(θ − α)| + γ sin²(θ − α)), by which they
    /// grow, is largest (Courrech du Pont, Narteau & Gao 2014, bed instability).
    std::vector<double> bed_instability{};
    /// Toward which dunes on a ground with little sand grow longer, from 0 up to 360: where Σ Q (1
    /// + γ |sin(θ − α)|) has no part across and the largest along (the same, fingering).
    std::vector<double> fingering{};
};

/// γ of real dunes (Gao et al. 2015).
inline constexpr double flux_ratio_of_dunes = 1.6;

/// `flux_ratio`: γ, how much more sand moves over a crest that lies across the wind than over flat
/// ground; 1.6 fits dunes (Gao et al. 2015).
CrestDirections crest_directions(std::span<const SandFlux> fluxes, double flux_ratio);

}  // namespace fumon
