// Water that a scene sets up: where it lies, what comes in and goes, what the ground takes.

#include "models/water/water_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "support/grid_values.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

TEST(WaterSetup, RegionsLieOverEachOther) {
    WaterParameters water;
    water.initial_water = InitialWater::surface;
    water.surface = 0.25;
    RegionSettings pool;
    pool.window = {2.0, 0.0, 6.0, 2.0};
    pool.depth = 1.5;
    pool.velocity_x = -0.5;
    RegionSettings lake;
    lake.window = {5.0, 1.0, 8.0, 4.0};
    lake.level = 0.75;
    water.regions = {pool, lake};
    Grid bed(8, 4);
    bed(0, 0) = 0.5;
    bed(7, 3) = 0.9;
    const GullyRun run(water, bed, 1);
    const Grid depth = run.field("water_depth");
    EXPECT_EQ(depth(0, 0), 0.0);
    EXPECT_EQ(depth(1, 0), 0.25);
    EXPECT_EQ(depth(2, 0), 1.5);
    EXPECT_EQ(depth(5, 1), 0.75);
    EXPECT_EQ(depth(7, 3), 0.0);
    EXPECT_EQ(run.field("velocity_x")(3, 1), -0.5);
    EXPECT_EQ(run.field("velocity_x")(5, 1), 0.0);
}

TEST(WaterSetup, AHydrographBringsItsVolume) {
    WaterParameters water;
    water.time_step = 1.0;
    EdgeSettings in = edge(GridSide::south, EdgeFlow::discharge);
    in.from = 2.0;
    in.to = 6.0;
    in.times = {0.0, 20.0, 40.0};
    in.values = {0.0, 3.0, 0.0};
    water.edges = {in};
    GullyRun run(water, Grid(12, 9), 2);
    run.to(10.0);
    EXPECT_NEAR(run.number("entered_volume"), 7.5, 1e-3);
    EXPECT_GT(run.field("velocity_y")(4, 0), 0.0);
    EXPECT_LT(run.field("water_depth")(11, 8), 1e-9);
    run.to(50.0);
    EXPECT_NEAR(run.number("entered_volume"), 60.0, 1e-2);
    EXPECT_NEAR(run.number("water_volume"), run.number("entered_volume"), 1e-11);
    EXPECT_EQ(run.number("left_volume"), 0.0);
    EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-13);
}

TEST(WaterSetup, EveryEdgeHasAKindOfItsOwn) {
    WaterParameters water;
    water.time_step = 1.0;
    water.initial_water = InitialWater::film;
    water.depth = 0.5;
    EdgeSettings gate = edge(GridSide::north, EdgeFlow::open);
    gate.to = 3.0;
    water.edges = {edge(GridSide::west, EdgeFlow::discharge, 4.0),
                   edge(GridSide::east, EdgeFlow::level, 0.3), gate};
    GullyRun run(water, noise(20, 16, 0.2), 2);
    run.to(30.0);
    EXPECT_NEAR(run.number("entered_volume"), 120.0, 1e-9);
    EXPECT_GT(run.number("left_volume"), 100.0);
    EXPECT_GE(run.lowest_depth(), 0.0);
    EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-13);
    EXPECT_GT(run.field("velocity_y")(1, 15), 0.1) << "out of the gate";
    EXPECT_LT(std::fabs(run.field("velocity_y")(12, 15)), 0.1) << "at the wall";
}

TEST(WaterSetup, EdgesGiveTheSameBytesForAnyNumberOfThreadsAndOnExchangedAxes) {
    const Grid bed = noise(30, 30, 0.4);
    const auto flow = [&](int threads, bool exchanged) {
        WaterParameters water;
        water.friction = FrictionLaw::manning;
        water.substeps = Substeps::fixed;
        water.time_step = 0.02;
        water.edges = {edge(exchanged ? GridSide::south : GridSide::west, EdgeFlow::discharge, 9.0),
                       edge(exchanged ? GridSide::north : GridSide::east, EdgeFlow::level, 0.4)};
        Grid ground = bed;
        for (int y = 0; y < 30 && exchanged; ++y) {
            for (int x = 0; x < 30; ++x) ground(x, y) = bed(y, x);
        }
        GullyRun run(water, ground, threads);
        for (int step = 0; step < 150; ++step) run.gully.step();
        return run.field("water_depth");
    };
    const Grid one = flow(1, false);
    EXPECT_GT(sum(one), 10.0);
    EXPECT_EQ(one, flow(3, false));
    const Grid other = flow(2, true);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 30; ++x) ASSERT_EQ(one(x, y), other(y, x)) << x << ' ' << y;
    }
}

