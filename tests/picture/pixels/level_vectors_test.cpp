#include "picture/pixels/level_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <vector>

#include "vectors/target.h"

namespace fumon::level_vectors {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Levels of which some differ from those of another row: by one, by anything, or not.
Bytes changed(Bytes levels, std::mt19937& random) {
    for (std::uint8_t& level : levels) {
        const auto draw = random() % 4;
        if (draw == 0) level ^= 1U;
        if (draw == 1) level = static_cast<std::uint8_t>(random());
    }
    return levels;
}

Bytes some_levels(std::size_t count, std::mt19937& random) {
    Bytes levels(count);
    for (std::uint8_t& level : levels) {
        const auto draw = random();
        level = draw % 3 == 0 ? static_cast<std::uint8_t>(draw >> 8U) : draw % 3 == 1 ? 0 : 255;
    }
    return levels;
}

int largest_of(const Bytes& a, const Bytes& b, std::size_t pixel) {
    int largest = 0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

int luminance_of(const Bytes& a, std::size_t pixel) {
    return 77 * a[3 * pixel] + 150 * a[3 * pixel + 1] + 29 * a[3 * pixel + 2];
}

void compare_with_plain_loops(const Bytes& a, const Bytes& b) {
    const std::size_t pixels = a.size() / 3;
    const RowDifference row = row_difference(a.data(), b.data(), static_cast<int>(pixels));
    Bytes marked(a.size() + 1, 9);
    mark_row(a.data(), b.data(), static_cast<int>(pixels), marked.data());
    EXPECT_EQ(marked.back(), 9) << "beyond the row";
    std::vector<std::int16_t> luminances(pixels + 1, 77);
    luminance_row(a.data(), static_cast<int>(pixels), luminances.data());
    EXPECT_EQ(luminances.back(), 77) << "beyond the row";
    RowDifference plain;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const int by = largest_of(a, b, pixel);
        plain.largest = std::max(plain.largest, by);
        plain.changed += by > 0 ? 1 : 0;
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) plain.sum += std::abs(a[i] - b[i]);
        const int grey = luminance_of(a, pixel) / 1024;
        const std::array<int, 3> shown =
            by == 0 ? std::array{grey, grey, grey}
                    : std::array{std::min(255, 120 + 4 * by), std::clamp(2 * (by - 64), 0, 255), 0};
        for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(marked[3 * pixel + i], shown.at(i)) << pixel;
        ASSERT_EQ(luminances[pixel], luminance_of(a, pixel) - middle_luminance) << pixel;
    }
    EXPECT_EQ(row.largest, plain.largest);
    EXPECT_EQ(row.changed, plain.changed);
    EXPECT_EQ(row.sum, plain.sum);
}

void compare_tiles(std::mt19937& random, int rows, int tiles) {
    const std::size_t stride = static_cast<std::size_t>(tiles) * tile_side + 3;
    std::vector<std::int16_t> a(stride * static_cast<std::size_t>(rows));
    std::vector<std::int16_t> b(a.size());
    for (auto* values : {&a, &b}) {
        const bool extreme = random() % 2 == 0;  // the largest sums of products
        for (std::int16_t& value : *values) {
            const auto draw = static_cast<int>(random() % 65281U) - middle_luminance;
            value = static_cast<std::int16_t>(extreme ? (draw < 0 ? -32640 : 32640) : draw);
        }
    }
    std::vector<TileSums> sums(static_cast<std::size_t>(tiles));
    tile_sums(a.data(), b.data(), stride, rows, tiles, sums.data());
    for (std::size_t tile = 0; tile < sums.size(); ++tile) {
        TileSums plain;
        for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
            for (std::size_t column = 0; column < tile_side; ++column) {
                const std::int64_t left = a[row * stride + tile * tile_side + column];
                const std::int64_t right = b[row * stride + tile * tile_side + column];
                plain.a += left;
                plain.b += right;
                plain.aa += left * left;
                plain.bb += right * right;
                plain.ab += left * right;
            }
        }
        EXPECT_EQ(sums[tile].a, plain.a);
        EXPECT_EQ(sums[tile].b, plain.b);
        EXPECT_EQ(sums[tile].aa, plain.aa);
        EXPECT_EQ(sums[tile].bb, plain.bb);
        EXPECT_EQ(sums[tile].ab, plain.ab);
    }
}

TEST(LevelVectors, AreThoseOfPlainLoopsOnEveryTarget) {
    const std::string before = vectors::target();
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        std::mt19937 random(7);
        for (const std::size_t pixels :
             {0U, 1U, 7U, 15U, 16U, 17U, 31U, 33U, 64U, 127U, 130U, 301U}) {
            const Bytes a = some_levels(3 * pixels, random);
            compare_with_plain_loops(a, changed(a, random));
            compare_with_plain_loops(a, a);
        }
        for (const int rows : {1, 5, 8}) compare_tiles(random, rows, 9);
        ASSERT_FALSE(::testing::Test::HasFailure()) << target;
    }
    vectors::use_target(before);
}

}  // namespace
}  // namespace fumon::level_vectors
