#include "render/light/light_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "render/light/lighting.h"
#include "render/light/sun_sweep.h"
#include "vectors/target.h"

namespace fumon {
namespace {

/// Heights that change from cell to cell, and steeply here and there.
DisplayBed rough_bed(int nx, int ny) {
    DisplayBed bed;
    bed.z = Field<float>(nx, ny);
    std::uint32_t state = 12345;
    for (float& height : bed.z.values()) {
        state = state * 1664525U + 1013904223U;
        height = static_cast<float>(state >> 8U) * 0x1p-24F;
        if (height > 0.9F) height *= 4.0F;
    }
    bed.dx = 1.0F;
    bed.dy = 1.3F;
    return bed;
}

TEST(LightVectors, EveryTargetGivesTheSameTexels) {
    const std::string before = vectors::target();
    WorkerPool pool(2);
    for (const int nx : {1, 3, 16, 61}) {
        const DisplayBed bed = rough_bed(nx, 37);
        for (const SunDirection& sun :
             {SunDirection{0.6F, 0.8F, 0.4F, 0.5F}, SunDirection{-0.8F, -0.6F, 0.9F, 1.2F}}) {
            LightTexels first;
            for (const std::string& target : vectors::targets()) {
                vectors::use_target(target);
                const LightTexels texels = lighting_texels(bed, sun, pool);
                if (first.empty()) first = texels;
                EXPECT_EQ(texels, first) << target << ", " << nx << " columns";
            }
            const auto [least, most] = std::ranges::minmax(first);
            EXPECT_LT(least, most);
        }
    }
    vectors::use_target(before);
}

TEST(LightVectors, ATexelHoldsTheNormalAndTheSharesRounded) {
    const std::string before = vectors::target();
    const std::vector<float> south(21, 0.0F);
    const std::vector<float> north(21, 1.5F);
    std::vector<float> row(23);
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = 2.0F * static_cast<float>(x);
    const std::vector<float> sun(21, 0.25F);
    const std::vector<float> sky(21, 0.75F);
    const double length = std::sqrt(1.0 + 4.0 + 2.25);
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        std::vector<std::uint16_t> texels(4 * 21 + 1, 7);
        light_vectors::pack_texels({south.data(), row.data(), north.data(), 0.5F, 1.0F}, sun.data(),
                                   sky.data(), {65535.0F, 0.0F}, 21, texels.data());
        for (std::size_t x = 0; x < 21; ++x) {
            EXPECT_NEAR(texels[4 * x], 32767.0 * (1.0 - 2.0 / length), 1.0) << target;
            EXPECT_NEAR(texels[4 * x + 1], 32767.0 * (1.0 - 1.5 / length), 1.0) << target;
            EXPECT_EQ(texels[4 * x + 2], 16384) << target;
            EXPECT_EQ(texels[4 * x + 3], 49151) << target;
        }
        EXPECT_EQ(texels.back(), 7) << "written past the end";
    }
    vectors::use_target(before);
}

}  // namespace
}  // namespace fumon
