#include "measure/air/eddy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fumon {

namespace {

/// Of each column, how far above the bed its highest node lies that flows back; 0 without any.
std::vector<double> backflow_heights(const Grid& velocity_x, const ProfileUnderAir& bed,
                                     double dz) {
    double fastest = 0.0;
    for (const double u : velocity_x.values()) fastest = std::max(fastest, std::abs(u));
    constexpr double rounding = 1e-9;
    const double threshold = -rounding * fastest;
    std::vector<double> heights(bed.heights.size(), 0.0);
    for (int k = 0; k < velocity_x.ny(); ++k) {
        const auto row = velocity_x.row(k);
        for (std::size_t i = 0; i < heights.size(); ++i) {
            if (k >= bed.lowest_air[i] && row[i] < threshold) heights[i] = k * dz - bed.heights[i];
        }
    }
    return heights;
}

}  // namespace

Eddy largest_eddy(const Grid& velocity_x, const ProfileUnderAir& bed, double dx, double dz) {
    const std::vector<double> heights = backflow_heights(velocity_x, bed, dz);
    const std::size_t count = heights.size();
    const auto still = std::ranges::find(heights, 0.0);
    const auto start =
        static_cast<std::size_t>(still == heights.end() ? 0 : still - heights.begin());
    Eddy largest;
    int longest = 0;
    int columns = 0;
    double top = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double height = heights[(start + i) % count];
        columns = height > 0.0 ? columns + 1 : 0;
        top = height > 0.0 ? std::max(top, height) : 0.0;
        if (columns <= longest) continue;
        longest = columns;
        largest = {columns * dx, top};
    }
    return largest;
}

}  // namespace fumon
