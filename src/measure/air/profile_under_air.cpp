#include "measure/air/profile_under_air.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "measure/bed/row_spectrum.h"
#include "numerics/stress_fit.h"

namespace fumon {

namespace {

int lowest_node_above(double height, double dz, int nodes) {
    constexpr double tolerance = 1e-6;  // of dz: a node on the bed belongs to it
    int k = 0;
    while (k < nodes && !(k * dz > height + tolerance * dz)) ++k;
    return k;
}

}  // namespace

double ProfileUnderAir::from_crest(double x) const {
    return std::remainder(x - crest, wavelength);
}

ProfileUnderAir profile_under_air(const Snapshot& snapshot, int nodes) {
    ProfileUnderAir bed;
    const SnapshotSection& section = *snapshot.section;
    for (const double height : snapshot.bed.row(0)) {
        bed.heights.push_back(height * snapshot.scale.height_unit);
        bed.lowest_air.push_back(lowest_node_above(bed.heights.back(), section.dz, nodes));
    }
    const auto [lowest, highest] = std::ranges::minmax(bed.heights);
    constexpr double rounding = 1e-9;
    if (!(highest - lowest > rounding * std::max(std::abs(lowest), std::abs(highest)))) return bed;
    const std::vector<double> power = power_along_x(snapshot.bed, true);
    if (power.size() < 3) return bed;
    const auto strongest = std::max_element(power.begin() + 1, power.end());
    const int waves = static_cast<int>(strongest - power.begin());
    const StressFit wave = fit_stress(bed.heights, waves);
    if (!std::isfinite(wave.phase)) return bed;
    const double width = section.dx * static_cast<double>(bed.heights.size());
    bed.waves = waves;
    bed.wavelength = width / waves;
    bed.phase = wave.phase;
    const double crest = -wave.phase / (2.0 * std::numbers::pi) * bed.wavelength;
    bed.crest = crest < 0.0 ? crest + bed.wavelength : crest;
    return bed;
}

}  // namespace fumon
