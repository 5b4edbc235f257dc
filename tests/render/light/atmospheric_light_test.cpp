#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "base/elementary.h"
#include "base/units.h"
#include "render/light/light.h"
#include "render/sky/atmosphere.h"
#include "render/sky/sky_tables.h"

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

TEST(AtmosphericLight, AClearDayIsThatOfTheTables) {
    const AirTables air(dusty_air(1.0, {0.42, 0.30, 0.18}));
    const SkyView sky(air, 45.0 * degree, 0.002);
    EXPECT_EQ(clear_day, sky.sun() * elementary::sin(45.0 * degree) + sky.level_irradiance());
}

TEST(AtmosphericLight, DustTakesTheBlueOutOfTheSky) {
    SunSettings sun;
    const Light clear = make_atmospheric_light(sun);
    sun.dust = 10.0;
    const Light dusty = make_atmospheric_light(sun);
    EXPECT_LT(blue_over_red(dusty.sky), 0.8 * blue_over_red(clear.sky));
}

TEST(AtmosphericLight, IsThatOfItsAirWhateverOtherAirWasAskedForBefore) {
    SunSettings low;
    low.elevation = 8.0;
    SunSettings dusty = low;
    dusty.dust = 4.0;
    const Light before = make_atmospheric_light(low);
    const Light other = make_atmospheric_light(dusty);
    const Light mars = make_atmospheric_light(dusty, Planet::mars);
    EXPECT_NE(other.sky_texels, before.sky_texels);
    EXPECT_NE(mars.sky_texels, other.sky_texels);
    EXPECT_EQ(make_atmospheric_light(dusty).sky_texels, other.sky_texels);
}

TEST(AtmosphericLight, MarsHasAWarmSkyAndABlueGlowAroundALowSun) {
    SunSettings sun;
    sun.elevation = 5.0;
    const Light light = make_atmospheric_light(sun, Planet::mars);
    const auto texel = [&](double azimuth_root) {  // along the sun's height
        const auto row = static_cast<std::size_t>(std::sqrt(5.0 / 90.0) * (light.sky_rows - 1));
        const auto column = static_cast<std::size_t>(azimuth_root * (light.sky_columns - 1));
        return glm::vec3(
            light.sky_texels.at(row * static_cast<std::size_t>(light.sky_columns) + column));
    };
    EXPECT_GT(blue_over_red(texel(0.0)), 1.5 * blue_over_red(texel(0.7)));
    EXPECT_LT(blue_over_red(texel(0.7)), 0.7);
    EXPECT_LT(blue_over_red(light.sky), blue_over_red(make_atmospheric_light(sun).sky));
}

TEST(AtmosphericLight, MoonlightIsDarkBluishAndNearlyWithoutColour) {
    SunSettings lamp;
    const Light day = make_atmospheric_light(lamp);
    lamp.source = LightSource::moon;
    const Light night = make_atmospheric_light(lamp);
    EXPECT_TRUE(night.stars);
    EXPECT_FALSE(day.stars);
    EXPECT_LT(night.sun.g, 0.3F * day.sun.g);
    EXPECT_GT(blue_over_red(night.sun), 2.0 * blue_over_red(day.sun));
    // Sun and sky differ less in colour than by day.
    EXPECT_LT(blue_over_red(night.sky) / blue_over_red(night.sun),
              0.6 * blue_over_red(day.sky) / blue_over_red(day.sun));
}

}  // namespace
}  // namespace fumon
