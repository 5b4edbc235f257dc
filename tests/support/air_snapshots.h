#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "base/snapshot.h"
#include "files/netcdf/netcdf_fields.h"

/// Snapshots of air over a bed of one row, other in every value at every step.
namespace fumon::test {

inline const FieldsText air_text{"air over a ripple", "seed = 3\n[model]\nname = \"airflow\"\n", 3};
inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

inline double speed(std::int64_t step, int i, int k) {
    return 10.0 * k + 0.5 * i + static_cast<double>(step);
}

/// Lands later with each step: 2 + step points.
inline GrainPath path(std::int64_t step, double angle) {
    GrainPath made{angle, {}, {}};
    for (int n = 0; n < 2 + step; ++n) {
        made.x.push_back(0.1 * n + angle);
        made.z.push_back(0.01 * n * n);
    }
    return made;
}

inline SnapshotSection section(std::int64_t step, int nx = 5, int nz = 4) {
    SnapshotSection made;
    made.dx = 0.25;
    made.dz = 0.125;
    SnapshotField along{"velocity_x", "velocity of the air along x", "m/s", Grid(nx, nz)};
    SnapshotField pressure{"pressure", "pressure of the air", "Pa", Grid(nx, nz)};
    for (int k = 0; k < nz; ++k) {
        for (int i = 0; i < nx; ++i) {
            along.values(i, k) = speed(step, i, k);
            pressure.values(i, k) = -speed(step, i, k);
        }
    }
    made.fields = {along, pressure};
    SectionCurve bed{"bed_height", "height of the bed", "m", {}};
    SectionCurve flight{"flight_length_12.5", "flight length", "m", {}};
    for (int i = 0; i < nx; ++i) {
        bed.values.push_back(0.01 * i);
        flight.values.push_back(i == 2 ? missing : 0.1 * i + static_cast<double>(step));
    }
    made.curves = {bed, flight};
    made.paths = {path(step, 10.0), path(2 * step, 40.0)};
    return made;
}

inline Snapshot air_snapshot(std::int64_t step, const SnapshotSection& section) {
    Snapshot made;
    made.step = step;
    made.time = 0.1 * static_cast<double>(step);
    made.time_unit = "s";
    made.scale = {section.dx, section.dx, 1.0, true};
    made.periodic = true;
    made.bed = Grid(section.fields.front().values.nx(), 1, 0.02);
    made.numbers = {{"lid_speed", "m/s", 0.5}, {"hop_base", "per mm", 1.5}};
    made.section = std::make_shared<const SnapshotSection>(section);
    return made;
}

inline Snapshot air_snapshot(std::int64_t step) {
    return air_snapshot(step, section(step));
}

}  // namespace fumon::test
