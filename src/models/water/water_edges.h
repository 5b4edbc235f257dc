#pragma once

#include <array>
#include <vector>

#include "base/grid.h"
#include "models/water/edge_flow.h"
#include "models/water/shallow_water.h"

namespace fumon {

/// Where the cell at `index`, possibly beyond the edges, takes its values from.
struct CellSource {
    int index = 0;
    bool mirrored = false;
    bool outside = false;
};

inline CellSource source_of(int index, int count, EdgeKind edges) {
    if (index >= 0 && index < count) return {index, false, false};
    if (edges == EdgeKind::open) return {0, false, true};
    if (edges == EdgeKind::wall) {
        const int twice = 2 * count;
        const int folded = ((index % twice) + twice) % twice;
        if (folded < count) return {folded, false, false};
        return {twice - 1 - folded, true, false};
    }
    return {((index % count) + count) % count, false, false};
}

/// What is beyond a cell at the grid's edge: nothing (a wall), a fall (open), the other side
/// (periodic) or, where a stretch says so, a discharge or a level.
class WaterEdges {
  public:
    /// Keeps a reference to the domain.
    WaterEdges(const WaterDomain& domain, int nx, int ny);

    /// Whether cells of that side differ from the side's own kind.
    [[nodiscard]] bool has_segments(GridSide side) const { return !kinds_[number(side)].empty(); }
    /// Whether water is given at that cell of a side.
    [[nodiscard]] bool flows(GridSide side, int cell) const {
        return has_segments(side) && kinds_[number(side)][static_cast<std::size_t>(cell)] >= 0;
    }
    /// The kind of a cell of a side where it does not flow there.
    [[nodiscard]] EdgeKind kind(GridSide side, int cell) const;
    [[nodiscard]] bool any_flow() const { return any_flow_; }

    /// Takes the discharges and levels of a time, s.
    void set_time(double time);
    /// Through the edge at a cell where flows(side, cell).
    [[nodiscard]] EdgeFlux flux(GridSide side, int cell, const EdgeWater& inside,
                                double gravity) const;

  private:
    static std::size_t number(GridSide side) { return static_cast<std::size_t>(side); }

    static constexpr int wall_cell = -1;
    static constexpr int same_as_side = -2;

    const WaterDomain& domain_;
    bool any_flow_ = false;
    /// Of each side's cells: the number of a stretch with flow, or one of those above; or empty.
    std::array<std::vector<int>, 4> kinds_;
    std::vector<double> values_;  ///< of each stretch now: m²/s inward, or a level, m (−∞: a fall)
};

/// The sub-step, s, at which what comes in over the edges at a time, over this bed, has Courant
/// number 1.
double edge_step_at_courant_one(const WaterDomain& domain, double time, const Grid& bed,
                                double gravity);

}  // namespace fumon
