#pragma once

#include <string>
#include <vector>

#include "base/grid.h"
#include "base/snapshot.h"
#include "models/water/gully_parameters.h"
#include "models/water/shallow_water.h"

namespace fumon {

/// Gauges in the water, each some numbers of a snapshot, whose names end in their unit:
///
///   a point   NAME_depth_m, NAME_level_m (of the surface over the bed's zero; the bed where dry),
///             NAME_unit_discharge_m2s = h |u|, of the cell in which it lies
///   a line    NAME_discharge_m3s = ∫ h u·n dl from its left to its right end, n to the left of
///             that way: positive downstream. Each piece of the line has the water of the cell in
///             which it lies; cells without data have none
///   a side    NAME_discharge_m3s = Σ h u·n of the cells along it, n outward
class Gauges {
  public:
    /// Throws KeyError, of the gauge's key, where a name is none or there twice, a place lies
    /// outside the grid or its data, or both or neither of point and side are said.
    Gauges(const GullyParameters& parameters, const WaterDomain& domain, const WorldScale& scale,
           int nx, int ny);

    /// What the gauges read, in their order; `bed` in metres.
    [[nodiscard]] std::vector<SnapshotNumber> read(const Water& water, const Grid& bed) const;

  private:
    /// h u·n times a length, in a cell.
    struct Crossing {
        int x = 0;
        int y = 0;
        double width_x = 0.0;  ///< m: n_x times the length
        double width_y = 0.0;
    };
    struct Gauge {
        std::string name;
        int x = 0;  ///< of a point
        int y = 0;
        std::vector<Crossing> crossings;  ///< of a line or side; empty: a point
    };

    [[nodiscard]] std::vector<Crossing> along(int nx, int ny, double from_x, double from_y,
                                              double to_x, double to_y) const;
    [[nodiscard]] std::vector<Crossing> over(GaugeSide side, int nx, int ny) const;

    const WaterDomain& domain_;
    std::vector<Gauge> gauges_;
};

}  // namespace fumon
