#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "base/snapshot.h"

namespace fumon {

/// Where water runs from each cell of a surface. Cells are numbered as in memory: y·nx + x.
struct FlowRouting {
    static constexpr std::int32_t outlet = -1;

    Grid level;                        ///< the surface, its hollows filled to their brim
    Field<std::int32_t> receiver;      ///< the next cell downstream; `outlet`: out of the domain
    std::vector<std::int32_t> upward;  ///< cells with data; each comes after its receiver
    double dx = 1.0;
    double dy = 1.0;

    /// From a cell's centre to its receiver's; 0 at an outlet.
    [[nodiscard]] double length(std::int32_t cell) const;
    /// How far the filled surface falls over that length; 0 at an outlet.
    [[nodiscard]] double fall(std::int32_t cell) const;
};

/// Single-direction routing (D8: O'Callaghan & Mark 1984) on the surface whose hollows are filled
/// (priority flood: Barnes, Lehman & Mulla 2014). Each cell drains to the steepest lower one of its
/// eight neighbours and, in a filled hollow, along the way by which the flood came; so every cell
/// drains. Water leaves at the edges of the grid and at cells without data (1 in `nodata`, which
/// may be empty). With `wraps_x` the western and eastern edges are one. Equal levels are flooded in
/// the order of their discovery, and of equal slopes the first counterclockwise from east is taken,
/// those along the axes before the diagonals: the same surface gives the same routing anywhere.
FlowRouting route_flow(const Grid& level, const Mask& nodata, double dx, double dy,
                       bool wraps_x = false);

/// The area that drains through each cell, its own included, in the unit of dx·dy; 0 without data.
Grid drainage_area(const FlowRouting& routing);

/// The ground of a snapshot in the unit of its scale, with the plane on which the model's bed lies
/// (mean_slope toward -y, mean_slope_x toward +x).
Grid ground_of(const Snapshot& snapshot);

/// Whether the western and eastern edges of a snapshot are one for water that runs over the ground:
/// a periodic bed on a plane that descends straight down the map.
bool wraps_across(const Snapshot& snapshot);

/// The routing over a snapshot's ground; edges that are not one are open.
FlowRouting route_flow(const Snapshot& snapshot);

}  // namespace fumon
