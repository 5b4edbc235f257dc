#include "wind/wind_rose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "wind/sand_flux.h"

namespace fumon {
namespace {

WindTable read(const std::string& text) {
    return read_wind_table({"rose.csv", text});
}

std::string refused(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "taken";
}

TEST(WindRose, IsReadInEachOfItsUnits) {
    for (const char* text : {"direction,speed,frequency\n270,10,.25\n360,0,.75\n",
                             "direction,speed_knots,percent\n270,19.438444924,25\n",
                             "direction,speed,hours\n270,10,2190\n10,0,6570\n",
                             "# observed\ndirection,speed\n270,10\n0,0\n0,0\n0,0\n"}) {
        const WindRose rose = read(text).rose;
        ASSERT_EQ(rose.size(), 1U) << text;
        EXPECT_EQ(rose[0].from, 270.0);
        EXPECT_NEAR(rose[0].speed, 10.0, 1e-8) << text;
        EXPECT_NEAR(rose[0].share, 0.25, 1e-12) << text;
    }
}

TEST(WindRose, MayGiveFrictionVelocities) {
    const WindRose rose = read("direction,friction_velocity,percent\n270,0.4,25\n90,0,75\n").rose;
    ASSERT_EQ(rose.size(), 1U);
    EXPECT_EQ(rose[0].friction_velocity, 0.4);
    const std::vector<SandFlux> fluxes = saturated_fluxes(rose, SandAndAir{});
    ASSERT_EQ(fluxes.size(), 1U);
    EXPECT_NEAR(fluxes[0].amount, 288.068 / 4.0, 1e-3);
    EXPECT_NE(refused("direction,speed,friction_velocity\n1,3,4\n").find("keep one"),
              std::string::npos);
    EXPECT_NE(refused("direction,friction_velocity\n1,30\n").find("'30'"), std::string::npos);
}

/// u* = 0.4 U / ln(height / roughness).
TEST(SandFlux, SpeedsAreOfAnyHeight) {
    const double low = 0.4 / 0.4 * std::log(3.0 / 1e-3);
    const double high = 0.4 / 0.4 * std::log(10.0 / 1e-3);
    const SandAndAir earth;
    EXPECT_NEAR(saturated_fluxes({{90.0, low, 1.0}}, earth, 3.0).at(0).amount,
                saturated_fluxes({{90.0, high, 1.0}}, earth).at(0).amount, 1e-6);
}

TEST(WindRose, MayGiveTheSandItself) {
    const WindTable table = read("direction,flux\n270,2\n30,0\n150,1\n");
    EXPECT_TRUE(table.rose.empty());
    ASSERT_EQ(table.fluxes.size(), 2U);
    EXPECT_EQ(table.fluxes[0].toward, 90.0);
    EXPECT_EQ(table.fluxes[1].toward, 330.0);
}

TEST(WindRose, RefusesWhatIsNone) {
    EXPECT_NE(refused("speed,frequency\n1,1\n").find("no column \"direction\""), std::string::npos);
    EXPECT_NE(refused("direction,speed,gusts\n1,1,1\n").find("'gusts'"), std::string::npos);
    EXPECT_NE(refused("direction,speed\n1,3\n361,3\n").find("rose.csv:3: direction is '361'"),
              std::string::npos);
    EXPECT_NE(refused("direction,speed\nnorth,3\n").find("direction is 'north'"),
              std::string::npos);
    EXPECT_NE(refused("direction,speed,frequency\n1,3,.7\n2,3,.7\n").find("140.0 %"),
              std::string::npos);
    EXPECT_NE(refused("direction,speed,frequency,hours\n1,3,.7,4\n").find("keep one"),
              std::string::npos);
    EXPECT_NE(refused("direction,speed,speed_knots\n1,3,4\n").find("keep one"), std::string::npos);
    EXPECT_NE(refused("direction,speed\n1,0\n").find("no wind blows"), std::string::npos);
    EXPECT_NE(refused("direction,flux,speed\n1,1,3\n").find("beside direction"), std::string::npos);
}

/// The weighting factors of Fryberger & Dean (1979) for the middles of three classes of speed.
TEST(SandFlux, OfFrybergersLawIsInVectorUnits) {
    const double knot = 1852.0 / 3600.0;  // m/s
    const std::pair<double, double> weights[] = {{13.5, 2.7}, {19.0, 25.3}, {24.5, 75.0}};
    for (const auto& [knots, weight] : weights) {
        const std::vector<SandFlux> fluxes =
            fryberger_fluxes({{270.0, knots * knot, 0.1}, {0.0, 12.0 * knot, 0.5}}, 12.0);
        ASSERT_EQ(fluxes.size(), 1U);
        EXPECT_EQ(fluxes[0].toward, 90.0);
        EXPECT_NEAR(fluxes[0].amount, 10.0 * weight, 0.5);
    }
}

/// Of the equations of Sauermann, Kroy & Herrmann (2001) with the constants of Durán & Moore
/// (2013).
TEST(SandFlux, IsSaturatedAsPublished) {
    const SandAndAir earth;
    EXPECT_NEAR(impact_threshold(earth), 0.2025, 1e-4);
    const std::pair<double, double> expected[] = {
        {0.25, 0.00252}, {0.30, 0.00590}, {0.35, 0.01007}, {0.40, 0.01506}, {0.50, 0.02772}};
    for (const auto& [velocity, flux] : expected)
        EXPECT_NEAR(saturated_flux(earth, velocity), flux, 0.6e-5) << velocity;
    EXPECT_EQ(saturated_flux(earth, 0.2), 0.0);
}

TEST(SandFlux, OfAYearIsInSquareMetresOfBed) {
    const SandAndAir earth;
    const double speed = 0.4 / 0.4 * std::log(10.0 / earth.roughness);  // whose u* is 0.4 m/s
    const std::vector<SandFlux> fluxes = saturated_fluxes({{90.0, speed, 0.5}}, earth);
    ASSERT_EQ(fluxes.size(), 1U);
    EXPECT_EQ(fluxes[0].toward, 270.0);
    EXPECT_NEAR(fluxes[0].amount, 287.9 / 2.0, 0.2);
}

}  // namespace
}  // namespace fumon
