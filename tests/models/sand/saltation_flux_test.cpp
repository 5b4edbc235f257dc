#include "models/sand/saltation_flux.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/sand/row_hops.h"

namespace fumon {
namespace {

Grid wave() {
    Grid bed(40, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 40; ++x) bed(x, y) = 2.0 + 1.5 * std::sin(0.157079632679 * x);
    return bed;
}

TEST(SaltationFlux, IsOneOverLevelSand) {
    const SandParameters parameters;
    const Grid flux = saltation_flux(parameters, Grid(10, 4, 1.3));
    for (const double there : flux.values()) EXPECT_DOUBLE_EQ(there, 1.0);
}

TEST(SaltationFlux, IsAmountTimesLengthOfHops) {
    SandParameters parameters;
    parameters.hop_length = HopLength::linear;
    const Grid bed = wave();
    const Grid flux = saltation_flux(parameters, bed);
    const double level = parameters.hop_base + parameters.hop_per_height * 2.0;
    for (int x = 0; x < 40; ++x) {
        const double length = parameters.hop_base + parameters.hop_per_height * bed(x, 1);
        EXPECT_NEAR(flux(x, 1), length / level, 1e-12) << x;
    }
    EXPECT_GT(flux(10, 0), 1.3);  // the crest
    EXPECT_LT(flux(30, 0), 0.7);
}

TEST(SaltationFlux, FollowsSlopesAsHopsDo) {
    SandParameters parameters;
    parameters.hop_length = HopLength::slope;
    parameters.hop_amount = HopAmount::slope;
    const Grid bed = wave();
    const Grid flux = saltation_flux(parameters, bed);
    const double slope = 0.5 * (bed(2, 0) - bed(0, 0));
    const double amount = parameters.amount + parameters.amount_slope_factor * std::tanh(slope);
    const RowHops hops(parameters, 40);
    EXPECT_NEAR(
        flux(1, 0),
        amount * hops.length(bed(1, 0), slope) / (parameters.amount * hops.length(2.0, 0.0)),
        1e-12);
}

TEST(SaltationFlux, IsNoneWhereNoSandIs) {
    SandParameters parameters;
    Grid bed = wave();
    bed(5, 1) = 0.0;
    EXPECT_EQ(saltation_flux(parameters, bed)(5, 1), 0.0);
    const Grid bare = saltation_flux(parameters, Grid(10, 4, 0.0));
    for (const double there : bare.values()) EXPECT_EQ(there, 0.0);
}

}  // namespace
}  // namespace fumon
