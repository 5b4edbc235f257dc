#pragma once

#include <span>
#include <vector>

namespace fumon {

/// The places (sites, refined by a parabola, ascending) of the maxima of a row from which it falls
/// by at least `fall` on both sides before it rises higher, written to `crests`. Periodic rows are
/// gone round from their lowest site, so that no crest is lost at the edge; else a maximum at
/// either end is none. Of a flat top the first site counts. Needs fall > 0, else finds none.
void find_row_crests(std::span<const double> row, bool periodic, double fall,
                     std::vector<double>& crests);

}  // namespace fumon
