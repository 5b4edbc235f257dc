#pragma once

#include <limits>

#include "base/grid.h"

namespace fumon {

/// Water that is deeper than this counts as wet, metres.
inline constexpr double wet_depth = 1e-5;

/// Shallow water's fields, nx × ny each: depth in metres, velocities in m/s.
struct WaterFields {
    const Grid& depth;
    const Grid& velocity_x;
    const Grid& velocity_y;
};

/// How water flows, over the cells with data; those of wet cells are NaN where all is dry.
struct WaterFlow {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    /// Through a cross-section, for each metre of its width: the mean over all cross-sections along
    /// x of −h·v, positive toward −y, m²/s.
    double downslope_flux = none;
    double mean_flux = none;              ///< of h·|u|, whichever way, m²/s
    double largest_flux = none;           ///< of a cell, m²/s
    double mean_speed = none;             ///< of the wet cells, m/s
    double largest_speed = none;          ///< of the wet cells, m/s
    double mean_froude_number = none;     ///< of |u|/√(g h) over the wet cells
    double largest_froude_number = none;  ///< of the wet cells
    double wet_share = none;              ///< of the cells
    double supercritical_share = none;    ///< of the wet cells: Froude number above 1
};

/// `gravity` in m/s².
WaterFlow water_flow(const WaterFields& water, const Mask& nodata, double gravity);

}  // namespace fumon
