#pragma once

#include "models/water/kernels/finite_volume_vectors.h"

namespace fumon::finite_volume {

/// Puts other half slopes of depth and surface, in place of limited ones, where a shore lies within
/// a cell: beyond it the bed rises above the cell's water and holds none, or a film of less than
/// three tenths of it; on the other side the water is deeper and the bed no higher (else it would
/// fall into a pit, which has no shore). The depth falls on at the rate of the wet side and ends
/// within the cell where that uses up its water (after the partly wet cells of Bollermann et al.
/// 2013, J. Sci. Comput. 56, here of each direction by itself): a share w of the cell is wet,
///
///     h = m w²/2,   h_in = m (w + ½),   so w = r + √(r² + r) with r = h/h_in,
///
/// with h_in the depth at the middle of the next cell inside and m what the depth falls by over a
/// cell. Such half slopes are larger than the depth, and face_fluxes takes a negative depth for
/// dry. The surface goes on as inside. In a partly wet cell bed plus mean depth lies above the
/// water's plane, by m (1 − w)²/2: that is taken off, but no more than the velocity head
/// u²/(2g), so that lakes at rest which are given by the depths at the cells' middles stay at rest.
/// In dry cells the surface is the bed.
void shore_half_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                       double gravity, const HalfSlopes& out, int count);

}  // namespace fumon::finite_volume
