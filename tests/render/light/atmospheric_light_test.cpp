#include <gtest/gtest.h>

#include "render/light/light.h"

namespace fumon {
namespace {

double blue_over_red(const glm::vec3& colour) {
    return static_cast<double>(colour.b) / static_cast<double>(colour.r);
}

TEST(AtmosphericLight, ShadowsAreBlueAndTheSunWarmsAsItSinks) {
    SunSettings sun;
    sun.elevation = 45.0;
    const Light noon = make_atmospheric_light(sun);
    sun.elevation = 8.0;
    const Light evening = make_atmospheric_light(sun);
    EXPECT_GT(blue_over_red(noon.sky), 1.8 * blue_over_red(noon.sun));
    EXPECT_LT(blue_over_red(evening.sun), 0.5 * blue_over_red(noon.sun));
    EXPECT_GT(blue_over_red(evening.sky), 3.0 * blue_over_red(evening.sun));
    const glm::vec3 toward_sun = evening.sky_lean[0];
    EXPECT_GT(toward_sun.r, toward_sun.b) << "the sun's side of the sky is the redder";
}

TEST(AtmosphericLight, DustTakesTheBlueOutOfTheSky) {
    SunSettings sun;
    const Light clear = make_atmospheric_light(sun);
    sun.dust = 10.0;
    const Light dusty = make_atmospheric_light(sun);
    EXPECT_LT(blue_over_red(dusty.sky), 0.8 * blue_over_red(clear.sky));
}

}  // namespace
}  // namespace fumon
