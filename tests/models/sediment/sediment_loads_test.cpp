#include "models/sediment/sediment_loads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/error.h"
#include "models/shared/state_hash.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

/// A basin of grains of half a millimetre, with bed load and suspended load that a stream of some
/// decimetres moves.
GullyParameters stream() {
    GullyParameters gully = WaterParameters();
    gully.transport = SedimentTransport::loads;
    gully.friction = FrictionLaw::manning;
    gully.manning = 0.03;
    gully.loads.entrainment = EntrainmentLaw::excess_shear;
    gully.loads.entrainment_stress = 0.5;
    gully.loads.entrainment_rate = 0.02;
    gully.loads.settling_velocity = {"", 0.02};
    gully.bed_diffusion = {"", 0.0};
    return gully;
}

double largest_change(const GullyRun& run) {
    const Grid change = run.field("bed_change");
    double largest = 0.0;
    for (const double dz : change.values()) largest = std::max(largest, std::fabs(dz));
    return largest;
}

/// What bed, water and edges leave unexplained, over what was eroded.
double unexplained(const GullyRun& run, double bed_factor) {
    const double change = run.number("deposited_volume") - run.number("eroded_volume");
    const double grains = run.number("suspended_volume") + run.number("grains_left_volume") -
                          run.number("grains_entered_volume");
    return std::fabs(change + bed_factor * grains) / run.number("eroded_volume");
}

// ---- what is kept ----

TEST(SedimentLoads, KeepsGrainsOverWallsOpenEdgesInflowAndHoles) {
    for (const BedLoadLaw law :
         {BedLoadLaw::none, BedLoadLaw::meyer_peter_mueller, BedLoadLaw::ashida_michiue}) {
        GullyParameters gully = stream();
        gully.loads.bed_load = law;
        gully.loads.morphological_factor = 20.0;
        gully.loads.inflow_concentration = 0.001;
        gully.loads.base_level = {"", 0.1};
        gully.slope = {"", 0.01};
        gully.rain = 500.0;
        gully.infiltration = InfiltrationLaw::constant;
        gully.time_step = 1.0;
        gully.edges = {edge(GridSide::north, EdgeFlow::discharge, 8.0)};
        gully.edges_y = EdgeKind::open;
        Mask nodata(24, 30);
        for (int x = 10; x < 14; ++x) nodata(x, 11) = 1;
        Grid bed = noise(24, 30, 0.2);
        bed(5, 20) = 4.0;  // which falls
        GullyRun run(gully, bed, 1, 1.0, 1.5, nodata);
        run.to(30.0);
        EXPECT_GT(largest_change(run), 0.05);
        EXPECT_GT(run.number("suspended_volume"), 1e-3);
        EXPECT_GT(run.number("grains_left_volume"), 1e-3);
        EXPECT_GT(run.number("grains_entered_volume"), 1e-3);
        EXPECT_LT(unexplained(run, 20.0 / 0.6), 1e-12);
        EXPECT_LT(std::fabs(run.number("sediment_budget_error")), 1e-12);
        EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12);
        const Grid concentration = run.field("concentration");
        EXPECT_GE(*std::ranges::min_element(concentration.values()), -1e-18);
        const Grid change = run.field("bed_change");
        EXPECT_EQ(change(12, 11), 0.0) << "without data";
    }
}

TEST(SedimentLoads, KeepsGrainsRoundAPeriodicPlane) {
    GullyParameters gully = stream();
    gully.edges_x = gully.edges_y = EdgeKind::periodic;
    gully.slope = {"", 0.02};
    gully.slope_x = 0.01;
    gully.initial_water = InitialWater::film;
    gully.depth = 0.05;
    gully.loads.bank_failure = BankFailure::none;
    GullyRun run(gully, noise(33, 21, 0.05), 1);
    run.to(30.0);
    EXPECT_GT(largest_change(run), 1e-4);
    EXPECT_LT(unexplained(run, 1.0 / 0.6), 1e-12);
    EXPECT_EQ(run.number("grains_left_volume"), 0.0);
}

TEST(SedimentLoads, LeaveALakeAndItsBedAtRest) {
    GullyParameters gully = stream();
    gully.initial_water = InitialWater::surface;
    gully.surface = 0.5;
    GullyRun run(gully, noise(20, 20, 0.4), 1);
    run.to(5.0);
    EXPECT_EQ(largest_change(run), 0.0);
}

TEST(SedimentLoads, DoNotGoBelowTheBaseLevel) {
    GullyParameters gully = stream();
    gully.slope = {"", 0.05};
    gully.edges_y = EdgeKind::open;
    gully.edges = {edge(GridSide::north, EdgeFlow::discharge, 1.5)};
    gully.loads.morphological_factor = 200.0;
    gully.loads.base_level = {"", 0.2};
    GullyRun run(gully, Grid(3, 30, 0.3), 1);
    run.to(60.0);
    const Grid bed = run.gully.snapshot().bed;
    double lowest = 1e9;
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 3; ++x) lowest = std::min(lowest, bed(x, y) + 0.05 * (y + 0.5));
    }
    EXPECT_GE(lowest, 0.2 - 1e-9);
    EXPECT_LT(lowest, 0.21);
    EXPECT_LT(unexplained(run, 200.0 / 0.6), 1e-12);
}

TEST(SedimentLoads, GiveTheSameBytesOnAnyNumberOfThreads) {
    GullyParameters gully = stream();
    gully.slope = {"", 0.01};
    gully.rain = 300.0;
    gully.edges = {edge(GridSide::north, EdgeFlow::discharge, 8.0),
                   edge(GridSide::south, EdgeFlow::level, 0.3)};
    gully.loads.morphological_factor = 5.0;
    gully.loads.base_level = {"", -0.1};
    Grid bed = noise(31, 26, 0.3);
    bed(7, 7) = 5.0;
    for (const BedLoadLaw law : {BedLoadLaw::none, BedLoadLaw::meyer_peter_mueller}) {
        gully.loads.bed_load = law;
        GullyRun one(gully, bed, 1);
        GullyRun three(gully, bed, 3);
        one.to(2.0);
        three.to(2.0);
        EXPECT_GT(largest_change(one), 0.01);
        EXPECT_EQ(state_hash(one.gully), state_hash(three.gully));
    }
}

}  // namespace
}  // namespace fumon::test
