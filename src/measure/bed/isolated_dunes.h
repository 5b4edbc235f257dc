#pragma once

#include <cstdint>
#include <limits>

#include "base/grid.h"
#include "measure/bed/dunes.h"

namespace fumon {

/// The dunes of a bed that stand alone.
struct IsolatedDunes {
    std::int64_t count = 0;
    double share_horns_downwind = std::numeric_limits<double>::quiet_NaN();
    double height_to_width = std::numeric_limits<double>::quiet_NaN();  ///< median over them
};

/// `sand`: its thickness over the hard floor, with cells of dx. Of the pieces thicker than 0.05 of
/// the thickest cell, and with a fifth of its thickness somewhere, one stands alone if what is
/// above 0.6 of its own height hangs together, and what is above 0.3 of it too: dunes that touch
/// or collide have several summits and belong to no one's outline. Its horns are those of its
/// outline at 0.3 of its own height (see Dune::horn_lag), so that small dunes are not cut near
/// their tops; its width is the widest extent across the wind of the whole piece. Pieces of fewer
/// than 20 cells, and those that wrap round a periodic bed, do not count. NaN without any.
IsolatedDunes isolated_dunes(const Grid& sand, bool periodic, const WindOnGrid& wind);

}  // namespace fumon
