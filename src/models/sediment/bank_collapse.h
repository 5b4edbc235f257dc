#pragma once

#include "models/avalanche/slope_relaxation.h"
#include "models/sediment/load_ground.h"

namespace fumon {

/// Banks that fall where they are steeper than the angle of repose: the avalanches of
/// SlopeRelaxation on the bed with its mean plane. What slides is exact, in units of 2⁻³² m.
/// Nothing slides over an edge that is not periodic, nor over one that the mean plane steps at, nor
/// into cells without data.
class BankCollapse {
  public:
    /// `floor` is what does not slide, a departure from the mean plane, or empty. It refers to
    /// `ground`.
    BankCollapse(const LoadGround& ground, double repose_angle, const Grid& floor,
                 WorkerPool& pool);

    /// Moves what slides, in passes up to a number that leaves longer avalanches to the next call.
    void fail(Grid& bed);

  private:
    const LoadGround& ground_;
    const Grid& rock_;
    WorkerPool& pool_;
    SlopeRelaxation slopes_;
    FixedPointGrid before_;
    FixedPointGrid surface_;
    FixedPointGrid floor_;
};

}  // namespace fumon
