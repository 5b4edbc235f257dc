#include "models/dunes/rock_wear.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/cancellation.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr double sheltering = 0.05;       // m of sand, under which rock is not worn
constexpr double descent = 0.2;           // slope at which grains come down
constexpr double most_on_slopes = 10.0;   // in parts of what a level floor takes
constexpr double share_of_excess = 0.25;  // as sand slides

}  // namespace

RockWear::RockWear(const DuneGround& ground, const Rule& rule, WorkerPool& pool)
    : ground_(ground),
      rule_(rule),
      pool_(pool),
      before_(ground.nx, ground.ny),
      worn_of_row_(1, ground.ny),
      dust_of_row_(1, ground.ny) {
    if (rule.height > 0.0) reach_.emplace(ground, rule.height, pool);
}

RockWear::Around RockWear::around(int x, int y) const {
    const int last_x = ground_.nx - 1;
    const int last_y = ground_.ny - 1;
    const int west = x > 0 ? x - 1 : ground_.periodic_x ? last_x : 0;
    const int east = x < last_x ? x + 1 : ground_.periodic_x ? 0 : last_x;
    const int south = y > 0 ? y - 1 : ground_.periodic_y ? last_y : 0;
    const int north = y < last_y ? y + 1 : ground_.periodic_y ? 0 : last_y;
    return {before_(west, y), before_(east, y), before_(x, south), before_(x, north)};
}

double RockWear::slope_along(const BlowingWind& wind, const Around& rock) const {
    return to_metres(rock.east - rock.west) / (2.0 * ground_.dx) * wind.x +
           to_metres(rock.north - rock.south) / (2.0 * ground_.dy) * wind.y;
}

double RockWear::slope_before(const BlowingWind& wind, std::int64_t here,
                              const Around& rock) const {
    const std::int64_t rise_x = wind.x > 0.0 ? here - rock.west : rock.east - here;
    const std::int64_t rise_y = wind.y > 0.0 ? here - rock.south : rock.north - here;
    return to_metres(rise_x) / ground_.dx * wind.x + to_metres(rise_y) / ground_.dy * wind.y;
}

std::int64_t RockWear::crumbles(std::int64_t here, const Around& rock) const {
    const std::int64_t fall_x = std::max({here - rock.west, here - rock.east, std::int64_t{0}});
    const std::int64_t fall_y = std::max({here - rock.south, here - rock.north, std::int64_t{0}});
    const double a = to_metres(fall_x) / ground_.dx;
    const double b = to_metres(fall_y) / ground_.dy;
    const double square = a * a + b * b;
    if (square <= rule_.tangent * rule_.tangent) return 0;
    const auto fall = static_cast<double>(std::max(fall_x, fall_y));
    return static_cast<std::int64_t>(share_of_excess * (1.0 - rule_.tangent / std::sqrt(square)) *
                                     fall);
}

void RockWear::wear(DuneBed& bed, const BlowingWind& wind, const FixedPointGrid& landed,
                    double ended, const Grid* cover) {
    before_ = bed.rock;
    if (reach_) reach_->find(bed.surface, wind);
    const auto dust_of = [&](std::int64_t worn) {
        return static_cast<std::int64_t>(rule_.dust * static_cast<double>(worn));
    };
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            throw_if_cancelled();
            std::int64_t of_row = 0;
            std::int64_t dust_of_row = 0;
            for (int x = 0; x < ground_.nx; ++x) {
                const double sand = to_metres(bed.surface(x, y) - bed.rock(x, y));
                double open = 1.0 - sand / sheltering;
                if (!(open > 0.0)) continue;
                if (cover != nullptr) open *= 1.0 - (*cover)(x, y);
                const Around rock = around(x, y);
                const std::int64_t crumbled = crumbles(before_(x, y), rock);
                std::int64_t blown = 0;
                if (landed(x, y) > 0) {
                    const double slope =
                        reach_ ? slope_before(wind, before_(x, y), rock) : slope_along(wind, rock);
                    const double facing = std::clamp(1.0 + slope / descent, 0.0, most_on_slopes);
                    if (reach_) open *= reach_->share()(x, y);
                    blown = static_cast<std::int64_t>(rule_.share * ended * facing * open *
                                                      static_cast<double>(landed(x, y)));
                }
                bed.rock(x, y) -= crumbled + blown;
                const std::int64_t crumbled_dust = dust_of(crumbled);
                const std::int64_t blown_dust = dust_of(blown);
                bed.surface(x, y) -= blown + crumbled_dust;
                bed.moving(x, y) += blown - blown_dust;
                dust_of_row += crumbled_dust + blown_dust;
                of_row += crumbled + blown;
            }
            worn_of_row_(0, y) = of_row;
            dust_of_row_(0, y) = dust_of_row;
        }
    });
    const auto sum = [](const FixedPointGrid& rows) {
        return std::accumulate(rows.values().begin(), rows.values().end(), std::int64_t{0});
    };
    bed.worn += sum(worn_of_row_);
    bed.outflow += sum(dust_of_row_);
}

}  // namespace fumon
