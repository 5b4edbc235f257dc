#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "base/random.h"
#include "base/worker_pool.h"
#include "models/water/finite_volume_scheme.h"

namespace fumon {

/// A grid of f(x, y), x and y whole.
inline Grid grid_of(int nx, int ny, const std::function<double(int, int)>& f) {
    Grid grid(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) grid(x, y) = f(x, y);
    }
    return grid;
}

/// Uniform numbers in [0, height).
inline Grid noise(int nx, int ny, double height, std::uint64_t seed = 1) {
    Grid grid(nx, ny);
    for (int y = 0; y < ny; ++y) {
        RandomStream stream(seed, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& value : grid.row(y)) value = height * stream.uniform();
    }
    return grid;
}

inline GullyParameters without_friction() {
    GullyParameters parameters;
    parameters.friction_coefficient = 0.0;
    return parameters;
}

inline Water still(const Grid& depth) {
    return {depth, Grid(depth.nx(), depth.ny()), Grid(depth.nx(), depth.ny())};
}

/// Water that fills a bed up to a level.
inline Water lake(const Grid& bed, double level) {
    return still(grid_of(bed.nx(), bed.ny(),
                         [&](int x, int y) { return std::max(0.0, level - bed(x, y)); }));
}

inline double lowest(const Grid& grid) {
    return *std::min_element(grid.values().begin(), grid.values().end());
}

inline double fastest(const Water& water) {
    double most = 0.0;
    for (std::size_t i = 0; i < water.depth.size(); ++i) {
        const double speed = std::hypot(water.velocity_x.values()[i], water.velocity_y.values()[i]);
        if (!(speed <= most)) most = speed;
    }
    return most;
}

/// Steps at a Courant number until `duration` seconds have passed; returns how many.
inline int run_for(ShallowWaterScheme& scheme, Water& water, const Grid& bed, double duration,
                   double courant_number = 0.45, double rain = 0.0, double longest = 1e9) {
    int steps = 0;
    for (double time = 0.0; time < duration; ++steps) {
        const double dt = std::min(
            {courant_number * scheme.step_at_courant_one(water), duration - time, longest});
        scheme.advance(water, bed, dt, rain);
        time += dt;
    }
    return steps;
}

}  // namespace fumon
