#include "render/ground/ground_vectors.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "render/ground/height_pyramid.h"
#include "render/view/tile_warp_vectors.h"
#include "vectors/target.h"

namespace fumon {
namespace {

using Numbers = std::array<double, ground_vectors::samples_per_batch>;

HeightPyramid rough_heights(const GroundTiles& tiles) {
    Field<float> heights(38, 21);
    std::uint32_t state = 4711;
    for (float& height : heights.values()) {
        state = state * 1664525U + 1013904223U;
        height = static_cast<float>(state >> 8U) * 0x1p-24F;
    }
    return HeightPyramid(heights, tiles);
}

void expect_looked_up(const GroundTiles& tiles) {
    const std::string before = vectors::target();
    const HeightPyramid bed = rough_heights(tiles);
    constexpr int count = 11;
    Numbers radii{};
    for (const int level : {0, 2}) {
        const Field<float>& means = bed.level(level);
        for (const double start : {0.01, 0.7, 300.0}) {
            for (std::size_t k = 0; k < radii.size(); ++k)
                radii[k] = start * (1.0 + 0.013 * static_cast<double>(k));
            Numbers east{};
            Numbers north{};
            for (std::size_t k = 0; k < radii.size(); ++k) {
                east[k] = 0.5 - radii[k] * 0.83;
                north[k] = 0.21 + radii[k] * 0.61;
            }
            const ground_vectors::Eye eye{0.37, 1e-4, 0.0};
            for (const std::string& target : vectors::targets()) {
                vectors::use_target(target);
                Numbers over{};
                Numbers tangents{};
                ground_vectors::evaluate({means.data(), means.nx(), means.ny(), tiles}, eye,
                                         {radii.data(), east.data(), north.data(), nullptr}, count,
                                         over.data(), tangents.data());
                for (std::size_t k = 0; k < count; ++k) {
                    const double radius = radii[k];
                    const auto height = static_cast<double>(bed.at(level, east[k], north[k]));
                    const double expected = height - radius * radius * eye.curvature - eye.height;
                    EXPECT_EQ(over[k], expected) << target << ", " << radius;
                    EXPECT_EQ(tangents[k], expected / radius) << target << ", " << radius;
                }
            }
        }
    }
    vectors::use_target(before);
}

TEST(GroundVectors, EveryTargetSeesWhatIsLookedUpPlaceByPlace) {
    expect_looked_up({});
}

TEST(GroundVectors, EveryTargetFindsTheSameFarCopies) {
    const std::string before = vectors::target();
    constexpr auto count = std::size_t{2} * ground_vectors::samples_per_batch;
    std::array<double, count> radii{};
    for (std::size_t k = 0; k < count; ++k) radii[k] = 0.1 + 0.7 * static_cast<double>(k);
    const ground_vectors::WarpedRay ray{0.1, -0.2, -0.83, 0.61, 0.83};
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        std::array<double, count> east{};
        std::array<double, count> north{};
        std::array<double, count> height{};
        ground_vectors::warp_along_ray(ray, radii.data(), static_cast<int>(count), east.data(),
                                       north.data(), height.data());
        for (std::size_t k = 0; k < count; ++k) {
            const WarpedGround copy =
                tile_warp::warp_at({ray.east + radii[k] * ray.east_per_length,
                                    ray.north + radii[k] * ray.north_per_length},
                                   ray.strength);
            EXPECT_EQ(glm::dvec2(east[k], north[k]), copy.offset) << target << ", " << radii[k];
            EXPECT_EQ(height[k], copy.height) << target << ", " << radii[k];
        }
    }
    vectors::use_target(before);
}

TEST(GroundVectors, HeightsCountFromTheMean) {
    const HeightPyramid bed = rough_heights({});
    const Field<float>& means = bed.level(0);
    Numbers radii{};
    Numbers east{};
    Numbers north{};
    radii.fill(1.7);
    east.fill(0.3);
    north.fill(0.8);
    Numbers raised{};
    raised.fill(0.67);
    raised[1] = 1.0;
    Numbers over{};
    Numbers tangents{};
    ground_vectors::evaluate({means.data(), means.nx(), means.ny(), {}}, {0.37, 0.0, 0.4},
                             {radii.data(), east.data(), north.data(), raised.data()}, 2,
                             over.data(), tangents.data());
    const auto height = static_cast<double>(bed.at(0, 0.3, 0.8));
    EXPECT_NEAR(over[0], 0.4 + 0.67 * (height - 0.4) - 0.37, 1e-12);
    EXPECT_EQ(over[1], height - 0.37);
}

TEST(GroundVectors, SeesABedInItsPlainAsItIsLookedUp) {
    expect_looked_up({true});
}

}  // namespace
}  // namespace fumon
