#pragma once

#include "models/water/kernels/finite_volume_vectors.h"

namespace fumon::finite_volume {

/// How steep half slopes may be.
struct SlopeLimits {
    double tolerance = 0.0;  ///< by how much they may pass: of the depth, for velocities of √(g h)
    double gravity = 9.8;    ///< m/s²
    double steepness = 2.0;    ///< over the smaller one-sided difference: 1 (minmod) to 2
    bool even_shores = false;  ///< velocities have none where the water is as thin as at a shore
};

/// Slopes of `count` cells between their neighbours `back` and `forward`, the central one within
/// θ times the one-sided ones (van Leer 1977; θ = 2: monotonised central); flat toward a neighbour
/// outside the domain. Where the water is thinner than
/// the bed's steps, depth and surface take the smaller of the two differences (minmod), so that no
/// two cells' beds overlap at a face and dam the water up. The bed's own slope is minmod's.
/// Elsewhere slopes may pass the limit by the tolerance (as in total variation bounded schemes, Shu
/// 1987, Math. Comput. 49): the limiter otherwise keeps ripples standing in calm flow.
void limited_half_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                         const SlopeLimits& limits, const HalfSlopes& out, int count);

}  // namespace fumon::finite_volume
