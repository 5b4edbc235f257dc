#include "render/edges/brink_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/grid.h"
#include "vectors/target.h"

namespace fumon {
namespace {

/// Of the four cells around a place.
float between(const Field<float>& field, float u, float v) {
    const int west = std::min(static_cast<int>(u), field.nx() - 2);
    const int south = std::min(static_cast<int>(v), field.ny() - 2);
    const float right = u - static_cast<float>(west);
    const float upper = v - static_cast<float>(south);
    const float low = field(west, south) + right * (field(west + 1, south) - field(west, south));
    const float high =
        field(west, south + 1) + right * (field(west + 1, south + 1) - field(west, south + 1));
    return low + upper * (high - low);
}

/// Means that are the farther the less of what lies along an edge.
float mean_along(const Field<float>& field, int x, int y, float east, float north, float step) {
    float sum = 0.0F;
    float weights = 0.0F;
    for (int i = -brink_vectors::positions_aside; i <= brink_vectors::positions_aside; ++i) {
        const float away = step * static_cast<float>(i);
        const auto weight = static_cast<float>(brink_vectors::positions_aside + 1 - std::abs(i));
        sum += weight * between(field,
                                std::clamp(static_cast<float>(x) + away * east, 0.0F,
                                           static_cast<float>(field.nx() - 1)),
                                std::clamp(static_cast<float>(y) + away * north, 0.0F,
                                           static_cast<float>(field.ny() - 1)));
        weights += weight;
    }
    return sum / weights;
}

TEST(BrinkVectors, EveryTargetMixesInTheMeansOfSinglePlaces) {
    const std::string before = vectors::target();
    Field<float> field(53, 9);  // ends between vectors
    std::uint32_t state = 4711;
    const auto chance = [&state] {
        state = state * 1664525U + 1013904223U;
        return static_cast<float>(state >> 8U) * 0x1p-24F;
    };
    for (float& height : field.values()) height = chance() - 0.5F;
    const auto count = static_cast<std::size_t>(field.nx());
    std::vector<float> share(count);
    std::vector<float> east(count);
    std::vector<float> north(count);
    for (std::size_t x = 0; x < count; ++x) {
        share[x] = x < 20 || chance() < 0.5F ? 0.0F : chance();
        const float turn = 6.2831853F * chance();
        east[x] = std::cos(turn);
        north[x] = std::sin(turn);
    }
    constexpr float step = 0.75F;
    const auto pairs = brink_vectors::pairs_of(field.data(), static_cast<int>(field.size()));
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        for (int y = 0; y < field.ny(); ++y) {
            std::vector<float> heights(count);
            for (std::size_t x = 0; x < count; ++x) heights[x] = 0.1F * static_cast<float>(x);
            brink_vectors::mix_means_along({pairs.data(), field.nx(), field.ny()}, y,
                                           {share.data(), east.data(), north.data()}, step,
                                           heights.data());
            for (std::size_t x = 0; x < count; ++x) {
                const float level = 0.1F * static_cast<float>(x);
                const float mean =
                    mean_along(field, static_cast<int>(x), y, east[x], north[x], step);
                EXPECT_EQ(heights[x], share[x] == 0.0F ? level : level + share[x] * (mean - level))
                    << target << ", " << x << ", " << y;
            }
        }
    }
    vectors::use_target(before);
}

}  // namespace
}  // namespace fumon