TEST(WaterSetup, WideGridsHaveNoSeamAtTheirEdges) {
    const auto flow = [&](int nx, int ny, bool wide) {
        WaterParameters water;
        water.substeps = Substeps::fixed;
        water.time_step = 0.05;
        water.initial_water = InitialWater::film;
        water.depth = 0.002;  // so little that cells cannot pay in full
        water.edges = {edge(wide ? GridSide::south : GridSide::west, EdgeFlow::discharge, 60.0),
                       edge(wide ? GridSide::north : GridSide::east, EdgeFlow::level, 0.02)};
        Grid bed(nx, ny);
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x)
                bed(x, y) = 0.01 * ((7 * (wide ? x : y) + 13 * (wide ? y : x)) % 17);
        }
        GullyRun run(water, bed, 2);
        for (int step = 0; step < 40; ++step) run.gully.step();
        return run.field("water_depth");
    };
    const Grid wide = flow(1030, 7, true);
    const Grid tall = flow(7, 1030, false);
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 1030; ++x) ASSERT_EQ(wide(x, y), tall(y, x)) << x;
    }
}

TEST(WaterSetup, FilmsReachTheSpeedOfTheirFriction) {
    const double depth = 0.2;
    const double slope = 0.01;
    for (const FrictionLaw law : {FrictionLaw::manning, FrictionLaw::chezy}) {
        WaterParameters water;
        water.friction = law;
        water.edges_x = water.edges_y = EdgeKind::periodic;
        water.initial_water = InitialWater::film;
        water.depth = depth;
        water.slope_x = slope;
        water.initial_flow = InitialFlow::rest;
        water.time_step = 10.0;
        const double speed = law == FrictionLaw::manning
                                 ? std::pow(depth, 2.0 / 3.0) * std::sqrt(slope) / water.manning
                                 : water.chezy * std::sqrt(depth * slope);
        GullyRun run(water, Grid(8, 5), 1);
        run.to(300.0);
        EXPECT_NEAR(run.field("velocity_x")(3, 2), speed, 1e-6 * speed);
        EXPECT_EQ(run.field("velocity_y")(3, 2), 0.0);
        water.initial_flow = InitialFlow::uniform;
        const GullyRun uniform(water, Grid(8, 5), 1);
        EXPECT_NEAR(uniform.field("velocity_x")(3, 2), speed, 1e-12);
    }
}

TEST(WaterSetup, RainFollowsItsTable) {
    WaterParameters water;
    water.time_step = 4.0;
    water.rain_times = {10.0, 20.0, 50.0};
    water.rain_rates = {36.0, 72.0, 0.0};
    GullyRun run(water, Grid(5, 4), 1);
    run.to(100.0);
    EXPECT_NEAR(run.number("rain_volume"), 20.0 * (10.0 * 1e-5 + 30.0 * 2e-5), 1e-15);
    EXPECT_NEAR(run.number("water_volume"), run.number("rain_volume"), 1e-15);
    const Snapshot snapshot = run.gully.snapshot();
    EXPECT_EQ(snapshot.rain(0.0, 10.0)(0, 0), 0.0);
    EXPECT_NEAR(snapshot.rain(15.0, 25.0)(0, 0), 5.0 * 1e-5 + 5.0 * 2e-5, 1e-18);
    EXPECT_EQ(snapshot.rain(30.0, 30.0)(0, 0), 0.0);
    EXPECT_EQ(snapshot.rain(50.0, 100.0)(0, 0), 0.0);
}

TEST(WaterSetup, RainEndsWhereItIsToldTo) {
    WaterParameters water;
    water.rain = 36.0;
    water.rain_until = 30.0;
    const GullyRun run(water, Grid(5, 4), 1);
    EXPECT_NEAR(run.gully.snapshot().rain(20.0, 40.0)(0, 0), 10.0 * 1e-5, 1e-18);
}

