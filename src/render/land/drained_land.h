#pragma once

#include <cstdint>

#include "base/grid.h"
#include "render/land/land_relief.h"

namespace fumon {

/// What cells of a surface are to water that is led over it.
enum class LandCell : std::uint8_t {
    free,    ///< its height is chosen
    known,   ///< its height stays, and water runs over it
    outlet,  ///< its height stays, and water leaves there
};

/// Changes the free cells of a surface so that water runs from each of them, and from where known
/// ones spill, down to an outlet or out over the grid's edge: it carves along the way by which a
/// flood would come (priority flood: Barnes, Lehman & Mulla 2014), and fills what lies lower than
/// known cells on that way. Every free cell then has a lower neighbour. `least_fall`: from a cell
/// to the next.
void drain(Grid& heights, const Field<LandCell>& cells, double dx, double dy, double least_fall);

/// The same with valleys that are as wide as valleys are: their sides are no steeper than
/// `steepest`.
void drain_by_valleys(Grid& heights, const Field<LandCell>& cells, double dx, double dy,
                      double least_fall, double steepest);

/// The same for land that leads from heights that stay to others: free land falls from the rims of
/// these no more steeply than `steepest` either.
void drain_between(Grid& heights, const Field<LandCell>& cells, double dx, double dy,
                   double least_fall, double steepest);

/// A periodic tile of land that is drained and as steep as other land is.
struct DrainedTile {
    Grid heights;  ///< over the rivers, which lie level at 0
    Mask rivers;   ///< 1: of one that winds along the tile's edges
};

/// Ridges and valleys that `relief`, a periodic field of any height, begins with: water is routed
/// over it, first on coarse cells, and each place is set as high over the rivers as slopes along
/// the cheapest way to them add up to, each as steep as `slopes` has it for the area that drains
/// there: the steady state of rivers under uplift (Whipple & Tucker 1999). The mean gradient
/// becomes `gradient`. Rivers wander up to `wander` cells aside of the edges.
DrainedTile drained_tile(const Grid& relief, const SlopeByArea& slopes, const LandRelief& wanted,
                         double dx, double dy, double wander);

}  // namespace fumon
