#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// How steep land is where an area drains through it: the mean fall to the next cell downstream, of
/// cells in bins of a factor of two in drained area (slope–area relation: Flint 1974). Areas beyond
/// the largest bin fall off as area^−0.45, as graded rivers do on average.
class SlopeByArea {
  public:
    /// Of a surface, its hollows filled; cells with 1 in `nodata`, which may be empty, left out.
    SlopeByArea(const Grid& heights, const Mask& nodata, double dx, double dy);

    [[nodiscard]] double at(double area) const;
    /// Of cells into which nothing drains.
    [[nodiscard]] double hillslope() const { return slopes_.empty() ? 0.0 : slopes_.front(); }

  private:
    double cell_;                 ///< area
    std::vector<double> slopes_;  ///< at cell_ · 2^k
};

/// The mean magnitude of a surface's gradient, by central differences over cells whose neighbours
/// have data; 0 where there is none.
double mean_gradient(const Grid& heights, const Mask& nodata, double dx, double dy);

/// How steep and how rough land is.
struct LandRelief {
    double gradient = 0.0;  ///< mean_gradient()
    double roughness =
        0.0;  ///< the mean change of slope from cell to cell along both axes, over it
};

LandRelief relief_of(const Grid& heights, const Mask& nodata, double dx, double dy);

/// What cells of a surface are to water that is led over it.
enum class LandCell : std::uint8_t {
    free,    ///< its height is chosen
    known,   ///< its height stays, and water runs over it
    wall,    ///< the same, and no valley is carved towards it
    outlet,  ///< its height stays, and water leaves there
};

/// Changes the free cells of a surface so that water runs from each of them, and from where known
/// ones and walls spill, down to an outlet: below those it carves, along the way by which a flood
/// would come (priority flood: Barnes, Lehman & Mulla 2014), and elsewhere it fills. Every free
/// cell then has a lower neighbour. Outlets lie lower than all others that stay, by more than all
/// falls along a way. `least_fall`: from a cell to the next.
void drain(Grid& heights, const Field<LandCell>& cells, double dx, double dy, double least_fall);

/// The same for land that leads from heights that stay to others. Free land falls from these no
/// more steeply than `steepest`, and beside valleys that are carved no more steeply than that, or
/// than it did, so that they are as wide as valleys are.
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