TEST(WaterSetup, TheGroundTakesWaterByThreeLaws) {
    const auto taken = [](InfiltrationLaw law, double depth, double time) {
        WaterParameters water;
        water.initial_water = InitialWater::film;
        water.depth = depth;
        water.infiltration = law;
        water.time_step = 5.0;
        GullyRun run(water, Grid(3, 3), 1);
        run.to(time);
        EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-13);
        EXPECT_NEAR(run.number("water_volume") + run.number("infiltrated_volume"), 9.0 * depth,
                    1e-13);
        return run.number("infiltrated_volume") / 9.0;
    };
    const double hour = 3600.0;
    EXPECT_NEAR(taken(InfiltrationLaw::constant, 0.5, hour), 0.010, 1e-12);
    EXPECT_NEAR(taken(InfiltrationLaw::constant, 0.004, hour), 0.004, 1e-15) << "no more than is";
    // 10 mm + (60 − 10) mm/h · (1 − e^−2) / (2/h)
    EXPECT_NEAR(taken(InfiltrationLaw::horton, 0.5, hour), 0.010 + 0.025 * (1.0 - std::exp(-2.0)),
                1e-7);
    // F − S ln(1 + F/S) = K t with S = 0.03 m
    const double total = taken(InfiltrationLaw::green_ampt, 0.5, hour);
    EXPECT_NEAR(total - 0.03 * std::log(1.0 + total / 0.03), 0.010, 2e-4);
}

/// Horton's capacity falls with what the ground has taken, so that light rain does not use it up.
TEST(WaterSetup, HortonsCapacityFallsByIntakeOrByTheClock) {
    constexpr double hour = 3600.0;
    constexpr double millimetre = 1e-3;
    const auto taken = [](HortonBy by) {
        WaterParameters water;
        water.infiltration = InfiltrationLaw::horton;
        water.horton_by = by;
        water.rain = 30.0;
        water.time_step = 5.0;
        GullyRun run(water, Grid(3, 3), 1);
        run.to(2.0 * hour);
        EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12);
        return run.number("infiltrated_volume") / 9.0;
    };
    // Ponding begins as 10 t + 25 (1 − e^(−2t)) mm have come at t with 10 + 50 e^(−2t) = 30 mm/h.
    EXPECT_NEAR(taken(HortonBy::intake), 42.38 * millimetre, 0.02 * millimetre);
    EXPECT_NEAR(taken(HortonBy::clock), 38.65 * millimetre, 0.02 * millimetre);
}

TEST(WaterSetup, SoilGetsItsCapacityBackBetweenStorms) {
    constexpr double hour = 3600.0;
    const auto second_storm = [](double recovery) {
        WaterParameters water;
        water.infiltration = InfiltrationLaw::horton;
        water.infiltration_recovery = recovery;
        water.rain_times = {0.0, 0.3 * hour, 2.3 * hour, 2.4 * hour};
        water.rain_rates = {30.0, 0.0, 500.0, 0.0};
        water.time_step = 1.0;
        GullyRun run(water, Grid(3, 3), 1);
        run.to(2.3 * hour);
        EXPECT_NEAR(run.number("infiltrated_volume"), 9.0 * 0.009, 1e-6) << "all of the first";
        run.to(2.4 * hour);
        return (run.number("infiltrated_volume") - 9.0 * 0.009) / 9.0 * 1e3;  // mm
    };
    // 10 t + 25 (1 − e^(−2t)) = 9 mm
    double phase = 0.0;
    double low = 0.0;
    double high = 1.0;
    for (int turn = 0; turn < 60; ++turn) {
        phase = 0.5 * (low + high);
        (5.0 * phase + 25.0 * (1.0 - std::exp(-phase)) < 9.0 ? low : high) = phase;
    }
    const auto takes = [](double left) {
        return 10.0 * 0.1 + 25.0 * left * (1.0 - std::exp(-0.2));
    };
    const double left = std::exp(-phase);
    EXPECT_NEAR(second_storm(0.0), takes(left), 0.02);
    EXPECT_NEAR(second_storm(1.0), takes(1.0 - (1.0 - left) * std::exp(-2.0)), 0.02);
}

