#include "render/samples/visibility_vectors.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "render/samples/triangle_clipping.h"
#include "vectors/target.h"

namespace fumon::visibility_vectors {
namespace {

const Perspective perspective{{900.0, 40.0, 7.0}, {-3.0, 500.0, 300.0}, {0.1, 0.9, -0.2}, 0.25};

double value(const LinearForm& row, const float* offset) {
    return row.x * offset[0] + row.y * offset[1] + row.z * offset[2];
}

TEST(VisibilityVectors, CornersBehindTheEyeOrFarAsideHaveNoPlaceOnEveryTarget) {
    std::vector<float> offsets;
    for (int i = 0; i < 29; ++i) {
        offsets.push_back(static_cast<float>(i % 7) - 2.5F);
        offsets.push_back(static_cast<float>(i % 11) - 3.25F);
        offsets.push_back(0.125F * static_cast<float>(i % 5) - 1.0F);
    }
    offsets.insert(offsets.end(), {1e5F, -11110.5F, 0.0F});  // before the eye, but far aside
    const std::size_t count = offsets.size() / 3;
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        rasteriser_vectors::ProjectedVertices vertices;
        vertices.resize(count + 2);
        vertices.reversed_z.back() = 77.0F;
        project_vertices(perspective, offsets.data(), count, vertices, 1);
        EXPECT_EQ(vertices.reversed_z.back(), 77.0F) << "written past the end";
        int placed = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const float* offset = offsets.data() + 3 * i;
            const double depth = value(perspective.depth, offset);
            const double x = std::floor(value(perspective.x, offset) / depth + 0.5);
            const double y = std::floor(value(perspective.y, offset) / depth + 0.5);
            if (depth < 0.25 || std::abs(x) > guard_band || std::abs(y) > guard_band) {
                EXPECT_EQ(vertices.reversed_z[i + 1], 0.0F) << target << i;
                continue;
            }
            ++placed;
            EXPECT_EQ(vertices.x[i + 1], x) << target << i;
            EXPECT_EQ(vertices.y[i + 1], y) << target << i;
            EXPECT_EQ(vertices.reversed_z[i + 1], static_cast<float>(0.25 / depth));
        }
        EXPECT_GT(placed, 3);
        EXPECT_LT(placed, 27);
        EXPECT_GT(value(perspective.depth, offsets.data() + 3 * 29), 0.25);
        EXPECT_EQ(vertices.reversed_z[29 + 1], 0.0F);
    }
    vectors::use_target(vectors::targets().front());
}

TEST(VisibilityVectors, LengthsFollowFromNearnessAndItsSlopesOnEveryTarget) {
    constexpr std::size_t count = 32;
    const HorizontalRays rays{-0.3F, 0.9F, 0.011F, 0.002F, 0.001F, -0.004F};
    const auto upper = [](float number) { return std::bit_cast<std::uint32_t>(number) >> 16U; };
    std::array<std::uint32_t, count + 64> samples{};
    std::array<std::uint32_t, count + 64> slopes{};
    for (std::size_t i = 0; i < count; ++i) {
        const auto k = static_cast<float>(i);
        samples[i] = (std::bit_cast<std::uint32_t>(0.02F + 0.01F * k) & ~7U) | (i % 2 + 1);
        slopes[i] = upper(0.0005F * (k - 9.0F)) << 16U | upper(-0.001F * k);
    }
    samples[5] = 0;
    std::vector<std::uint32_t> expected;
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        std::vector<std::uint32_t> out(4 * count);
        // The upper row sees what the lower one does one sample farther to the right.
        record_rows({samples.data(), slopes.data(), rays},
                    {samples.data() + 1, slopes.data() + 1, rays}, 100.0F, count, out.data(),
                    out.data() + 2 * count);
        if (expected.empty()) expected = out;
        EXPECT_EQ(out, expected) << target;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = 4 * (i / 2) + i % 2;
            EXPECT_EQ(out[at], samples[i]);
            EXPECT_EQ(out[at + 2], samples[i + 1]);
            const float length = std::bit_cast<float>(out[2 * count + at]);
            const float above = std::bit_cast<float>(out[2 * count + at + 2]);
            EXPECT_EQ(above == 0.0F, i == 4 || i == count - 1) << i;
            if (i == 5) {
                EXPECT_EQ(length, 0.0F);
                continue;
            }
            const double reversed_z = std::bit_cast<float>(samples[i] & ~7U);
            const double column = 100.0 + static_cast<double>(i);
            const std::array ray{-0.3 + 0.011 * column, 0.9 + 0.002 * column};
            const double level = std::hypot(ray[0], ray[1]);
            // By a thousandth of the way to the next sample.
            const auto along = [&](double way_x, double way_y, std::uint32_t slope) {
                const double step = 1e-3;
                const double next = reversed_z + step * std::bit_cast<float>(slope << 16U);
                const double x = (ray[0] + step * way_x) / next - ray[0] / reversed_z;
                const double y = (ray[1] + step * way_y) / next - ray[1] / reversed_z;
                return std::abs((x * ray[0] + y * ray[1]) / level) / step;
            };
            const double wanted =
                along(0.011, 0.002, slopes[i] >> 16U) + along(0.001, -0.004, slopes[i] & 0xFFFFU);
            EXPECT_NEAR(length, wanted, 2e-3 * wanted) << i;
        }
    }
    vectors::use_target(vectors::targets().front());
}

}  // namespace
}  // namespace fumon::visibility_vectors
