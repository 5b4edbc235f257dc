#pragma once

#include "models/dunes/dunes_parameters.h"
#include "models/dunes/wind_shadow.h"

namespace fumon {

/// Hops of continuous transport that give the drift its saturation length ℓ,
/// model.saturation_length:
///
///     ∂q/∂x = (q_sat − q) / ℓ
///
/// Sand in the air moves by `length`, and of what arrives the share `landing` ends its hop there,
/// of which p stays, so that P = landing p of what arrives over sand. What stays in the air moves
/// on, `moves` times in a step: so little sand is in the air between steps that it does not delay
/// the bed. Sand that is spread over 3 × 3 cells with the variance D² v follows a change of the
/// wind by
///
///     ℓ = length (2 − P) / (2 P) + D² v / (2 length)
///
/// The landing share keeps P at 0.35 or less, for which the approach to saturation is exponential
/// within 1 %, and `length` follows. v is that of HopSpread's spline, ¼, where a move reaches half
/// a cell, else f (1 − f), f = length / D, the least that no direction of the wind makes negative.
/// D is the length of a cell along the wind.
struct SaturationHops {
    double length = 1.0;     ///< m, of a move
    double landing = 1.0;    ///< of what arrives
    int moves = 1;           ///< in a step
    double spread_x = 0.25;  ///< v along x, in cells²
    double spread_y = 0.25;
    double kept = 1.0;  ///< sand in the air between steps over flat sand, in parts of q Δt / length
    double ends = 1.0;  ///< hops that end per arrival, of hops whose mean length is p ℓ
};

/// The saturation length, metres. "auto" is 1.3 m, or a cell where that is more: the length over
/// which hops of 1 m, the former default, saturate in cells of a metre. Of slabs and of hops of one
/// length it is model.hop_length divided by model.deposit_on_sand, by which their time steps are
/// chosen.
double saturation_length(const DunesParameters& parameters, const DuneGround& ground);

/// Whether hops follow from a saturation length.
bool hops_saturate(const DunesParameters& parameters);

/// The hops under a wind that blows along a unit vector. `parameters` were checked.
SaturationHops saturation_hops(const DunesParameters& parameters, const DuneGround& ground,
                               double wind_x, double wind_y);

/// Throws KeyError for a saturation length that the grid cannot resolve, and for hops that follow
/// from it and are told too.
void check_saturation(const DunesParameters& parameters, const DuneGround& ground);

}  // namespace fumon
