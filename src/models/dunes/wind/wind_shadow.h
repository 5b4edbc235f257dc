#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/grid.h"
#include "models/dunes/setup/dune_ground.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/shared/fixed_point_lengths.h"

namespace fumon {

class WorkerPool;
struct RowTraversal;

/// Angles of a wind shadow as tangents. Where they are the same, the shadow has a hard edge.
struct ShadowTangents {
    double soft = 0.0;
    double full = 0.0;
};

/// The wind shadow: how far ground upwind keeps the wind off. From every point upwind a surface
/// falls downwind at the full angle; ground below it is in shadow (1). Above that the shadow
/// decreases linearly with the tangent under which the ground looks up to the crest whose surface
/// at the soft angle is the highest there, to 0 at the soft angle.
///
/// Lines along the wind, a cell apart across it, go over the ground side by side, with heights
/// linear between cells; a cell takes what the two lines beside it find. Lines are independent of
/// one another, so threads share them. In a periodic bed they begin as far upwind as a shadow can
/// reach, at most one time round.
class WindShadow {
  public:
    WindShadow(const DuneGround& ground, WorkerPool& pool);

    enum class Find { shade, shade_and_envelope };

    void cast(const FixedPointGrid& surface, const BlowingWind& wind,
              const ShadowTangents& tangents, Find find);

    /// 0 … 1.
    [[nodiscard]] const Grid& shade() const { return shade_; }
    /// Where it was asked for, the bed with its separation bubbles: the higher of the bed and the
    /// surface that falls at the full angle. Metres.
    [[nodiscard]] const Grid& envelope() const { return envelope_; }
    /// Swaps it with a grid of the ground's size, which the next shadow writes over.
    void swap_envelope(Grid& grid) { std::swap(envelope_, grid); }

  private:
    /// Rows before the first from which a shadow can reach it.
    int rows_of_reach(const FixedPointGrid& surface, const RowTraversal& traversal,
                      const ShadowTangents& tangents);
    void follow_lines(const FixedPointGrid& surface, const RowTraversal& traversal,
                      const ShadowTangents& tangents, Find find, int first, int last);

    DuneGround ground_;
    WorkerPool& pool_;
    Grid shade_;
    Grid envelope_;
    int rows_before_ = 0;
    std::vector<std::int64_t> lowest_;   ///< of each row
    std::vector<std::int64_t> highest_;  ///< of each row
};

}  // namespace fumon
