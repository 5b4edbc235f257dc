#pragma once

#include <vector>

#include "base/grid.h"

namespace fumon {

/// Fills in the cells of doubly periodic fields whose `unknown` is not 0, as a thin plate in
/// tension through the others: (1 − T)∇⁴f = T∇²f with T = 0.35 (Smith & Wessel 1990), so that value
/// and slope go on from known cells. By relaxation from coarse cells to fine ones: what is left of
/// the equation is nowhere to be seen, and is not zero. Holds what depends on those cells alone,
/// for several fields, also at the same time.
class TensionSurface {
  public:
    explicit TensionSurface(const Mask& unknown);

    /// Leaves a field as it is where nothing is known. The field has the cells of the mask.
    void fill(Grid& field) const;

  private:
    /// Cells side by side in a row, from `first` until before `end`.
    struct Run {
        int y;
        int first;
        int end;
    };
    /// From the given cells to ever coarser ones.
    struct Level {
        Mask unknown;
        std::vector<Run> all;   ///< unknown cells
        std::vector<Run> seam;  ///< those near known ones; empty on levels of few cells
    };

    [[nodiscard]] static Level level_of(Mask unknown);
    static void relax(Grid& field, const std::vector<Run>& chosen, int count);
    static void relax_as_needed(Grid& field, const Level& level);

    std::vector<Level> levels_;  ///< none where nothing is known
};

/// The same of one field.
void fill_in_tension(Grid& field, const Mask& unknown);

/// How far each cell of a doubly periodic lattice is from the nearest one whose `goal` is not 0,
/// cells: along both axes and diagonals (Borgefors 1986). Very large where there is none.
Field<float> distances_to(const Mask& goal);

}  // namespace fumon
