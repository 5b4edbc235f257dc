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

TEST(NearestName, OfALongTextIsFoundAtOnce) {
    const std::vector<std::string> many(1000, "figure.panel.0.curve.0.spread");
    const std::string long_name(1 << 20, 'a');
    EXPECT_EQ(nearest_name(long_name, many), "");  // 3e10 comparisons else
    EXPECT_EQ(nearest_name("abcd", {"badc", "abdc"}), "abdc");
    EXPECT_EQ(nearest_name("badcfe", {"abcdef"}), "") << "three swaps of six letters";
    EXPECT_EQ(nearest_name("badcefghi", {"abcdefghi"}), "abcdefghi");
}

}  // namespace
}  // namespace fumon
