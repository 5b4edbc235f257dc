#pragma once

#include <span>

namespace fumon {

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

}  // namespace fumon
