#include "render/samples/rasteriser_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "vectors/target.h"

namespace fumon::rasteriser_vectors {
namespace {

constexpr int columns = 75;
constexpr int rows = 40;
constexpr int first_column = 1000;
constexpr int first_row = 500;

int random_below(std::uint32_t& state, int bound) {
    state = state * 1664525U + 1013904223U;
    return static_cast<int>((state >> 8U) % static_cast<std::uint32_t>(bound));
}

float random_share(std::uint32_t& state) {
    return static_cast<float>(random_below(state, 1 << 20)) / static_cast<float>(1 << 20);
}

/// Samples of a band, as rasterise() leaves them.
struct Picture {
    std::size_t stride = columns + Band::beyond;
    std::vector<std::uint32_t> samples = std::vector<std::uint32_t>(rows * stride + Band::beyond);

    Band band() {
        return {samples.data(),         stride,    first_column,
                first_column + columns, first_row, first_row + rows};
    }
    [[nodiscard]] std::uint32_t at(int column, int row) const {
        return samples[static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column)];
    }
    void draw_all(const ProjectedVertices& vertices, const std::vector<std::uint32_t>& triangles,
                  std::uint32_t kind, bool double_sided) {
        std::vector<std::uint32_t> listed(triangles.size() / 3);
        std::iota(listed.begin(), listed.end(), 0U);
        rasterise(vertices, {triangles.data(), 0, listed.data(), listed.size(), kind, double_sided},
                  band());
    }
};

/// A grid of corners that are moved at random, by whole steps so that many samples lie on edges; as
/// triangles that cover all of the band, and more.
struct Net {
    ProjectedVertices vertices;
    std::vector<std::uint32_t> triangles;

    Net(std::uint32_t& state, int step, int snapped_to) {
        const int across = 256 * columns / step + 5;
        const int along = 256 * rows / step + 5;
        vertices.resize(static_cast<std::size_t>(across * along));
        for (int y = 0; y < along; ++y) {
            for (int x = 0; x < across; ++x) {
                const auto position = [&](int first, int count) {
                    const int moved = random_below(state, step / 2) - step / 4;
                    return 256 * first + (count - 2) * step + (moved / snapped_to) * snapped_to +
                           128;
                };
                const auto at = static_cast<std::size_t>(y * across + x);
                vertices.x[at] = position(first_column, x);
                vertices.y[at] = position(first_row, y);
                vertices.reversed_z[at] = 0.25F + 0.5F * random_share(state);
                if (x == 0 || y == 0) continue;
                const auto north_east = static_cast<std::uint32_t>(at);
                const std::uint32_t north_west = north_east - 1;
                const std::uint32_t south_east = north_east - static_cast<std::uint32_t>(across);
                const std::uint32_t south_west = south_east - 1;
                triangles.insert(triangles.end(), {south_west, south_east, north_east});
                triangles.insert(triangles.end(), {south_west, north_east, north_west});
            }
        }
    }
};

TEST(RasteriserVectors, ASampleLiesInOneOfTwoTrianglesThatShareAnEdge) {
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        std::uint32_t state = 5;
        for (const int step : {300, 1024, 8192, 40000}) {  // the largest are drawn another way
            for (const int snapped_to : {1, 64, 256}) {
                const Net net(state, step, snapped_to);
                std::vector<int> covered(static_cast<std::size_t>(columns * rows));
                for (std::size_t i = 0; i < net.triangles.size(); i += 3) {
                    Picture picture;
                    picture.draw_all(net.vertices,
                                     {net.triangles.begin() + static_cast<std::ptrdiff_t>(i),
                                      net.triangles.begin() + static_cast<std::ptrdiff_t>(i) + 3},
                                     1, true);
                    for (int y = 0; y < rows; ++y)
                        for (int x = 0; x < columns; ++x)
                            if (picture.at(x, y) != 0)
                                ++covered[static_cast<std::size_t>(y * columns + x)];
                    if (step < 1024) break;  // some thousand triangles: those are drawn as one
                }
                if (step < 1024) {
                    Picture picture;
                    picture.draw_all(net.vertices, net.triangles, 1, false);
                    for (int y = 0; y < rows; ++y)
                        for (int x = 0; x < columns; ++x) EXPECT_NE(picture.at(x, y), 0U);
                    continue;
                }
                EXPECT_EQ(*std::ranges::min_element(covered), 1) << target << " " << step;
                EXPECT_EQ(*std::ranges::max_element(covered), 1) << target << " " << step;
            }
        }
    }
    vectors::use_target(vectors::targets().front());
}

/// Nearness over a triangle where it holds the middle of a sample, in double precision; −1 else.
double reversed_z_in(const ProjectedVertices& vertices, const std::uint32_t* of, int column,
                     int row) {
    const double x = 256.0 * (first_column + column) + 128.0;
    const double y = 256.0 * (first_row + row) + 128.0;
    const auto part = [&](std::uint32_t a, std::uint32_t b, double u, double v) {
        return (vertices.x[b] - vertices.x[a]) * (v - vertices.y[a]) -
               (vertices.y[b] - vertices.y[a]) * (u - vertices.x[a]);
    };
    const double all = part(of[0], of[1], vertices.x[of[2]], vertices.y[of[2]]);
    const double first = part(of[1], of[2], x, y) / all;
    const double second = part(of[2], of[0], x, y) / all;
    const double third = part(of[0], of[1], x, y) / all;
    if (all <= 0.0 || first < 0.0 || second < 0.0 || third < 0.0) return -1.0;
    return first * vertices.reversed_z[of[0]] + second * vertices.reversed_z[of[1]] +
           third * vertices.reversed_z[of[2]];
}

