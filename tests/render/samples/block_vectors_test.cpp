#include "render/samples/block_vectors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "vectors/target.h"

namespace fumon::block_vectors {
namespace {

float next_share(std::uint32_t& state) {
    state = state * 1664525U + 1013904223U;
    return static_cast<float>(state >> 8U) / static_cast<float>(1 << 24);
}

TEST(BlockVectors, CornersStandWhereTheirPlacesAreSeenOnEveryTarget) {
    const Placed placed{{256000.0, 12000.0, -3000.0, 7000.0},
                        {-900.0, 301000.0, 88000.0, 100.0},
                        {0.0, 0.0, 0.0, 1.5},
                        {0.4, -0.3, 0.2, 2.0},
                        0.1};
    const auto value = [](const Linear& of, double east, double north, double height) {
        return of.east * east + of.north * north + of.height * height + of.constant;
    };
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        for (const std::size_t count : {std::size_t{1}, std::size_t{8}, std::size_t{29}}) {
            std::uint32_t state = 3;
            std::vector<float> places;
            std::vector<float> heights;
            for (std::size_t i = 0; i < count; ++i) {
                places.push_back(next_share(state));
                places.push_back(next_share(state));
                heights.push_back(next_share(state));
            }
            triangle_vectors::Corners corners;
            corners.resize(count + 3);
            corners.x.back() = 77;
            place_corners(placed, places.data(), heights.data(), count, corners, 2);
            EXPECT_EQ(corners.x.back(), 77) << "written past the end";
            for (std::size_t i = 0; i < count; ++i) {
                const auto of = [&](const Linear& linear) {
                    return value(linear, places[2 * i], places[2 * i + 1], heights[i]);
                };
                const double depth = of(placed.depth);
                EXPECT_EQ(corners.x[i + 2], std::floor(of(placed.x) / depth + 0.5));
                EXPECT_EQ(corners.y[i + 2], std::floor(of(placed.y) / depth + 0.5));
                EXPECT_EQ(corners.nearness[i + 2], static_cast<float>(1.5 / depth));
            }
        }
    }
    vectors::use_target(vectors::targets().front());
}

}  // namespace
}  // namespace fumon::block_vectors
