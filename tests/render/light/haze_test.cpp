#include "render/light/haze.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gl/context.h"
#include "render/light/view_light.h"
#include "render/sky/desert_aerosol.h"
#include "support/shader_values.h"

namespace fumon {
namespace {

View endless_view() {
    View view;
    view.look.ground = Ground::endless;
    return view;
}

TEST(Haze, FollowsTheVisibilityThatAViewAsksFor) {
    View view = endless_view();
    view.air.visibility = 8.0;
    EXPECT_NEAR(std::exp(-3.0 * haze_of(view, Block{}).per_kilometre), std::exp(-3.912 * 3.0 / 8.0),
                1e-12);
}

TEST(Haze, IsADesertsOverEndlessGroundOnEarthAlone) {
    View view = endless_view();
    EXPECT_EQ(chosen_aerosol(view), Aerosol::desert);
    EXPECT_NEAR(haze_of(view, Block{}).per_kilometre, 3.912 / desert_aerosol::clear_visibility,
                1e-12);
    view.air.planet = Planet::mars;
    EXPECT_EQ(chosen_aerosol(view), Aerosol::thin);
    view.air.planet = Planet::earth;
    view.look.ground = Ground::table;
    EXPECT_EQ(chosen_aerosol(view), Aerosol::thin);
}

TEST(Haze, OfThinAirIsThatOfEarlierVersions) {
    View view = endless_view();
    view.air.aerosol = Aerosol::thin;
    view.sun.dust = 4.0;
    const Haze haze = haze_of(view, Block{});
    EXPECT_DOUBLE_EQ(haze.per_kilometre, 3.912 / 20.0);
    EXPECT_EQ(haze.bands, glm::dvec3(1.0));
    EXPECT_EQ(extinction_from({0.0, 0.0, 0.5}, haze, view, Block{}), haze.per_kilometre);
    view.air.aerosol = Aerosol::desert;
    const Haze desert = haze_of(view, Block{});
    EXPECT_LT(extinction_from({0.0, 0.0, 0.5}, desert, view, Block{}), 0.75 * desert.per_kilometre)
        << "thinner from above";
}

/// What is seen through the air before ground with a share of the sun, which stands 0.1 high for
/// each length along; shade reaches up to a height of 2.
float haze_before(glm::vec3 way, float sun, float shaded_height = 2.0F) {
    return shader_values("light/hazed.frag.glsl", 1, 1, {},
                         [&](const gl::Program& program) {
                             program.set("to_sun", glm::normalize(glm::vec3(0.0F, 1.0F, 0.1F)));
                             program.set("atmosphere", 0.0F);
                             program.set("haze_colour", glm::vec3(1.0F));
                             program.set("glow_colour", glm::vec3(1.0F));
                             program.set("shaded_height", shaded_height);
                             program.set("way", way);
                             program.set("sun", sun);
                         })
        .front()
        .r;
}

TEST(Haze, IsLessBeforeGroundInTheShade) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    EXPECT_FLOAT_EQ(haze_before({0.0F, 10.0F, 0.0F}, 1.0F), 1.0F) << "in the sun";
    EXPECT_FLOAT_EQ(haze_before({0.0F, 10.0F, 0.0F}, 0.0F), 0.3F) << "all of it in the shade";
    EXPECT_NEAR(haze_before({0.0F, 40.0F, 0.0F}, 0.0F), 0.65F, 1e-5F) << "half of it";
    EXPECT_NEAR(haze_before({0.0F, 400.0F, 0.0F}, 0.0F), 0.965F, 1e-5F) << "far";
    EXPECT_NEAR(haze_before({0.0F, 40.0F, 0.0F}, 0.5F), 0.825F, 1e-5F) << "half in the shade";
    EXPECT_NEAR(haze_before({0.0F, 6.0F, -8.0F}, 0.0F), 0.825F, 1e-5F) << "from above";
    EXPECT_FLOAT_EQ(haze_before({0.0F, 10.0F, 0.0F}, 0.0F, 0.0F), 1.0F) << "where it is not known";
}

}  // namespace
}  // namespace fumon
