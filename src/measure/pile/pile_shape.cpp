#include "measure/pile/pile_shape.h"

#include <algorithm>
#include <cmath>

#include "base/elementary_angle.h"
#include "base/units.h"

namespace fumon {

namespace {

double azimuth(double east, double north) {
    if (east == 0.0 && north == 0.0) return ConeFit::none;
    const double degrees = degrees_per_radian * elementary::atan2(east, north);
    const double positive = degrees < 0.0 ? degrees + 360.0 : degrees;
    return positive < 360.0 ? positive : 0.0;  // a hair west of north rounds to a full turn
}

/// Of the covered cells; `count` of them.
double axis_ratio(const Grid& bed, std::int64_t count) {
    const auto cells = static_cast<double>(count);
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            if (!(bed(x, y) > 0.0)) continue;
            mean_x += x;
            mean_y += y;
        }
    }
    mean_x /= cells;
    mean_y /= cells;
    double xx = 0.0;
    double yy = 0.0;
    double xy = 0.0;
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            if (!(bed(x, y) > 0.0)) continue;
            xx += (x - mean_x) * (x - mean_x);
            yy += (y - mean_y) * (y - mean_y);
            xy += (x - mean_x) * (y - mean_y);
        }
    }
    constexpr double of_a_square = 1.0 / 12.0;  // second moment of a unit square about its middle
    xx = xx / cells + of_a_square;
    yy = yy / cells + of_a_square;
    xy /= cells;
    const double middle = 0.5 * (xx + yy);
    const double apart = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
    return std::sqrt((middle - apart) / (middle + apart));
}

}  // namespace

PileShape pile_shape(const Grid& bed, BedPoint drop) {
    PileShape shape;
    for (const double height : bed.values()) {
        shape.largest_height = std::max(shape.largest_height, height);
        shape.resident_grains += height;
        if (height > 0.0) ++shape.covered_cells;
    }
    if (shape.covered_cells == 0) return shape;
    shape.axis_ratio = axis_ratio(bed, shape.covered_cells);
    shape.drop_cone = cone_at(bed, drop);
    shape.cone = free_cone(bed);
    const double east = shape.cone.apex.x - drop.x;
    const double north = shape.cone.apex.y - drop.y;
    shape.offset = std::sqrt(east * east + north * north);
    if (shape.offset >= 0.0) shape.offset_azimuth = azimuth(east, north);
    return shape;
}

}  // namespace fumon
