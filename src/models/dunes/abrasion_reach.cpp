#include "models/dunes/abrasion_reach.h"

#include <algorithm>
#include <functional>

#include "base/elementary.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr double climb = 0.26794919243112270;  // tangent of 15 degrees

}  // namespace

AbrasionReach::AbrasionReach(const DuneGround& ground, double height, WorkerPool& pool)
    : height_(height),
      pool_(pool),
      below_(ground.nx, ground.ny),
      levels_(ground, pool),
      share_(ground.nx, ground.ny) {}

void AbrasionReach::find(const FixedPointGrid& surface, const BlowingWind& wind) {
    std::ranges::transform(surface.values(), below_.values().begin(), std::negate<>());
    std::ranges::fill(share_.values(), 0.0);
    const std::array ways{BlowingWind{wind.x, wind.y, 1.0}, BlowingWind{-wind.y, wind.x, 1.0},
                          BlowingWind{wind.y, -wind.x, 1.0}};
    for (const BlowingWind& way : ways) {
        levels_.cast(below_, way, {climb, climb}, WindShadow::Find::shade_and_envelope);
        const Grid& level = levels_.envelope();
        pool_.for_ranges(surface.ny(), [&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                for (int x = 0; x < surface.nx(); ++x) {
                    const double above = level(x, y) - to_metres(below_(x, y));
                    share_(x, y) = std::max(share_(x, y), above);
                }
            }
        });
    }
    pool_.for_ranges(surface.ny(), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (double& share : share_.row(y)) share = elementary::exp(-share / height_);
        }
    });
}

}  // namespace fumon
