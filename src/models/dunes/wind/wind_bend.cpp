#include "models/dunes/wind/wind_bend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include "base/error.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

/// Nothing linear holds of a stress across the wind that is as strong as the wind's.
constexpr double greatest_stress_across = 1.0;

/// The cells before and after one, of which those beyond an open edge are the cell itself.
struct Beside {
    int before;
    int after;
    double apart;  ///< cells
};

Beside beside(int cell, int count, bool periodic) {
    int before = cell - 1;
    int after = cell + 1;
    if (before < 0) before = periodic ? count - 1 : cell;
    if (after >= count) after = periodic ? 0 : cell;
    const bool at_edge = !periodic && (cell == 0 || cell + 1 == count);
    return {before, after, at_edge ? 1.0 : 2.0};
}

}  // namespace

void turn_by_stress(const Grid& across, const BlowingWind& wind, WorkerPool& pool, BentWind& bent) {
    pool.for_ranges(across.ny(), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const auto stress = across.row(y);
            for (std::size_t x = 0; x < stress.size(); ++x) {
                const double aside =
                    std::clamp(stress[x], -greatest_stress_across, greatest_stress_across);
                const double length = std::sqrt(1.0 + aside * aside);
                bent.x.row(y)[x] = (wind.x - aside * wind.y) / length;
                bent.y.row(y)[x] = (wind.y + aside * wind.x) / length;
            }
        }
    });
}

void turn_down_slopes(const FixedPointGrid& surface, const DuneGround& ground,
                      const BlowingWind& wind, double deflection, WorkerPool& pool, Grid& across) {
    pool.for_ranges(ground.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const Beside rows = beside(y, ground.ny, ground.periodic_y);
            for (int x = 0; x < ground.nx; ++x) {
                const Beside columns = beside(x, ground.nx, ground.periodic_x);
                const double along_x =
                    to_metres(surface(columns.after, y) - surface(columns.before, y)) /
                    (columns.apart * ground.dx);
                const double along_y = to_metres(surface(x, rows.after) - surface(x, rows.before)) /
                                       (rows.apart * ground.dy);
                across(x, y) -= deflection * (wind.x * along_y - wind.y * along_x);
            }
        }
    });
}

void check_wind_bend(const DunesParameters& parameters) {
    const bool has_shear = parameters.transport == DuneTransport::continuous &&
                           parameters.speed_up == DuneSpeedUp::relief;
    if (parameters.wind_bend != DuneBend::none && !has_shear) {
        throw KeyError("model.wind_bend",
                       "relief bends the wind of continuous transport with model.speed_up = "
                       "\"relief\" only; write these, or model.wind_bend = \"none\"");
    }
    if (parameters.slope_deflection > 0.0 &&
        (!has_shear || parameters.wind_bend == DuneBend::contours)) {
        throw KeyError("model.slope_deflection",
                       "slopes deflect the hops of continuous transport with model.speed_up = "
                       "\"relief\" and model.wind_bend = \"none\" or \"shear\" only; write "
                       "these, or no model.slope_deflection");
    }
}

ContourBend::ContourBend(const DuneGround& ground, WorkerPool& pool)
    : ground_(ground), pool_(pool), filter_(ground, pool) {
    for (Scale scale : {Scale{100.0, 0.8, 3.0, {}, {}}, Scale{25.0, 0.2, 0.5, {}, {}}}) {
        const DuneGround& transformed = filter_.transformed();
        scale.kept_x = gaussian_of_modes(transformed.nx, scale.deviation / ground.dx);
        scale.kept_y = gaussian_of_modes(transformed.ny, scale.deviation / ground.dy);
        scales_.push_back(std::move(scale));
    }
}

void ContourBend::find(const FixedPointGrid& surface, const BlowingWind& wind, BentWind& bent) {
    std::ranges::fill(bent.x.values(), 0.0);
    std::ranges::fill(bent.y.values(), 0.0);
    for (const Scale& scale : scales_) {
        smooth_ = Grid(ground_.nx, ground_.ny);
        std::ranges::transform(surface.values(), smooth_.values().begin(), to_metres);
        filter_.apply(smooth_, [&](const GroundFilter::Wave& wave) {
            return GroundFilter::Response{scale.kept_x[static_cast<std::size_t>(wave.m)] *
                                              scale.kept_y[static_cast<std::size_t>(wave.n)],
                                          0.0};
        });
        add(scale, wind, bent);
    }
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < ground_.nx; ++x) {
                const double along = bent.x(x, y);
                const double up = bent.y(x, y);
                const double length = std::sqrt(along * along + up * up);
                bent.x(x, y) = length > 0.0 ? along / length : wind.x;
                bent.y(x, y) = length > 0.0 ? up / length : wind.y;
            }
        }
    });
}

void ContourBend::add(const Scale& scale, const BlowingWind& wind, BentWind& bent) {
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const Beside rows = beside(y, ground_.ny, ground_.periodic_y);
            for (int x = 0; x < ground_.nx; ++x) {
                const Beside columns = beside(x, ground_.nx, ground_.periodic_x);
                const double gx = (smooth_(columns.after, y) - smooth_(columns.before, y)) /
                                  (columns.apart * ground_.dx);
                const double gy =
                    (smooth_(x, rows.after) - smooth_(x, rows.before)) / (rows.apart * ground_.dy);
                const double steepness = std::min(std::sqrt(gx * gx + gy * gy), 1.0);
                const double side = gx * wind.y - gy * wind.x < 0.0 ? -1.0 : 1.0;
                const double turned = steepness * scale.strength * side;
                bent.x(x, y) += scale.weight * ((1.0 - steepness) * wind.x - turned * gy);
                bent.y(x, y) += scale.weight * ((1.0 - steepness) * wind.y + turned * gx);
            }
        }
    });
}

}  // namespace fumon
