#pragma once

#include "base/grid.h"

namespace fumon {

/// Where the sun stands for a sweep over a lattice.
struct SunDirection {
    float east = 0.0F;  ///< horizontal unit vector towards the sun
    float north = 1.0F;
    float lower_limb = 0.4F;  ///< tangent of the elevation of the disc's lowest point
    float upper_limb = 0.5F;  ///< tangent of the elevation of its highest point
};

/// The share of the sun's disc seen from every cell, 0 (umbra) … 1, by one sweep away from the sun.
///
/// Along each ray the heights that the shadows of the disc's two limbs reach are carried from one
/// lattice line to the next, S ← max(S, z) − step·tan(limb), each with the width of the penumbra of
/// the place that casts it. Between S_upper and S_lower of one such place a cell sees the share
/// (z − S_upper) / (S_lower − S_upper) of the disc; the least over the two limbs' places counts.
/// O(cells).
///
/// `heights`, `dx` and `dy` are in one unit of length. Beyond the border nothing casts shadow.
Field<float> sun_visibility(const Field<float>& heights, float dx, float dy,
                            const SunDirection& sun);

}  // namespace fumon
