#include "models/water/depth_flux.h"

#include <algorithm>
#include <utility>

#include "base/cancellation.h"
#include "models/shared/padded_grid.h"
#include "models/water/kernels/depth_vectors.h"

namespace fumon {

namespace {

/// faces(1 + x, y) lies between cells x and x + 1, x = −1 … nx − 1.
Grid faces_east(const CarriedDepth& carried, double per_x) {
    const int nx = carried.before.nx();
    const int ny = carried.before.ny();
    Grid faces(nx + 1, ny);
    PaddedGrid depth(nx, 1);
    PaddedGrid speed(nx, 1);
    for (int y = 0; y < ny; ++y) {
        throw_if_cancelled();
        std::copy_n(carried.before.row(y).data(), nx, depth.row(0));
        std::copy_n(carried.u.row(y).data(), nx, speed.row(0));
        depth.wrap(0);
        speed.wrap(0);
        const double* h = depth.row(0) - 1;
        const double* u = speed.row(0) - 1;
        cip::through_faces({h - 1, h, h + 1, h + 2, u, u + 1}, per_x, nx + 1, faces.row(y).data());
    }
    return faces;
}

/// faces(x, y) lies between cells (x, y) and (x, y + 1).
Grid faces_north(const CarriedDepth& carried, double per_y) {
    const int nx = carried.before.nx();
    const int ny = carried.before.ny();
    Grid faces(nx, ny);
    for (int y = 0; y < ny; ++y) {
        throw_if_cancelled();
        const auto row = [&](const Grid& grid, int by) {
            return grid.row((((y + by) % ny) + ny) % ny).data();
        };
        const Grid& h = carried.before;
        cip::through_faces(
            {row(h, -1), row(h, 0), row(h, 1), row(h, 2), row(carried.v, 0), row(carried.v, 1)},
            per_y, nx, faces.row(y).data());
    }
    return faces;
}

}  // namespace

PassedDepth share_depth(const CarriedDepth& carried, double per_x, double per_y, double fallen,
                        Grid& after) {
    constexpr double whole = 1.0 - 0x1p-50;  // so that rounding cannot take more than there is
    const Grid& before = carried.before;
    const int nx = before.nx();
    const int ny = before.ny();
    Grid east = faces_east(carried, per_x);
    Grid north = faces_north(carried, per_y);
    Grid share(nx, ny, 1.0);
    for (int y = 0; y < ny; ++y) {
        throw_if_cancelled();
        for (int x = 0; x < nx; ++x) {
            const double leaving =
                (std::max(east(x + 1, y), 0.0) + std::max(-east(x, y), 0.0)) +
                (std::max(north(x, y), 0.0) + std::max(-north(x, (y + ny - 1) % ny), 0.0));
            const double there = before(x, y) * whole;
            if (leaving > there) share(x, y) = there / leaving;
        }
    }
    for (int y = 0; y < ny; ++y) {
        throw_if_cancelled();
        for (int x = 0; x <= nx; ++x) {
            double& moved = east(x, y);
            const int west = x == 0 ? nx - 1 : x - 1;
            const int east_of_it = x == nx ? 0 : x;
            moved *= share(moved > 0.0 ? west : east_of_it, y);
        }
        for (int x = 0; x < nx; ++x) {
            double& moved = north(x, y);
            moved *= share(x, moved > 0.0 ? y : (y + 1) % ny);
        }
    }
    for (int y = 0; y < ny; ++y) {
        throw_if_cancelled();
        for (int x = 0; x < nx; ++x) {
            const double out =
                (east(x + 1, y) - east(x, y)) + (north(x, y) - north(x, (y + ny - 1) % ny));
            after(x, y) = std::max(before(x, y) - out, 0.0) + fallen;
        }
    }
    return {std::move(east), std::move(north)};
}

}  // namespace fumon
