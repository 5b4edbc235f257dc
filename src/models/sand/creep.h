#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"

namespace fumon {

class WorkerPool;

/// The largest rate D for which the creep of every cell is valid (Terada 2024, eq. 13).
inline constexpr double highest_every_cell_creep_rate = 0.75;

/// Creep of every cell (Sudo 2002, eq. 3; Nishimori & Ouchi 1993), for one row of a periodic bed:
///
///     h' = h + D·( (1/6)·Σ 4 nearest + (1/12)·Σ 4 diagonal − h )
///
/// where D, the rate, is above 0 and at most highest_every_cell_creep_rate. All rows hold nx
/// heights; `after` may be none of the others.
void creep_row(std::span<const double> south, std::span<const double> here,
               std::span<const double> north, double rate, std::span<double> after);

/// Creep as in the program of Sudo (2002, appendix A): in place, row after row from y = 0 and from
/// x = 0, each cell that is strictly higher than its 8 neighbours at that moment gives D·h away, a
/// sixth of it to each side and a twelfth to each corner. Exactly sequential; but threads mark the
/// maxima of the bed before, and only those and the surroundings of cells that gave are visited.
class MaximaCreep {
  public:
    void operator()(Grid& bed, double rate, WorkerPool& pool);

  private:
    void mark(const Grid& bed, WorkerPool& pool);
    void mark_around(int x, int y, int reach);

    int nx_ = 0;
    int ny_ = 0;
    std::size_t words_ = 0;             ///< of 64 cells, in a row
    std::vector<std::uint64_t> marks_;  ///< a bit for each cell that is to be visited
};

}  // namespace fumon
