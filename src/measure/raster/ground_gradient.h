#pragma once

#include "base/grid.h"

namespace fumon {

/// How steep a ground is and to which side: its rise over its length, eastward and northward.
struct GroundGradient {
    Grid x;        ///< dz/dx
    Grid y;        ///< dz/dy
    Mask unknown;  ///< 1 without data and where no neighbour has data
};

/// The gradient after Horn (1981): that of the plane through each cell's own height that fits its
/// eight neighbours best, those along the axes with twice the weight of the diagonal ones. With all
/// eight it is Horn's weighted difference. At the grid's edges, and beside cells without data, the
/// plane is fitted to the neighbours that there are; where these lie on one line through the cell,
/// the ground is taken as level across that line. `ground` in the unit of dx and dy, which need not
/// be equal; `nodata` may be empty.
GroundGradient ground_gradient(const Grid& ground, const Mask& nodata, double dx, double dy);

/// The angle from the horizontal, degrees.
Grid slope_degrees(const GroundGradient& gradient);

/// Tangents of these angles.
Grid slope_ratio(const GroundGradient& gradient);

/// Where the ground faces, down the slope: degrees clockwise from north, from 0 to below 360; 0
/// where it is level.
Grid aspect_degrees(const GroundGradient& gradient);

/// 1 where there is no gradient, or the ground is level, which faces nowhere.
Mask without_aspect(const GroundGradient& gradient);

/// A light from afar: degrees clockwise from north and above the horizon.
struct HillLight {
    double azimuth = 315.0;
    double elevation = 45.0;
    double exaggeration = 1.0;  ///< of heights
};

/// Shaded relief as other programs have it: 1 + 254 cos i with the angle i between the light and
/// the ground's normal (Horn 1981), 1 where the ground faces away. No shadow is cast.
Grid hillshade(const GroundGradient& gradient, const HillLight& light);

}  // namespace fumon
