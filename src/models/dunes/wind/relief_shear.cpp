#include "models/dunes/wind/relief_shear.h"

#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

/// Of what is taken from waves that the grid does not resolve: half a cell.
constexpr double smoothed_cells = 0.5;

/// By which slopes raise the threshold of transport, μ of Gadal et al. (2019).
constexpr double threshold_slope = 0.63;

}  // namespace

ReliefShear::ReliefShear(const DuneGround& ground, double in_phase, double ahead, WorkerPool& pool)
    : in_phase_(in_phase),
      ahead_(ahead),
      filter_(ground, pool),
      smoothing_x_(gaussian_of_modes(filter_.transformed().nx, smoothed_cells)),
      smoothing_y_(gaussian_of_modes(filter_.transformed().ny, smoothed_cells)) {}

double ReliefShear::scale(const GroundFilter::Wave& wave) const {
    const double length = std::sqrt(wave.kx * wave.kx + wave.ky * wave.ky);
    return length > 0.0 ? smoothing_x_[static_cast<std::size_t>(wave.m)] *
                              smoothing_y_[static_cast<std::size_t>(wave.n)] / length
                        : 0.0;
}

void ReliefShear::apply(Grid& plane, const BlowingWind& wind) {
    if (wind.threshold > 0.0) {
        const double over = 1.0 / (1.0 - wind.threshold);
        const double by_slope = wind.threshold / threshold_slope;
        filter_.apply(plane, [&](const GroundFilter::Wave& wave) {
            const double of_wave = scale(wave);
            const double along = wave.kx * wind.x + wave.ky * wind.y;
            const double length = std::sqrt(wave.kx * wave.kx + wave.ky * wave.ky);
            const double ahead = ahead_ * std::abs(along) - by_slope * length;
            return GroundFilter::Response{over * in_phase_ * of_wave * along * along,
                                          over * of_wave * along * ahead};
        });
        return;
    }
    filter_.apply(plane, [&](const GroundFilter::Wave& wave) {
        const double of_wave = scale(wave);
        const double along = wave.kx * wind.x + wave.ky * wind.y;
        return GroundFilter::Response{in_phase_ * of_wave * along * along,
                                      ahead_ * of_wave * along * std::abs(along)};
    });
}

void ReliefShear::apply_across(Grid& plane, const BlowingWind& wind, double across) {
    filter_.apply(plane, [&](const GroundFilter::Wave& wave) {
        const double along = wave.kx * wind.x + wave.ky * wind.y;
        const double aside = wave.ky * wind.x - wave.kx * wind.y;
        return GroundFilter::Response{across * scale(wave) * along * aside, 0.0};
    });
}

}  // namespace fumon
