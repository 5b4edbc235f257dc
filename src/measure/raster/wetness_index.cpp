#include "measure/raster/wetness_index.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"

namespace fumon {

Grid wetness_index(const FlowRouting& routing, const Grid& slope) {
    Grid index = drainage_area(routing);
    const double width = std::sqrt(routing.dx * routing.dy);
    for (std::size_t cell = 0; cell < index.size(); ++cell) {
        double& value = index.values()[cell];
        if (value == 0.0) continue;
        const double steepness = std::max(slope.values()[cell], least_wetness_slope);
        value = elementary::log(value / width / steepness);
    }
    return index;
}

}  // namespace fumon
