#include "render/light/exposure_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <memory>
#include <numeric>

#include "base/units.h"
#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/ready_picture.h"
#include "render/renderer.h"
#include "render/view/framing.h"
#include "support/drawn_picture.h"
#include "support/repeated_dunes.h"
#include "support/view_beds.h"

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

/// A run's camera that turns away from the sun does not let more light in.
TEST(ExposureMeter, ARunHasOneExposure) {
    View view = small_view(80, 60);
    view.look.ground = Ground::endless;
    view.camera.azimuth = 270.0;  // from where it looks east at first
    view.camera.elevation = 4.0;
    view.camera.turn = 180.0;
    view.sun.azimuth = 90.0;
    view.sun.elevation = 8.0;
    const auto bed = std::make_shared<Snapshot>(repeated_dunes(60, 50));
    bed->step = 100;
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer renderer(*context, view, *bed, 100, pool);
    const Image run = renderer.render(*bed);
    const Block block = framed_block(view, *bed);
    FramePose pose{camera_at_step(view, block, 100, 100), view.sun};
    const auto posed = [&] { return renderer.render(renderer.ready(bed, pose, nullptr, pool)); };
    const Image by_its_own = posed();
    pose.metered = camera_at_step(view, block, 0, 100);
    EXPECT_TRUE(posed().rgb == run.rgb);
    const auto brightness = [](const Image& image) {
        const double sum = std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0);
        return sum / static_cast<double>(image.rgb.size());
    };
    EXPECT_GT(brightness(by_its_own), brightness(run) + 10.0);
}

}  // namespace
}  // namespace fumon
