#pragma once

#include <array>

#include "base/grid.h"
#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

class WorkerPool;

/// How much of a saltating stream's wear reaches ground that stands out of it. Grains wear rock in
/// the lowest decimetres to a metre above the ground they hop over (Sharp 1964; Anderson 1986), so
/// that rock that rises steeply is worn at its foot and hardly above.
///
/// The stream's level is the highest surface under the ground that rises by no more than the
/// tangent of 15 degrees from ground upwind and on either side,
///
///     s = min over d ≥ 0 of b(x − d e) + d tan 15°,   e: downwind, to the left, to the right,
///
/// and ground a height z = b − s above it takes the share exp(−z / h) of the wear.
class AbrasionReach {
  public:
    /// `height`: h, m.
    AbrasionReach(const DuneGround& ground, double height, WorkerPool& pool);

    void find(const FixedPointGrid& surface, const BlowingWind& wind);

    /// exp(−z / h), 0 … 1.
    [[nodiscard]] const Grid& share() const { return share_; }

  private:
    double height_;
    WorkerPool& pool_;
    FixedPointGrid below_;  ///< the ground upside down, over which shadows are levels
    WindShadow levels_;
    Grid share_;
};

}  // namespace fumon
