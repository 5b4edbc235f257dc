#include "render/light/exposure_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>

#include "base/units.h"

namespace fumon {
namespace {

Light morning(double elevation = 8.0) {
    SunSettings sun;
    sun.azimuth = 90.0;
    sun.elevation = elevation;
    return make_atmospheric_light(sun, Planet::earth, 0.0, Aerosol::desert);
}

/// Degrees from north over east, and above the horizon.
Camera looking(double azimuth, double elevation = 0.0) {
    const double a = azimuth * degree;
    const double e = elevation * degree;
    Camera camera;
    camera.forward = {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
    camera.right = {std::cos(a), -std::sin(a), 0.0};
    camera.up = glm::cross(camera.right, camera.forward);
    camera.half = {0.36, 0.2};
    return camera;
}

TEST(ExposureMeter, TakesADarkerPictureTowardALowSun) {
    const Light light = morning();
    EXPECT_LT(exposure_under_sky(light, looking(90.0)), 0.65);
    EXPECT_GT(exposure_under_sky(light, looking(90.0)), 0.4);
    EXPECT_GT(exposure_under_sky(light, looking(180.0)), 0.85);
    EXPECT_GT(exposure_under_sky(light, looking(270.0)), 0.8);
    EXPECT_GT(exposure_under_sky(morning(60.0), looking(90.0)), 0.93);
}

/// A camera that turns has no jump in its film, and one that looks down nothing to do with the sky.
TEST(ExposureMeter, ChangesSmoothlyAsTheCameraTurns) {
    const Light light = morning();
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 1.0) {
        EXPECT_NEAR(exposure_under_sky(light, looking(azimuth)),
                    exposure_under_sky(light, looking(azimuth + 1.0)), 0.02)
            << azimuth;
    }
    for (double elevation = -40.0; elevation < 20.0; elevation += 0.5) {
        EXPECT_NEAR(exposure_under_sky(light, looking(90.0, elevation)),
                    exposure_under_sky(light, looking(90.0, elevation + 0.5)), 0.03)
            << elevation;
    }
    EXPECT_EQ(exposure_under_sky(light, looking(90.0, -40.0)), 1.0);
    Camera map = looking(90.0);
    map.perspective = false;
    EXPECT_EQ(exposure_under_sky(light, map), 1.0);
}

}  // namespace
}  // namespace fumon
