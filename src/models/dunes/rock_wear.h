#pragma once

#include "base/grid.h"
#include "models/dunes/dune_bed.h"
#include "models/dunes/wind_shadow.h"
#include "models/dunes/wind_turns.h"

namespace fumon {

class WorkerPool;

/// Rock that becomes sand. Sand that lands on it wears
///
///     c q (1 + 5 m) (1 − t / 0.05 m) (1 − ρ)
///
/// away, where q is the thickness that lands, m the slope of the floor along the wind, t the sand
/// at rest on it and ρ the plants' cover, none of the factors less than 0: grains come down at a
/// slope of about a fifth (Bagnold 1941: 10 to 16 degrees), so that ground that faces the wind
/// takes more of them and lee slopes none. What is worn off is in the air. Rock steeper than its
/// angle of repose, by the one-sided slope of SlopeRelaxation, crumbles: a quarter of the excess
/// fall to its lowest neighbour becomes sand where it is.
///
/// What is worn off is counted in DuneBed::worn to the last unit.
class RockWear {
  public:
    /// `share`: c. `tangent`: of the rock's angle of repose.
    RockWear(const DuneGround& ground, double share, double tangent, WorkerPool& pool);

    /// `landed`: what has come down in each cell in this step. `cover`: of plants, or null.
    void wear(DuneBed& bed, const BlowingWind& wind, const WholeGrid& landed, const Grid* cover);

  private:
    [[nodiscard]] std::int64_t crumbles(int x, int y) const;
    [[nodiscard]] double slope_along(const BlowingWind& wind, int x, int y) const;
    [[nodiscard]] std::int64_t before_at(int x, int y) const;

    DuneGround ground_;
    double share_;
    double tangent_;
    WorkerPool& pool_;
    WholeGrid before_;  ///< the rock before
    WholeGrid worn_of_row_;
};

}  // namespace fumon
