#include "render/life/person_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace fumon {
namespace {

TEST(PersonMesh, StandsOnTheGroundAtItsHeight) {
    for (std::size_t number = 0; number < 40; ++number) {
        const PersonFigure figure = person_figure(number);
        if (number == 0) {
            EXPECT_EQ(figure.height, person_height);
        }
        EXPECT_GE(figure.height, 1.58);
        EXPECT_LE(figure.height, 1.90);
        float highest = 0.0F;
        float lowest = 1.0F;
        double aside = 0.0;
        const BodyMesh mesh = person_mesh(figure);
        for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.corners.size());
        EXPECT_EQ(mesh.indices.size() % 3, 0U);
        for (const BodyCorner& corner : mesh.corners) {
            highest = std::max(highest, corner.position.z);
            lowest = std::min(lowest, corner.position.z);
            aside = std::max(aside, static_cast<double>(glm::length(glm::vec2(corner.position))));
            EXPECT_NEAR(glm::length(corner.normal), 1.0F, 1e-4F);
        }
        EXPECT_NEAR(highest, figure.height, 1e-4) << number;
        EXPECT_NEAR(lowest, 0.0F, 1e-5F) << number;
        EXPECT_LT(aside, 0.55) << number;
    }
}

/// Its surface looks outward: the volume that its triangles enclose is that of a body, in which
/// parts that overlap count twice.
TEST(PersonMesh, EnclosesABody) {
    for (std::size_t number = 0; number < 12; ++number) {
        const BodyMesh mesh = person_mesh(person_figure(number));
        double volume = 0.0;  // cubic metres
        double outward = 0.0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) -> const BodyCorner& {
                return mesh.corners[mesh.indices[i + k]];
            };
            const glm::dvec3 a(corner(0).position);
            const glm::dvec3 b(corner(1).position);
            const glm::dvec3 c(corner(2).position);
            const glm::dvec3 area = glm::cross(b - a, c - a);
            volume += glm::dot(a, area) / 6.0;
            outward += glm::dot(area, glm::dvec3(corner(0).normal)) / glm::length(area + 1e-12);
        }
        EXPECT_GT(volume, 0.06) << number;
        EXPECT_LT(volume, 0.25) << number;
        EXPECT_GT(outward / (static_cast<double>(mesh.indices.size()) / 3.0), 0.85) << number;
    }
}

TEST(PersonMesh, NoTwoAreAlike) {
    std::set<double> heights;
    std::set<double> strides;
    std::set<double> facings;
    std::set<float> shirts;
    constexpr std::size_t persons = 12;
    for (std::size_t number = 0; number < persons; ++number) {
        const PersonFigure figure = person_figure(number);
        heights.insert(figure.height);
        strides.insert(figure.leading * figure.stride);
        facings.insert(person_facing(number));
        shirts.insert(figure.shirt.x);
        EXPECT_NEAR(person_facing(number), 180.0, 120.0);
    }
    EXPECT_EQ(heights.size(), persons);
    EXPECT_EQ(strides.size(), persons);
    EXPECT_EQ(facings.size(), persons);
    EXPECT_GT(shirts.size(), 4U);
    EXPECT_EQ(person_facing(0), 180.0);
}

}  // namespace
}  // namespace fumon
