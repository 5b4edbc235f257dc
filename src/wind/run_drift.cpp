#include "wind/run_drift.h"

#include "base/elementary_angle.h"
#include "base/units.h"
#include "wind/direction.h"

namespace fumon {

std::vector<SandFlux> fluxes_of(std::span<const SnapshotWind> winds) {
    std::vector<SandFlux> fluxes;
    for (const SnapshotWind& wind : winds) {
        const double toward = elementary::atan2(wind.x, wind.y) * degrees_per_radian;
        fluxes.push_back({toward < 0.0 ? toward + full_turn : toward, wind.drift});
    }
    return fluxes;
}

}  // namespace fumon
