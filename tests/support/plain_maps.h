#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/snapshot.h"
#include "base/worker_pool.h"
#include "render/view/surrounding_plain.h"

namespace fumon {

inline constexpr int bed_nx = 60;
inline constexpr int bed_ny = 40;

/// The maps of a bed in its plain, with what is known of where it lies.
struct PlainMaps {
    explicit PlainMaps(const Snapshot& bed, int workers = 1, std::optional<double> sea = {})
        : pool(workers), plain(bed, pool, sea), maps(plain.around(bed, pool)) {
        nx = maps.bed.nx() / 2;
        ny = maps.bed.ny();
        west = (nx - bed.bed.nx()) / 2;
        south = (ny - bed.bed.ny()) / 2;
    }

    WorkerPool pool;
    SurroundingPlain plain;
    Snapshot maps;
    int nx = 0;
    int ny = 0;
    int west = 0;
    int south = 0;
};

/// A valley that descends southward between ridges, with a step of relief across.
inline Snapshot valley() {
    Snapshot land;
    land.landform = Landform::terrain;
    land.bed = Grid(bed_nx, bed_ny);
    land.scale.dx = land.scale.dy = 10.0;
    land.scale.in_metres = true;
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 0; x < bed_nx; ++x)
            land.bed(x, y) = 1.5 * y + 3.0 * std::abs(x - 30.0 - 4.0 * std::sin(0.3 * y)) +
                             5.0 * std::sin(0.5 * x) * std::sin(0.4 * y + 0.2 * x);
    return land;
}

/// The largest step from a cell to its eastern neighbour, of the cells from (x0, y0) until before
/// (x1, y1).
inline double largest_step(const Grid& field, int x0, int x1, int y0, int y1) {
    double most = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            most = std::max(most, std::abs(field(x + 1, y) - field(x, y)));
    return most;
}

}  // namespace fumon
