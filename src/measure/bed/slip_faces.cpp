#include "measure/bed/slip_faces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/elementary_angle.h"
#include "base/units.h"

namespace fumon {

SlipFaces slip_faces(const Grid& bed, const Grid& shadow, bool periodic, double dx, double dy) {
    constexpr double full = 0.99;
    constexpr double least = 20.0;  // degrees
    const int nx = bed.nx();
    const int ny = bed.ny();
    std::vector<double> angles;
    for (int y = 0; y < ny; ++y) {
        const bool at_side = y == 0 || y == ny - 1;
        if (at_side && !periodic) continue;
        const auto south = bed.row(y == 0 ? ny - 1 : y - 1);
        const auto north = bed.row(y == ny - 1 ? 0 : y + 1);
        for (int x = periodic ? 0 : 1; x < (periodic ? nx : nx - 1); ++x) {
            if (shadow(x, y) < full) continue;
            const auto here = static_cast<std::size_t>(x);
            const double along = bed((x + 1) % nx, y) - bed((x + nx - 1) % nx, y);
            const double slope_x = along / (2.0 * dx);
            const double slope_y = (north[here] - south[here]) / (2.0 * dy);
            const double slope = std::sqrt(slope_x * slope_x + slope_y * slope_y);
            const double angle = elementary::atan(slope) * degrees_per_radian;
            if (angle >= least) angles.push_back(angle);
        }
    }
    SlipFaces faces;
    if (angles.empty()) return faces;
    faces.cover = static_cast<double>(angles.size()) / static_cast<double>(bed.size());
    const auto middle = angles.begin() + static_cast<std::ptrdiff_t>((angles.size() - 1) / 2);
    std::nth_element(angles.begin(), middle, angles.end());
    faces.angle = *middle;
    return faces;
}

}  // namespace fumon
