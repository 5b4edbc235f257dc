#pragma once

#include "models/water/kernels/finite_volume_vectors.h"

namespace fumon::finite_volume {

/// By how much half slopes may pass what the limiter allows: `share` of the depth, for velocities
/// of √(g h).
struct LimiterTolerance {
    double share = 0.0;
    double gravity = 9.8;  ///< m/s²
};

/// Monotonised central slopes (van Leer 1977) of `count` cells between their neighbours `back` and
/// `forward`; flat toward a neighbour outside the domain. Where the water is thinner than
/// the bed's steps, depth and surface take the smaller of the two differences (minmod), so that no
/// two cells' beds overlap at a face and dam the water up. The bed's own slope is minmod's.
/// Elsewhere slopes may pass the limit by the tolerance (as in total variation bounded schemes, Shu
/// 1987, Math. Comput. 49): the limiter otherwise keeps ripples standing in calm flow.
void limited_half_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                         const LimiterTolerance& tolerance, const HalfSlopes& out, int count);

}  // namespace fumon::finite_volume
