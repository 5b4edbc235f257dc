#pragma once

#include "base/grid.h"

namespace fumon {

/// Where the sun stands for a sweep over a lattice.
struct SunDirection {
    float east = 0.0F;  ///< horizontal unit vector towards the sun
    float north = 1.0F;
    float lower_limb = 0.4F;  ///< tangent of the elevation of the disc's lowest point
    float upper_limb = 0.5F;  ///< tangent of the elevation of its highest point

    friend bool operator==(const SunDirection&, const SunDirection&) = default;
};

/// Between which bounds shares are kept. Beyond 0 … 1 they say how far a point lies inside the
/// umbra or outside the penumbra, in widths of the penumbra: interpolated, they find a shadow's
/// edge inside a cell.
struct ShareBounds {
    float lowest = 0.0F;
    float highest = 1.0F;
};

/// What lies beyond a lattice: nothing that casts shadow, or its other side.
enum class LatticeBorder { open, periodic };

/// The share of the sun's disc seen from every cell, 0 (umbra) … 1, by one sweep away from the sun.
///
/// Along each ray the heights that the shadows of the disc's two limbs reach are carried from one
/// lattice line to the next, S ← max(S, z) − step·tan(limb), each with the width of the penumbra of
/// the point that casts it. Between S_upper and S_lower of one such point a cell sees the share
/// (z − S_upper) / (S_lower − S_upper) of the disc; the least over the two limbs' points counts.
/// O(cells).
///
/// `heights`, `dx` and `dy` are in one unit of length. Over a periodic lattice the sweep begins as
/// far away as a shadow may reach, but at most four periods, and goes on until what comes in on one
/// side is what goes out on the other, so that it does not depend on where the lattice begins; but
/// not where the disc's lowest point is below the horizon, whose shadows do not end.
Field<float> sun_visibility(const Field<float>& heights, float dx, float dy,
                            const SunDirection& sun, const ShareBounds& bounds = {},
                            LatticeBorder border = LatticeBorder::open);

}  // namespace fumon
