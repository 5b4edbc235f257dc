#pragma once

#include <cmath>
#include <memory>

#include "base/snapshot.h"

namespace fumon {

/// Air over a bed of cosine ripples, 1 m long and 0.3 m high: faster with height, with a closed
/// eddy at x = 0.5 m, z = 0.06 m, in the trough, and two grains' paths.
inline Snapshot eddy_section(int nx = 96, int nz = 64) {
    Snapshot snapshot;
    const double dx = 1.0 / nx;
    const double dz = 0.3 / (nz - 1);
    const double pi = 3.14159265358979323846;
    snapshot.bed = Grid(nx, 1);
    snapshot.scale = {dx, dx, 1.0, true};
    snapshot.periodic = true;
    auto section = std::make_shared<SnapshotSection>();
    section->dx = dx;
    section->dz = dz;
    section->fields = {{"velocity_x", "", "m/s", Grid(nx, nz)},
                       {"velocity_z", "", "m/s", Grid(nx, nz)}};
    for (int i = 0; i < nx; ++i) {
        const double x = i * dx;
        snapshot.bed(i, 0) = 0.02 + 0.02 * std::cos(2.0 * pi * x);
        for (int k = 0; k < nz; ++k) {
            const double z = k * dz;
            if (z <= snapshot.bed(i, 0)) continue;
            const double r2 = std::pow((x - 0.5) / 0.12, 2) + std::pow((z - 0.06) / 0.04, 2);
            const double swirl = 6.0 * std::exp(-r2);
            section->fields[0].values(i, k) = 8.0 * z + swirl * (z - 0.06) / 0.04;
            section->fields[1].values(i, k) = -swirl * (x - 0.5) / 0.36;
        }
    }
    for (const double from : {0.1, 0.55}) {
        GrainPath path;
        for (int i = 0; i <= 20; ++i) {
            path.x.push_back(from + 0.3 * i / 20);
            path.z.push_back(0.04 + 0.1 * std::sin(pi * i / 20));
        }
        section->paths.push_back(path);
    }
    snapshot.section = section;
    return snapshot;
}

}  // namespace fumon
