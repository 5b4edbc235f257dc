#include "render/view/visible_sun.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fumon {
namespace {

constexpr double elevation = 0.1;  // radians, of a sun in the north

glm::dvec3 sun_in_the_north() {
    return {0.0, std::cos(elevation), std::sin(elevation)};
}

Camera camera_northward() {
    Camera camera;
    camera.right = {1.0, 0.0, 0.0};
    camera.up = {0.0, 0.0, 1.0};
    camera.forward = {0.0, 1.0, 0.0};
    camera.eye = {0.0, 0.0, 0.5};
    return camera;
}

/// Level ground, and from y = 2 on a plateau that looks so high from the eye, east of x.
RayGround plateau(double angle, double east_of = -10.0) {
    RayGround ground;
    const double top = 0.5 + 2.0 * std::tan(angle);
    ground.height = [=](const glm::dvec2& position) {
        return position.y >= 2.0 && position.x >= east_of ? top : 0.0;
    };
    ground.highest = std::max(top, 0.0);
    return ground;
}

TEST(VisibleSun, ItIsTheShareOfTheDiscAboveTheGround) {
    const Camera camera = camera_northward();
    const auto share = [&](const RayGround& ground) {
        return visible_sun_share(camera, sun_in_the_north(), ground, 0.0);
    };
    EXPECT_EQ(share(plateau(0.0)), 1.0);
    EXPECT_EQ(share(plateau(elevation - 1.1 * disc_radius)), 1.0);
    EXPECT_NEAR(share(plateau(elevation)), 0.5, 0.03);
    // A segment of a circle as high as half the radius: 1/3 − √3/(4π) of it.
    EXPECT_NEAR(share(plateau(elevation + 0.5 * disc_radius)), 0.1955, 0.03);
    EXPECT_NEAR(share(plateau(elevation - 0.5 * disc_radius)), 0.8045, 0.03);
    EXPECT_EQ(share(plateau(elevation + 1.1 * disc_radius)), 0.0);
    EXPECT_NEAR(share(plateau(elevation + 0.1, 0.0)), 0.5, 0.08) << "a wall before the right half";
}

TEST(VisibleSun, GroundSinksWithThePlanet) {
    const RayGround ground = plateau(elevation);
    const double sinks = 2.0 * disc_radius / 2.0;  // by a radius, at the plateau's edge
    EXPECT_NEAR(visible_sun_share(camera_northward(), sun_in_the_north(), ground, 0.5 * sinks), 1.0,
                0.02);
}

TEST(VisibleSun, ASunBehindTheCameraIsNotLookedFor) {
    Camera camera = camera_northward();
    camera.forward = {0.0, -1.0, 0.0};
    RayGround ground = plateau(1.0);
    EXPECT_EQ(visible_sun_share(camera, sun_in_the_north(), ground, 0.0), 1.0);
    camera.forward = {0.0, 1.0, 0.0};
    EXPECT_EQ(visible_sun_share(camera, sun_in_the_north(), ground, 0.0), 0.0);
    camera.perspective = false;
    EXPECT_EQ(visible_sun_share(camera, sun_in_the_north(), ground, 0.0), 1.0);
}

}  // namespace
}  // namespace fumon
