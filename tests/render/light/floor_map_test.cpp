#include "render/light/floor_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/worker_pool.h"

namespace fumon {
namespace {

double sky_at(const FloorMap& map, double east, double north) {
    const auto cell = [](double at) {
        return static_cast<std::size_t>((at / FloorMap::half_width + 1.0) * 0.5 * FloorMap::cells);
    };
    return map.sun_and_sky.at(2 * (cell(north) * FloorMap::cells + cell(east)) + 1) / 255.0;
}

TEST(FloorMap, ARoundPillarShadesThePlainEvenlyAllAround) {
    constexpr int side = 200;
    DisplayBed bed;
    bed.z = Field<float>(side, side, 0.0F);
    bed.nodata = Mask(side, side, 1);
    bed.dx = bed.dy = 1.0F / side;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (std::hypot((x + 0.5) / side - 0.5, (y + 0.5) / side - 0.5) > 0.1) continue;
            bed.z(x, y) = 0.5F;
            bed.nodata(x, y) = 0;
        }
    }
    WorkerPool pool(1);
    const FloorMap map = floor_map(bed, Block{}, SunDirection{0.0F, 1.0F, 3.0F, 4.0F}, pool);
    for (const double radius : {0.14, 0.3, 0.6}) {
        double least = 1.0;
        double most = 0.0;
        for (int i = 0; i < 96; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 96;
            const double sky = sky_at(map, radius * std::cos(angle), radius * std::sin(angle));
            least = std::min(least, sky);
            most = std::max(most, sky);
        }
        EXPECT_LT(most - least, radius < 0.2 ? 0.10 : 0.045)
            << radius << ": " << least << " … " << most;
        EXPECT_LT(most, 0.999) << radius;
    }
    EXPECT_GT(sky_at(map, 1.2, 1.2), 0.95);
}

}  // namespace
}  // namespace fumon
