#include "measure/water/water_flow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fumon {

WaterFlow water_flow(const WaterFields& water, const Mask& nodata, double gravity) {
    WaterFlow flow;
    double cells = 0.0;
    double wet = 0.0;
    double supercritical = 0.0;
    double downslope = 0.0;
    double flux = 0.0;
    double largest_flux = 0.0;
    double speed = 0.0;
    double largest_speed = 0.0;
    double froude = 0.0;
    double largest_froude = 0.0;
    for (std::size_t cell = 0; cell < water.depth.size(); ++cell) {
        if (!nodata.empty() && nodata.values()[cell] != 0) continue;
        const double h = water.depth.values()[cell];
        const double u = water.velocity_x.values()[cell];
        const double v = water.velocity_y.values()[cell];
        const double of_cell = std::sqrt(u * u + v * v);
        cells += 1.0;
        downslope -= h * v;
        flux += h * of_cell;
        largest_flux = std::max(largest_flux, h * of_cell);
        if (!(h > wet_depth)) continue;
        const double number = of_cell / std::sqrt(gravity * h);
        wet += 1.0;
        speed += of_cell;
        largest_speed = std::max(largest_speed, of_cell);
        froude += number;
        largest_froude = std::max(largest_froude, number);
        supercritical += number > 1.0 ? 1.0 : 0.0;
    }
    if (cells == 0.0) return flow;
    flow.downslope_flux = downslope / cells;
    flow.mean_flux = flux / cells;
    flow.largest_flux = largest_flux;
    flow.wet_share = wet / cells;
    if (wet == 0.0) return flow;
    flow.mean_speed = speed / wet;
    flow.largest_speed = largest_speed;
    flow.mean_froude_number = froude / wet;
    flow.largest_froude_number = largest_froude;
    flow.supercritical_share = supercritical / wet;
    return flow;
}

}  // namespace fumon