TEST(RasteriserVectors, ASampleSeesTheNearestTriangleOnEveryTarget) {
    std::uint32_t state = 9;
    ProjectedVertices vertices;
    constexpr int count = 60;
    vertices.resize(3 * count);
    std::vector<std::uint32_t> triangles(3 * count);
    std::iota(triangles.begin(), triangles.end(), 0U);
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const int reach = i % 2 == 0 ? 2500 : 60000;
        const int x = 256 * first_column + random_below(state, 256 * columns);
        const int y = 256 * first_row + random_below(state, 256 * rows);
        for (std::size_t k = 0; k < 3; ++k) {
            vertices.x[i + k] = x + random_below(state, 2 * reach) - reach;
            vertices.y[i + k] = y + random_below(state, 2 * reach) - reach;
            vertices.reversed_z[i + k] = 0.1F + 0.8F * random_share(state);
        }
    }
    std::vector<std::uint32_t> expected;
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        Picture picture;
        picture.draw_all(vertices, triangles, 3, false);
        std::vector<std::uint32_t> seen;
        int compared = 0;
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < columns; ++x) {
                seen.push_back(picture.at(x, y));
                double nearest = -1.0;
                for (std::size_t i = 0; i < triangles.size(); i += 3)
                    nearest =
                        std::max(nearest, reversed_z_in(vertices, triangles.data() + i, x, y));
                const float found = std::bit_cast<float>(seen.back() & ~kind_bits);
                if (nearest < 0.0) {
                    EXPECT_EQ(seen.back(), 0U);
                    continue;
                }
                EXPECT_EQ(seen.back() & kind_bits, 3U) << target << " " << x << " " << y;
                EXPECT_NEAR(found, nearest, 1e-5);
                ++compared;
            }
        }
        EXPECT_GT(compared, 1000);
        if (expected.empty()) expected = seen;
        EXPECT_EQ(seen, expected) << target;
    }
    vectors::use_target(vectors::targets().front());
}

TEST(RasteriserVectors, SlopesAreThoseOfTheNearestTriangleOnEveryTarget) {
    ProjectedVertices vertices;  // a small one before a large one, both planes
    const auto add = [&](int x, int y, float reversed_z) {
        vertices.x.push_back(256 * (first_column + x));
        vertices.y.push_back(256 * (first_row + y));
        vertices.reversed_z.push_back(reversed_z);
    };
    const auto large = [](int x, int y) {
        return 0.25F + 0.0005F * static_cast<float>(x) - 0.001F * static_cast<float>(y);
    };
    for (const auto& [x, y] : {std::pair(-200, -20), {200, -20}, {0, 200}}) add(x, y, large(x, y));
    for (const auto& [x, y] : {std::pair(20, 10), {40, 10}, {20, 30}})
        add(x, y, 0.5F - 0.002F * static_cast<float>(x) + 0.004F * static_cast<float>(y));
    const auto number = [](std::uint32_t upper_half) {
        return std::bit_cast<float>(upper_half << 16U);
    };
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        for (const std::vector<std::uint32_t>& order :
             {std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}, {3, 4, 5, 0, 1, 2}}) {
            Picture picture;
            std::vector<std::uint32_t> slopes(picture.samples.size());
            Band band = picture.band();
            band.slopes = slopes.data();
            const std::array<std::uint32_t, 2> listed{0, 1};
            rasterise(vertices, {order.data(), 0, listed.data(), 2, 1, true}, band);
            for (int y = 0; y < rows; ++y) {
                for (int x = 0; x < columns; ++x) {
                    const bool small = x >= 20 && y >= 10 && x + y < 49;
                    if (!small && x + y < 51 && x >= 19 && y >= 9) continue;  // on its edge
                    const std::uint32_t halves =
                        slopes[static_cast<std::size_t>(y) * picture.stride +
                               static_cast<std::size_t>(x)];
                    EXPECT_NEAR(number(halves >> 16U), small ? -0.002 : 0.0005, 1e-5) << x << y;
                    EXPECT_NEAR(number(halves & 0xFFFFU), small ? 0.004 : -0.001, 2e-5) << x << y;
                }
            }
        }
    }
    vectors::use_target(vectors::targets().front());
}

TEST(RasteriserVectors, BacksAreLeftOutIfWanted) {
    ProjectedVertices vertices;
    vertices.x = {256 * first_column, 256 * (first_column + 20), 256 * first_column};
    vertices.y = {256 * first_row, 256 * first_row, 256 * (first_row + 20)};
    vertices.reversed_z = {0.5F, 0.5F, 0.5F};
    const auto drawn = [&](const std::vector<std::uint32_t>& triangle, bool double_sided) {
        Picture picture;
        picture.draw_all(vertices, triangle, 1, double_sided);
        return std::ranges::count_if(picture.samples, [](std::uint32_t s) { return s != 0; });
    };
    EXPECT_EQ(drawn({0, 1, 2}, false), 210) << "with the 20 that lie on its slope";
    EXPECT_EQ(drawn({0, 2, 1}, false), 0);
    EXPECT_EQ(drawn({0, 2, 1}, true), drawn({0, 1, 2}, false));
}

}  // namespace
}  // namespace fumon::rasteriser_vectors