TEST(WaterSetup, RefusesWhatDoesNotGoTogetherAtItsKey) {
    const auto refusal = [](const GullyParameters& water) -> std::string {
        try {
            const GullyRun run(water, Grid(8, 6), 1);
        } catch (const KeyError& error) {
            return error.key();
        }
        return {};
    };
    WaterParameters water;
    EXPECT_EQ(refusal(water), "");
    water.infiltration_recovery = 1.0;
    EXPECT_EQ(refusal(water), "model.infiltration_recovery");
    water = {};
    water.edges = {edge(GridSide::west, EdgeFlow::discharge, -1.0)};
    EXPECT_EQ(refusal(water), "edge.0.value");
    water.edges = {edge(GridSide::west, EdgeFlow::level), edge(GridSide::west, EdgeFlow::open)};
    EXPECT_EQ(refusal(water), "edge.1.from");
    water.edges = {edge(GridSide::west, EdgeFlow::level)};
    water.edges[0].from = 5.8;
    EXPECT_EQ(refusal(water), "edge.0.from");
    water.edges[0].from = 0.0;
    water.edges[0].times = {1.0, 1.0};
    EXPECT_EQ(refusal(water), "edge.0.values");
    water.edges[0].values = {1.0, 2.0};
    EXPECT_EQ(refusal(water), "edge.0.times");
    water.edges[0].times = {1.0, 2.0};
    EXPECT_EQ(refusal(water), "");
    water.edges_x = EdgeKind::periodic;
    EXPECT_EQ(refusal(water), "edge.0.side");
    water = {};
    water.regions.resize(1);
    EXPECT_EQ(refusal(water), "water.0.depth");
    water.regions[0].depth = 1.0;
    EXPECT_EQ(refusal(water), "");
    water.regions[0].window = {0.0, 0.0, 0.2, 9.0};
    EXPECT_EQ(refusal(water), "water.0.window");
    water = {};
    water.rain_times = {0.0};
    EXPECT_EQ(refusal(water), "model.rain_rates");
    GullyParameters gully;
    gully.friction = FrictionLaw::manning;
    gully.scheme = WaterScheme::cip;
    EXPECT_EQ(refusal(gully), "model.friction");
    gully = {};
    gully.slope_x = 0.1;
    EXPECT_EQ(refusal(gully), "");
    gully.transport = SedimentTransport::as_printed;
    EXPECT_EQ(refusal(gully), "model.slope_x");
}

TEST(WaterSetup, TheBedChangesAlikeWhicheverWayThePlaneSlopes) {
    constexpr int across = 18;
    constexpr int along = 26;
    const Grid bed = noise(across, along, 0.02);
    Grid turned(along, across);  // southward becomes eastward
    for (int y = 0; y < along; ++y) {
        for (int x = 0; x < across; ++x) turned(along - 1 - y, x) = bed(x, y);
    }
    for (const SedimentTransport transport :
         {SedimentTransport::incision, SedimentTransport::conservative}) {
        for (const Relief relief : {Relief::gentle, Relief::steep}) {
            GullyParameters gully;
            gully.scheme = WaterScheme::finite_volume;
            gully.transport = transport;
            gully.relief = relief;
            gully.slope = 0.04;
            gully.bed_diffusion = 0.0;  // which goes along x before y
            GullyRun southward(gully, bed, 1);
            gully.slope = 0.0;
            gully.slope_x = 0.04;
            GullyRun eastward(gully, turned, 1);
            southward.to(20.0);
            eastward.to(20.0);
            const Grid one = southward.gully.snapshot().bed;
            const Grid other = eastward.gully.snapshot().bed;
            double change = 0.0;
            for (int y = 0; y < along; ++y) {
                for (int x = 0; x < across; ++x) {
                    change = std::max(change, std::fabs(one(x, y) - bed(x, y)));
                    ASSERT_NEAR(other(along - 1 - y, x), one(x, y), 1e-11);
                }
            }
            EXPECT_GT(change, 1e-4);
        }
    }
}

}  // namespace
}  // namespace fumon::test
