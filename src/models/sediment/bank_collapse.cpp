#include "models/sediment/bank_collapse.h"

#include <algorithm>

#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr int most_passes = 200;
constexpr std::int64_t deep = std::int64_t{1} << 48;     // units: 65 km of loose ground
constexpr std::int64_t highest = std::int64_t{1} << 51;  // of a cell without data

}  // namespace

BankCollapse::BankCollapse(const LoadGround& ground, double repose_angle, const Grid& floor,
                           WorkerPool& pool)
    : ground_(ground),
      rock_(floor),
      pool_(pool),
      slopes_(
          {ground.nx, ground.ny, ground.dx, ground.dy, ground.periodic_x && ground.slope_x == 0.0,
           ground.periodic_y && ground.slope == 0.0},
          {repose_angle, repose_angle}, pool),
      before_(ground.nx, ground.ny),
      surface_(ground.nx, ground.ny),
      floor_(ground.nx, ground.ny) {}

void BankCollapse::fail(Grid& bed) {
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < ground_.nx; ++x) {
                if (ground_.outside(x, y)) {
                    before_(x, y) = surface_(x, y) = floor_(x, y) = highest;
                    continue;
                }
                const double plane = ground_.plane(x, y);
                const std::int64_t height = to_units(bed(x, y) + plane);
                before_(x, y) = surface_(x, y) = height;
                floor_(x, y) =
                    rock_.empty() ? height - deep : std::min(height, to_units(rock_(x, y) + plane));
            }
        }
    });
    if (slopes_.relax(surface_, floor_, most_passes).passes == 0) return;
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < ground_.nx; ++x) {
                const std::int64_t gain = surface_(x, y) - before_(x, y);
                if (gain != 0) bed(x, y) += to_metres(gain);
            }
        }
    });
}

}  // namespace fumon
