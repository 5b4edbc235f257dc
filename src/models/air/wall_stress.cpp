#include "models/air/wall_stress.h"

#include <cmath>
#include <cstddef>

namespace fumon {

std::vector<double> staircase_stress(const AirPlane& plane, std::span<const double> u,
                                     std::span<const double> w, double dynamic_viscosity) {
    const auto height = [&](int i) {
        return plane.height[static_cast<std::size_t>(i)] / plane.spacing;
    };
    std::vector<double> stress;
    for (int i = 0; i < plane.nx; ++i) {
        const int left = plane.left(i);
        const int right = plane.right(i);
        const int k = static_cast<int>(std::ceil(height(i) - on_bed_tolerance));
        const bool left_free = height(left) <= k + on_bed_tolerance;
        const bool right_free = height(right) <= k + on_bed_tolerance;
        const double here = w[plane.at(i, k)];
        const double rise =
            (right_free ? w[plane.at(right, k)] : here) - (left_free ? w[plane.at(left, k)] : here);
        const double at_node = u[plane.at(i, k + 1)] - u[plane.at(i, k)] +
                               (left_free && right_free ? 0.5 * rise : rise);
        const double above = 0.5 * (u[plane.at(i, k + 2)] - u[plane.at(i, k)] +
                                    w[plane.at(right, k + 1)] - w[plane.at(left, k + 1)]);
        stress.push_back(dynamic_viscosity / plane.spacing *
                         (at_node + (height(i) - k) * (above - at_node)));
    }
    return stress;
}

}  // namespace fumon
