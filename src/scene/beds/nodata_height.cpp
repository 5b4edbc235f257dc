#include "scene/beds/nodata_height.h"

namespace fumon {

std::int64_t take_out_height(Terrain& terrain, double value) {
    std::int64_t cells = 0;
    const double of_file = value * terrain.metres_per_number;
    const bool masked = !terrain.nodata.empty();
    for (std::size_t cell = 0; cell < terrain.heights.size(); ++cell) {
        double& height = terrain.heights.values()[cell];
        if ((height != value && height != of_file) ||
            (masked && terrain.nodata.values()[cell] != 0))
            continue;
        if (terrain.nodata.empty())
            terrain.nodata = Mask(terrain.heights.nx(), terrain.heights.ny());
        terrain.nodata.values()[cell] = 1;
        height = 0.0;
        ++cells;
    }
    return cells;
}

}  // namespace fumon
