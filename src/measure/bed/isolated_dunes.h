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
    /// Medians over them: heights; across and along the wind, columns' breadths.
    double height_to_width = std::numeric_limits<double>::quiet_NaN();
    double height = std::numeric_limits<double>::quiet_NaN();
    double width = std::numeric_limits<double>::quiet_NaN();
    double length = std::numeric_limits<double>::quiet_NaN();
    /// How far downwind the centroid of the only one's sand lies, columns' breadths from the first
    /// cell's middle; NaN where there is none or several.
    double place = std::numeric_limits<double>::quiet_NaN();
    /// The volume of the second largest over that of the largest; NaN with fewer than two.
    double volume_ratio = std::numeric_limits<double>::quiet_NaN();
};

/// `sand`: its thickness over the hard floor, with cells of dx. Of the pieces thicker than 0.05 of
/// the thickest cell, and with a fifth of its thickness somewhere, one stands alone if what is
/// above 0.6 of its own height hangs together, and what is above 0.3 of it too: dunes that touch
/// or collide have several summits and belong to no one's outline. Its horns are those of its
/// outline at 0.3 of its own height (see Dune::horn_lag), so that small dunes are not cut near
/// their tops; its width and length are the widest extents of the whole piece across and along
/// the wind. Pieces of fewer than 20 cells, and those that wrap round a periodic bed, do not count.
/// NaN without any.
IsolatedDunes isolated_dunes(const Grid& sand, bool periodic, const WindOnGrid& wind);

}  // namespace fumon
