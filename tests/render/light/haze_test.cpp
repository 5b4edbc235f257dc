#include "render/light/haze.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/light/view_light.h"
#include "render/sky/desert_aerosol.h"

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

}  // namespace
}  // namespace fumon
