#include "render/ground/ground_vectors.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "render/ground/height_pyramid.h"
#include "render/view/far_copies_vectors.h"
#include "vectors/target.h"

namespace fumon {
namespace {

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
    std::array<double, ground_vectors::places_at_once> radii{};
    for (const int level : {0, 2}) {
        const Field<float>& means = bed.level(level);
        for (const double start : {0.01, 0.7, 300.0}) {
            for (std::size_t k = 0; k < radii.size(); ++k)
                radii[k] = start * (1.0 + 0.013 * static_cast<double>(k));
            const ground_vectors::Ray ray{0.5, 0.21, -0.83, 0.61, 0.37, 1e-4};
            for (const std::string& target : vectors::targets()) {
                vectors::use_target(target);
                std::array<double, ground_vectors::places_at_once> over{};
                std::array<double, ground_vectors::places_at_once> tangents{};
                ground_vectors::look_along({means.data(), means.nx(), means.ny(), tiles}, ray,
                                           radii.data(), count, over.data(), tangents.data());
                for (std::size_t k = 0; k < count; ++k) {
                    const double radius = radii[k];
                    const auto height =
                        static_cast<double>(bed.at(level, ray.east + radius * ray.east_per_length,
                                                   ray.north + radius * ray.north_per_length));
                    const double expected =
                        height - radius * radius * ray.curvature - ray.eye_height;
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

TEST(GroundVectors, EveryTargetSeesTheSameFarCopies) {
    const std::string before = vectors::target();
    const HeightPyramid bed = rough_heights({});
    const Field<float>& means = bed.level(0);
    std::array<double, ground_vectors::places_at_once> radii{};
    for (std::size_t k = 0; k < radii.size(); ++k) radii[k] = 1.1 + 0.7 * static_cast<double>(k);
    const ground_vectors::Ray ray{0.5, 0.21, -0.83, 0.61, 0.37, 1e-4, 0.1, -0.2, 0.4, 0.83};
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        std::array<double, ground_vectors::places_at_once> over{};
        std::array<double, ground_vectors::places_at_once> tangents{};
        ground_vectors::look_along({means.data(), means.nx(), means.ny(), {}}, ray, radii.data(),
                                   ground_vectors::places_at_once, over.data(), tangents.data());
        for (std::size_t k = 0; k < radii.size(); ++k) {
            const glm::dvec2 way = radii[k] * glm::dvec2(ray.east_per_length, ray.north_per_length);
            const GroundCopy copy = far_copies::copy_at(
                glm::dvec2(ray.from_middle_east, ray.from_middle_north) + way, ray.strength);
            const auto height = static_cast<double>(
                bed.at(0, ray.east + way.x + copy.aside.x, ray.north + way.y + copy.aside.y));
            const double stands = ray.mean + copy.height * (height - ray.mean);
            EXPECT_EQ(over[k], stands - radii[k] * radii[k] * ray.curvature - ray.eye_height)
                << target << ", " << radii[k];
        }
    }
    vectors::use_target(before);
}

TEST(GroundVectors, SeesABedInItsPlainAsItIsLookedUp) {
    expect_looked_up({true});
}

}  // namespace
}  // namespace fumon
