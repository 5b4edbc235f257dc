#include "render/view/display_bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/worker_pool.h"
#include "numerics/resampling.h"
#include "render/light/light.h"
#include "render/light/lighting.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

TEST(DisplayBed, RefinesSmallBedsOnly) {
    EXPECT_EQ(refinement_of(100, 100, 1920), 4);
    EXPECT_EQ(refinement_of(43, 89, 1920), 5);
    EXPECT_EQ(refinement_of(400, 30, 1920), 1);
    EXPECT_EQ(refinement_of(1024, 1024, 1920), 1);
    EXPECT_EQ(refinement_of(24, 20, 64), 3) << "no finer than the picture";
}

TEST(DisplayBed, RefinementInterpolatesAndKeepsStraightSlopes) {
    Field<float> slope(20, 10);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x)
            slope(x, y) = 2.0F * static_cast<float>(x) - static_cast<float>(y);
    const Field<float> fine = refined(slope, 5);
    ASSERT_EQ(fine.nx(), 100);
    for (int y = 10; y < 40; ++y) {
        for (int x = 10; x < 90; ++x) {
            const double u = (x + 0.5) / 5.0 - 0.5;
            const double v = (y + 0.5) / 5.0 - 0.5;
            EXPECT_NEAR(fine(x, y), 2.0 * u - v, 1e-4);
        }
    }
    const Field<float> waves = [] {
        Field<float> field(31, 23);
        for (int y = 0; y < 23; ++y)
            for (int x = 0; x < 31; ++x)
                field(x, y) = static_cast<float>(std::sin(1.1 * x) + std::cos(0.9 * y * x));
        return field;
    }();
    const Field<float> odd = refined(waves, 3);  // every third place is a coarse cell's centre
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 31; ++x) EXPECT_NEAR(odd(3 * x + 1, 3 * y + 1), waves(x, y), 1e-6F);
}

TEST(DisplayBed, DoesNotOvershootIntoCellsWithoutData) {
    const Snapshot bed = masked_bed(60, 40);
    const Block block = frame_block(bed, 1.0);
    const DisplayBed shown = display_bed(bed, block, 4);
    double low = 1e9;
    double high = -1e9;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 60; ++x) {
            if (bed.nodata(x, y) != 0) continue;
            low = std::min(low, block.z(bed.bed(x, y)));
            high = std::max(high, block.z(bed.bed(x, y)));
        }
    }
    const double room = 0.15 * (high - low);
    for (int y = 0; y < shown.z.ny(); ++y) {
        for (int x = 0; x < shown.z.nx(); ++x) {
            if (shown.nodata(x, y) != 0) continue;
            EXPECT_GT(shown.z(x, y), low - room);
            EXPECT_LT(shown.z(x, y), high + room);
        }
    }
}

TEST(Lighting, HoldsTheNormalOfAPlane) {
    DisplayBed bed;
    bed.z = Field<float>(12, 9);
    bed.dx = 0.5F;
    bed.dy = 0.25F;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 12; ++x)
            bed.z(x, y) =
                0.3F * 0.5F * static_cast<float>(x) - 0.2F * 0.25F * static_cast<float>(y);
    WorkerPool pool(2);
    SunSettings high;
    high.elevation = 80.0;
    const auto texels = lighting_texels(bed, sun_direction(high), pool);
    const double length = std::sqrt(1.0 + 0.09 + 0.04);
    for (std::size_t i = 0; i < bed.z.size(); ++i) {
        EXPECT_NEAR(texels[4 * i] / 32767.0 - 1.0, -0.3 / length, 1e-4);
        EXPECT_NEAR(texels[4 * i + 1] / 32767.0 - 1.0, 0.2 / length, 1e-4);
        EXPECT_EQ(texels[4 * i + 2], 65535);
    }
}

}  // namespace
}  // namespace fumon
