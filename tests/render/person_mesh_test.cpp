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
        for (const PersonVertex& corner : person_mesh(figure)) {
            highest = std::max(highest, corner.position.z);
            lowest = std::min(lowest, corner.position.z);
            aside = std::max(aside, static_cast<double>(glm::length(glm::vec2(corner.position))));
            EXPECT_NEAR(glm::length(corner.normal), 1.0F, 1e-4F);
        }
        EXPECT_NEAR(highest, figure.height, 1e-4) << number;
        EXPECT_NEAR(lowest, 0.0F, 1e-5F) << number;
        EXPECT_LT(aside, 0.5) << number;
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
