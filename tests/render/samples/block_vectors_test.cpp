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
    const VertexProjection projection{{256000.0, 12000.0, -3000.0, 7000.0},
                                      {-900.0, 301000.0, 88000.0, 100.0},
                                      {0.0, 0.0, 0.0, 1.5},
                                      {0.4, -0.3, 0.2, 2.0},
                                      0.1};
    const auto value = [](const AffineFunction& of, double east, double north, double height) {
        return of.east * east + of.north * north + of.height * height + of.constant;
    };
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        for (const std::size_t count : {std::size_t{1}, std::size_t{8}, std::size_t{29}}) {
            std::uint32_t state = 3;
            std::vector<float> positions;
            std::vector<float> heights;
            for (std::size_t i = 0; i < count; ++i) {
                positions.push_back(next_share(state));
                positions.push_back(next_share(state));
                heights.push_back(next_share(state));
            }
            rasteriser_vectors::ProjectedVertices vertices;
            vertices.resize(count + 3);
            vertices.x.back() = 77;
            project_vertices(projection, positions.data(), heights.data(), count, vertices, 2);
            EXPECT_EQ(vertices.x.back(), 77) << "written past the end";
            for (std::size_t i = 0; i < count; ++i) {
                const auto of = [&](const AffineFunction& linear) {
                    return value(linear, positions[2 * i], positions[2 * i + 1], heights[i]);
                };
                const double depth = of(projection.depth);
                EXPECT_EQ(vertices.x[i + 2], std::floor(of(projection.x) / depth + 0.5));
                EXPECT_EQ(vertices.y[i + 2], std::floor(of(projection.y) / depth + 0.5));
                EXPECT_EQ(vertices.reversed_z[i + 2], static_cast<float>(1.5 / depth));
            }
        }
    }
    vectors::use_target(vectors::targets().front());
}

}  // namespace
}  // namespace fumon::block_vectors
