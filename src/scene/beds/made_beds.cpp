#include "scene/beds/made_beds.h"

#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/random.h"

namespace fumon {

Grid noise_bed(BedSize size, std::int64_t seed, double low, double high) {
    Grid bed(size.nx, size.ny);
    const double width = high - low;
    for (int y = 0; y < bed.ny(); ++y) {
        RandomStream stream(static_cast<std::uint64_t>(seed), static_cast<std::uint32_t>(y), 0,
                            Purpose::initial_bed);
        for (double& value : bed.row(y)) value = low + width * stream.uniform();
    }
    return bed;
}

Grid heap_bed(BedSize size, double dx, double dy, double height, double radius) {
    Grid bed(size.nx, size.ny);
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            const double east = dx * (x - 0.5 * (bed.nx() - 1));
            const double north = dy * (y - 0.5 * (bed.ny() - 1));
            const double share = std::sqrt(east * east + north * north) / radius;
            if (share >= 1.0) continue;
            const double cosine = elementary::cos(0.5 * std::numbers::pi * share);
            bed(x, y) = height * cosine * cosine;
        }
    }
    return bed;
}

}  // namespace fumon
