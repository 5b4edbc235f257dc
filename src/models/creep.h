#pragma once

#include <span>
#include <vector>

#include "terrain/grid.h"

namespace fumon {

/// Creep of every cell (Sudo 2002, eq. 3; Nishimori & Ouchi 1993), for one row of a periodic bed:
///
///     h' = h + D·( (1/6)·Σ 4 nearest + (1/12)·Σ 4 diagonal − h ),   0 < D ≤ 3/4
///
/// All rows hold nx heights; `after` may be none of the others.
void creep_row(std::span<const double> south, std::span<const double> here,
               std::span<const double> north, double rate, std::span<double> after);

/// Creep as in the program of Sudo (2002, appendix A): in place, row after row from y = 0 and from
/// x = 0, each cell that is strictly higher than its 8 neighbours at that moment gives D·h away, a
/// sixth of it to each side and a twelfth to each corner. Exactly sequential, but a vectorised look
/// ahead finds the cells worth a visit.
class MaximaCreep {
  public:
    void operator()(Grid& bed, double rate);

  private:
    std::vector<double> sides_;   ///< the larger of the cells south and north
    std::vector<double> column_;  ///< the largest of south, here and north
    std::vector<unsigned char>
        peaks_;  ///< 1 where the cell was a strict maximum when its row began
};

}  // namespace fumon
