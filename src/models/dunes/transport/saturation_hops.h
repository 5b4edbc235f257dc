#pragma once

#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

/// Hops of continuous transport that give the drift its saturation length ℓ,
/// model.saturation_length:
///
///     ∂q/∂x = (q_sat − q) / ℓ
///
/// Sand in the air moves by `length`. Of what arrives over sand, the share `landing` ends its hop,
/// and p of that share stays: P = landing p in all. The rest moves on, `moves` times in a step, so
/// that too little sand is in the air between steps to delay the bed. HopSpread spreads each
/// arrival over 3 × 3 cells with the variance D² v. The drift then follows a change of the wind
/// over
///
///     ℓ = length (2 − P) / (2 P) + D² v / (2 length)
///
/// D is the length of a cell along the wind. The landing share keeps P at 0.35 or less: up to
/// there the approach to saturation is exponential within 1 %. `length` follows from ℓ. Where a
/// move reaches half a cell, v is ¼, as of HopSpread's spline; else v = f (1 − f), f = length / D,
/// the least variance for which no share is negative, whatever the wind's direction.
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
/// which hops of 1 m, the default before version 0.3, saturate in cells of a metre. For slabs and
/// for hops of one length: model.hop_length divided by model.deposit_on_sand, by which their time
/// steps are chosen (they saturate over another length, see continuous_transport.h).
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
