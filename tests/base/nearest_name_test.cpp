#include "base/nearest_name.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

const std::vector<std::string> known{"camera.azimuth", "sun.azimuth", "sun.elevation", "seed"};

TEST(NearestName, FindsMissingSwappedAndWrongLetters) {
    EXPECT_EQ(nearest_name("sun.azimut", known), "sun.azimuth");
    EXPECT_EQ(nearest_name("sun.elevatoin", known), "sun.elevation");
    EXPECT_EQ(nearest_name("Seed", known), "seed");
    EXPECT_EQ(nearest_name("cemera.azimuth", known), "camera.azimuth");
}

TEST(NearestName, FindsNothingFarOff) {
    EXPECT_EQ(nearest_name("wind", known), "");
    EXPECT_EQ(nearest_name("camera.target", {"camera.margin"}), "") << "half of the letters differ";
    EXPECT_EQ(nearest_name("jet", {"grey", "vik"}), "");
    EXPECT_EQ(suggestion("wind", {"a", "b"}), "known: a, b");
}

}  // namespace
}  // namespace fumon
