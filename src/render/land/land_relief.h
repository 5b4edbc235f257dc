#pragma once

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

/// The mean change of slope from cell to cell, along both axes together; likewise.
double mean_bend(const Grid& heights, const Mask& nodata, double dx, double dy);

/// How steep and how rough land is.
struct LandRelief {
    double gradient = 0.0;   ///< mean_gradient()
    double roughness = 0.0;  ///< mean_bend() over it
};

LandRelief relief_of(const Grid& heights, const Mask& nodata, double dx, double dy);

}  // namespace fumon
