#pragma once

#include <limits>

#include "base/grid.h"

namespace fumon {

/// A place on the bed in cells; whole numbers are the middles of cells.
struct BedPoint {
    double x = 0.0;
    double y = 0.0;
};

/// The cone h = height − slope · r, r being the distance from its apex in cells. Not a number
/// throughout where no cone can be fitted.
struct ConeFit {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    BedPoint apex{none, none};
    double height = none;     ///< at the apex, heights
    double slope = none;      ///< heights per cell; negative for a bowl
    double angle = none;      ///< arctangent of the slope, degrees, heights taken as tall as cells
    double r_squared = none;  ///< 1 − residual sum of squares / sum of squares about the mean
};

/// The best cone with its apex at a given point: linear least squares of h over r through the
/// covered cells (h > 0), each of the same weight.
///
/// Only covered cells count because bare ground says nothing of the pile's slope, and would make
/// the fit depend on the size of the box. So R² compares shapes only: a small pile far from the
/// point may still fit well. Not a number for fewer than 3 covered cells, for covered cells all of
/// one height (a plateau) or all at one distance.
ConeFit cone_at(const Grid& bed, BedPoint apex);

/// The best cone wherever its apex lies on the bed, over the same cells: Levenberg's (1944) and
/// Marquardt's (1963) damped Gauss–Newton steps for the apex, height and slope solved for anew at
/// each, from the centroid of the heights. Exact cones are found to 1e-7 cells, also where
/// the edge cuts them off.
///
/// Not a number as for `cone_at`, for fewer than 5 covered cells, and where the best apex lies
/// outside the bed: a tilted plane is a cone with its apex far away. A pile with several summits
/// gets one of several possible apices.
ConeFit free_cone(const Grid& bed);

}  // namespace fumon
