#include "models/water/courant.h"

#include <algorithm>
#include <cmath>

#include "base/multiversion.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

FUMON_MULTIVERSION
double rate_of_row(const double* h, const double* u, const double* v, double per_x, double per_y,
                   double gravity, int count) {
    double largest[8] = {};
    const double both = per_x + per_y;
    const auto rate = [&](int x) {
        const double depth = h[x] > 0.0 ? h[x] : 0.0;
        return per_x * std::fabs(u[x]) + per_y * std::fabs(v[x]) +
               both * std::sqrt(gravity * depth);
    };
    int x = 0;
    for (; x + 8 <= count; x += 8) {
        for (int k = 0; k < 8; ++k) {
            const double one = rate(x + k);
            largest[k] = one > largest[k] ? one : largest[k];
        }
    }
    for (; x < count; ++x) largest[0] = std::max(largest[0], rate(x));
    return *std::max_element(largest, largest + 8);
}

}  // namespace

double courant_rate(const Water& water, double dx, double dy, double gravity, WorkerPool& pool) {
    const int ny = water.depth.ny();
    std::vector<double> rows(static_cast<std::size_t>(ny));
    pool.for_ranges(ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            rows[static_cast<std::size_t>(y)] = rate_of_row(
                water.depth.row(y).data(), water.velocity_x.row(y).data(),
                water.velocity_y.row(y).data(), 1.0 / dx, 1.0 / dy, gravity, water.depth.nx());
        }
    });
    return *std::max_element(rows.begin(), rows.end());
}

}  // namespace fumon
