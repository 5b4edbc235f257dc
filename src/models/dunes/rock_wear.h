#pragma once

#include <optional>

#include "base/grid.h"
#include "models/dunes/abrasion_reach.h"
#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

class WorkerPool;

/// Rock that becomes sand. Sand that lands on it wears
///
///     c q (1 + 5 m) (1 − t / 0.05 m) (1 − ρ)
///
/// away, where q is the thickness that lands, m the slope of the floor along the wind, t the sand
/// at rest on it and ρ the plants' cover, none of the factors less than 0: grains come down at a
/// slope of about a fifth (Bagnold 1941: 10 to 16 degrees), so that ground that faces the wind
/// takes more of them and lee slopes none. What is worn off is in the air. Rock under less than 5
/// cm of sand that is steeper than its angle of repose, by the one-sided slope of SlopeRelaxation,
/// crumbles: a quarter of the excess fall to its lowest neighbour becomes sand where it is.
///
/// With a height of abrasion h the wear by sand is also multiplied by exp(−z / h), z the height
/// above the stream (AbrasionReach), and m is taken from the cell before, since the wear of slopes
/// that face the wind drives them downwind. Hills are then worn at their feet, in front 1 + 5 m
/// times as much as on their flanks, the plain between them is lowered, and rock that their wind
/// shadows shelter stays as a tail behind them: yardangs.
///
/// A share of what is worn off or crumbles is dust, which is in suspension and counted as outflow;
/// soft rock is mostly silt. What is worn off is counted in DuneBed::worn to the last unit.
class RockWear {
  public:
    struct Rule {
        double share = 0.0;    ///< c
        double tangent = 1.0;  ///< of the rock's angle of repose
        double height = 0.0;   ///< h of AbrasionReach, m; 0: the same wear at any height
        double dust = 0.0;     ///< of what is worn off
    };

    RockWear(const DuneGround& ground, const Rule& rule, WorkerPool& pool);

    /// `landed`: what has come down in each cell in this step, of which the part `ended` ended a
    /// hop there. `cover`: of plants, or null.
    void wear(DuneBed& bed, const BlowingWind& wind, const FixedPointGrid& landed, double ended,
              const Grid* cover);

  private:
    /// The floor beside a cell.
    struct Around {
        std::int64_t west;
        std::int64_t east;
        std::int64_t south;
        std::int64_t north;
    };

    [[nodiscard]] Around around(int x, int y) const;
    [[nodiscard]] std::int64_t crumbles(std::int64_t here, const Around& rock) const;
    [[nodiscard]] double slope_along(const BlowingWind& wind, const Around& rock) const;
    [[nodiscard]] double slope_before(const BlowingWind& wind, std::int64_t here,
                                      const Around& rock) const;

    DuneGround ground_;
    Rule rule_;
    WorkerPool& pool_;
    std::optional<AbrasionReach> reach_;
    FixedPointGrid before_;  ///< the rock before
    FixedPointGrid worn_of_row_;
    FixedPointGrid dust_of_row_;
};

}  // namespace fumon
