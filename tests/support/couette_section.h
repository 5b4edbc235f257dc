#pragma once

#include <cmath>
#include <functional>

#include "base/snapshot.h"

namespace fumon::test {

/// Air that is sheared linearly from rest at the bed to `lid_speed` at the lid, over a bed of any
/// shape.
inline SnapshotSection couette_section(int nx, int nz, double spacing, double lid_speed,
                                       const std::function<double(double x)>& bed,
                                       double viscous_density = 1.3 * 1.5e-5) {
    SnapshotSection section;
    section.dx = spacing;
    section.dz = spacing;
    SnapshotField velocity_x{"velocity_x", "", "m/s", Grid(nx, nz)};
    const SnapshotField velocity_z{"velocity_z", "", "m/s", Grid(nx, nz)};
    SectionCurve height{"bed_height", "", "m", {}};
    SectionCurve stress{"bed_shear_stress", "", "Pa", {}};
    const double lid = (nz - 1) * spacing;
    for (int i = 0; i < nx; ++i) {
        const double ground = bed(i * spacing);
        const double shear = lid_speed / (lid - ground);
        height.values.push_back(ground);
        stress.values.push_back(viscous_density * shear);
        for (int k = 0; k < nz; ++k) {
            const double above = k * spacing - ground;
            velocity_x.values(i, k) = above > 0.0 ? shear * above : 0.0;
        }
    }
    section.fields = {velocity_x, velocity_z};
    section.curves = {height, stress};
    return section;
}

}  // namespace fumon::test
