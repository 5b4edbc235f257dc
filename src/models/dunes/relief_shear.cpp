#include "models/dunes/relief_shear.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/elementary.h"

namespace fumon {

namespace {

/// What is left of the modes of a row of `count` cells.
std::vector<double> smoothing(int count) {
    std::vector<double> kept(static_cast<std::size_t>(count) / 2 + 1);
    for (std::size_t mode = 0; mode < kept.size(); ++mode) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(mode) / count;
        kept[mode] = elementary::exp(-angle * angle / 8.0);
    }
    return kept;
}

}  // namespace

ReliefShear::ReliefShear(const DuneGround& ground, double in_phase, double ahead, WorkerPool& pool)
    : ground_(ground),
      in_phase_(in_phase),
      ahead_(ahead),
      filter_(ground.nx, ground.ny, pool),
      smoothing_x_(smoothing(ground.nx)),
      smoothing_y_(smoothing(ground.ny)) {}

void ReliefShear::apply(Grid& plane, const BlowingWind& wind) {
    const double unit_x = 2.0 * std::numbers::pi / (ground_.nx * ground_.dx);
    const double unit_y = 2.0 * std::numbers::pi / (ground_.ny * ground_.dy);
    filter_.apply(
        plane, [&](int n, std::span<double> real, std::span<double> imaginary,
                   std::span<double> mirrored_real, std::span<double> mirrored_imaginary) {
            const double ky = unit_y * n;
            const double smoothing_y = smoothing_y_[static_cast<std::size_t>(n)];
            for (std::size_t m = 0; m < real.size(); ++m) {
                const double kx = unit_x * static_cast<double>(m);
                const double length = std::sqrt(kx * kx + ky * ky);
                const double scale = length > 0.0 ? smoothing_x_[m] * smoothing_y / length : 0.0;
                const double along = kx * wind.x + ky * wind.y;
                const double mirrored = ky * wind.y - kx * wind.x;
                real[m] = in_phase_ * scale * along * along;
                imaginary[m] = ahead_ * scale * along * std::abs(along);
                mirrored_real[m] = in_phase_ * scale * mirrored * mirrored;
                mirrored_imaginary[m] = ahead_ * scale * mirrored * std::abs(mirrored);
            }
        });
}

}  // namespace fumon
