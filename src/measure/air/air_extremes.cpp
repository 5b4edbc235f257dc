#include "measure/air/air_extremes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

bool above(const ProfileUnderAir& bed, int i, int k) {
    return k >= bed.lowest_air[static_cast<std::size_t>(i)];
}

}  // namespace

AirExtremes air_extremes(const Grid& velocity_x, const Grid& velocity_z, const ProfileUnderAir& bed,
                         double dx, double dz) {
    AirExtremes flow;
    const int nx = velocity_x.nx();
    const int nz = velocity_x.ny();
    for (int k = 0; k < nz; ++k) {
        for (int i = 0; i < nx; ++i) {
            if (!above(bed, i, k)) continue;
            const double u = velocity_x(i, k);
            const double w = velocity_z(i, k);
            flow.largest_speed = std::max(flow.largest_speed, std::sqrt(u * u + w * w));
            const int west = (i + nx - 1) % nx;
            const int east = (i + 1) % nx;
            if (k + 1 >= nz || !above(bed, i, k - 1) || !above(bed, west, k) ||
                !above(bed, east, k))
                continue;
            const double divergence = (velocity_x(east, k) - velocity_x(west, k)) / (2.0 * dx) +
                                      (velocity_z(i, k + 1) - velocity_z(i, k - 1)) / (2.0 * dz);
            flow.largest_divergence = std::max(flow.largest_divergence, std::abs(divergence));
        }
    }
    return flow;
}

BedPressureExtremes bed_pressure(const Grid& pressure, const ProfileUnderAir& bed, double dx) {
    BedPressureExtremes found;
    for (int i = 0; i < pressure.nx(); ++i) {
        const int k = bed.lowest_air[static_cast<std::size_t>(i)];
        if (k >= pressure.ny()) continue;
        const double here = pressure(i, k);
        const double from_crest = bed.from_crest(i * dx);
        if (!(here <= found.highest)) {
            found.highest = here;
            found.highest_from_crest = from_crest;
        }
        if (!(here >= found.lowest)) {
            found.lowest = here;
            found.lowest_from_crest = from_crest;
        }
    }
    return found;
}

}  // namespace fumon
