#include "models/dunes/rock_wear.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/give_up.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr double sheltering = 0.05;       // m of sand, under which rock is not worn
constexpr double descent = 0.2;           // slope at which grains come down
constexpr double most_on_slopes = 10.0;   // in parts of what a level floor takes
constexpr double share_of_excess = 0.25;  // as sand slides

}  // namespace

RockWear::RockWear(const DuneGround& ground, double share, double tangent, WorkerPool& pool)
    : ground_(ground),
      share_(share),
      tangent_(tangent),
      pool_(pool),
      before_(ground.nx, ground.ny),
      worn_of_row_(1, ground.ny) {}

std::int64_t RockWear::before_at(int x, int y) const {
    const auto place = [](int cell, int count, bool periodic) {
        if (cell >= 0 && cell < count) return cell;
        return periodic ? (cell + count) % count : std::clamp(cell, 0, count - 1);
    };
    return before_(place(x, ground_.nx, ground_.periodic_x),
                   place(y, ground_.ny, ground_.periodic_y));
}

double RockWear::slope_along(const BlowingWind& wind, int x, int y) const {
    const double along_x =
        to_metres(before_at(x + 1, y) - before_at(x - 1, y)) / (2.0 * ground_.dx);
    const double along_y =
        to_metres(before_at(x, y + 1) - before_at(x, y - 1)) / (2.0 * ground_.dy);
    return along_x * wind.x + along_y * wind.y;
}

std::int64_t RockWear::crumbles(int x, int y) const {
    const std::int64_t here = before_(x, y);
    const std::int64_t fall_x =
        std::max({here - before_at(x - 1, y), here - before_at(x + 1, y), std::int64_t{0}});
    const std::int64_t fall_y =
        std::max({here - before_at(x, y - 1), here - before_at(x, y + 1), std::int64_t{0}});
    const double a = to_metres(fall_x) / ground_.dx;
    const double b = to_metres(fall_y) / ground_.dy;
    const double slope = std::sqrt(a * a + b * b);
    if (slope <= tangent_) return 0;
    const auto fall = static_cast<double>(std::max(fall_x, fall_y));
    return static_cast<std::int64_t>(share_of_excess * (1.0 - tangent_ / slope) * fall);
}

void RockWear::wear(DuneBed& bed, const BlowingWind& wind, const WholeGrid& landed,
                    const Grid* cover) {
    before_ = bed.rock;
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            give_up_if_asked();
            std::int64_t of_row = 0;
            for (int x = 0; x < ground_.nx; ++x) {
                const std::int64_t crumbled = crumbles(x, y);
                const double sand = to_metres(bed.surface(x, y) - bed.rock(x, y));
                double open = std::max(1.0 - sand / sheltering, 0.0);
                if (cover != nullptr) open *= 1.0 - (*cover)(x, y);
                std::int64_t blown = 0;
                if (open > 0.0 && landed(x, y) > 0) {
                    const double facing =
                        std::clamp(1.0 + slope_along(wind, x, y) / descent, 0.0, most_on_slopes);
                    blown = static_cast<std::int64_t>(share_ * facing * open *
                                                      static_cast<double>(landed(x, y)));
                }
                bed.rock(x, y) -= crumbled + blown;
                bed.surface(x, y) -= blown;
                bed.moving(x, y) += blown;
                of_row += crumbled + blown;
            }
            worn_of_row_(0, y) = of_row;
        }
    });
    const auto rows = worn_of_row_.values();
    bed.worn += std::accumulate(rows.begin(), rows.end(), std::int64_t{0});
}

}  // namespace fumon
