// What gauges count is what the water's volumes lack: through sides, lines and outlines, by every
// scheme, to rounding.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/checkpoint.h"
#include "files/terrain/terrain_file.h"
#include "support/gully_run.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

GaugeSettings side_gauge(GaugeSide side, const std::string& name) {
    GaugeSettings gauge;
    gauge.side = side;
    gauge.name = name;
    return gauge;
}

GaugeSettings line_gauge(std::vector<double> at, std::vector<double> to, const std::string& name) {
    GaugeSettings gauge;
    gauge.at = std::move(at);
    gauge.to = std::move(to);
    gauge.name = name;
    return gauge;
}

std::vector<GaugeSettings> gauges_all_round() {
    return {side_gauge(GaugeSide::west, "west"), side_gauge(GaugeSide::east, "east"),
            side_gauge(GaugeSide::south, "south"), side_gauge(GaugeSide::north, "north"),
            side_gauge(GaugeSide::all, "all")};
}

/// Water over a fixed bed by finite volumes, walled in.
WaterParameters gauged_water() {
    WaterParameters water;
    water.friction = FrictionLaw::manning;
    water.manning = 0.03;
    water.edges_x = water.edges_y = EdgeKind::wall;
    return water;
}

/// m³ west of the corners that part(y) gives for each row.
template <class Part>
double volume_west_of(const GullyRun& run, double cell_area, Part part) {
    const Grid depth = run.field("water_depth");
    double volume = 0.0;
    for (int y = 0; y < depth.ny(); ++y) {
        for (int x = 0; x < part(y); ++x) volume += cell_area * depth(x, y);
    }
    return volume;
}

TEST(GaugeVolumes, ASideOfARainyPlaneReadsAllItsRain) {
    WaterParameters water = gauged_water();
    water.rain = 100.0;
    water.time_step = 10.0;
    EdgeSettings fall = edge(GridSide::east, EdgeFlow::open);
    for (const bool by_stretch : {true, false}) {
        Grid bed(20, 3);
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 20; ++x) bed(x, y) = 0.02 * 5.0 * (19 - x);
        }
        if (by_stretch) {
            water.edges = {fall};
        } else {
            water.edges = {edge(GridSide::west, EdgeFlow::wall)};
            water.edges_x = EdgeKind::open;
        }
        water.gauges = gauges_all_round();
        GullyRun run(water, bed, 2, 5.0, 5.0);
        run.to(1800.0);
        const double rain = 100.0 / 3.6e6 * 1500.0;
        EXPECT_NEAR(run.number("east_discharge_m3s"), rain, 1e-5 * rain);
        for (const char* wall : {"west", "south", "north"}) {
            EXPECT_EQ(run.number(wall + std::string("_discharge_m3s")), 0.0);
            EXPECT_EQ(run.number(wall + std::string("_volume_m3")), 0.0);
        }
        EXPECT_NEAR(run.number("east_volume_m3"), run.number("left_volume"), 1e-12 * 75.0);
        EXPECT_EQ(run.number("all_volume_m3"), run.number("east_volume_m3"));
        EXPECT_EQ(run.number("all_discharge_m3s"), run.number("east_discharge_m3s"));
    }
}

TEST(GaugeVolumes, AllSidesOfRealTerrainReadWhatLeaves) {
    const Terrain hill =
        read_terrain(std::filesystem::path(FUMON_TERRAIN_FOLDER) / "front_range_hill.asc", {});
    WaterParameters water = gauged_water();
    water.edges_x = water.edges_y = EdgeKind::open;
    water.rain = 60.0;
    water.time_step = 20.0;
    water.gauges = gauges_all_round();
    GullyRun run(water, hill.heights, 2, hill.dx, hill.dy);
    run.to(600.0);
    const double rain = run.number("rain_volume");
    const double all = run.number("all_volume_m3");
    EXPECT_GT(all, 0.01 * rain);
    EXPECT_NEAR(all, run.number("left_volume"), 1e-12 * rain);
    EXPECT_NEAR(all + run.number("water_volume"), rain, 1e-12 * rain);
    double sides = 0.0;
    for (const char* side : {"west", "east", "south", "north"})
        sides += run.number(side + std::string("_volume_m3"));
    EXPECT_NEAR(sides, all, 1e-12 * rain);
}

/// A hill with a hole in the data, open all round.
struct MaskedHill {
    Grid bed{31, 23};
    Mask nodata{31, 23};

    MaskedHill() {
        const Grid rough = noise(31, 23, 0.3);
        for (int y = 0; y < 23; ++y) {
            for (int x = 0; x < 31; ++x) {
                bed(x, y) = 0.1 * std::fabs(x - 15.0) + 0.15 * y + rough(x, y);
                const double far = std::hypot(x - 16.0, y - 11.0);
                nodata(x, y) = far > 16.5 || far < 2.5 ? 1 : 0;
            }
        }
    }
};

TEST(GaugeVolumes, AnOutlineReadsAllThatLeavesAMaskedCatchment) {
    const MaskedHill hill;
    for (const ShoreCells shores : {ShoreCells::planes, ShoreCells::whole}) {
        WaterParameters water = gauged_water();
        water.edges_x = water.edges_y = EdgeKind::open;
        water.shore_cells = shores;
        water.initial_water = InitialWater::film;
        water.depth = 0.03;
        water.rain = 200.0;
        water.rain_until = 4.0;
        water.infiltration = InfiltrationLaw::green_ampt;
        water.infiltration_rate = 5.0;
        water.gauges = gauges_all_round();
        GullyRun run(water, hill.bed, 2, 2.0, 3.0, hill.nodata);
        run.to(10.0);
        const double left = run.number("left_volume");
        EXPECT_GT(left, 0.3);
        EXPECT_NEAR(run.number("all_volume_m3"), left, 1e-12 * left);
        const double sides = run.number("west_volume_m3") + run.number("east_volume_m3") +
                             run.number("south_volume_m3") + run.number("north_volume_m3");
        EXPECT_LT(sides, 0.9 * left);  // the rest goes where there is no data
        const double before = run.number("all_volume_m3");
        run.gully.step();
        EXPECT_NEAR(run.number("all_discharge_m3s") * water.time_step,
                    run.number("all_volume_m3") - before, 1e-12 * left);
    }
}

/// What a line across a walled valley counts is what the ground west of it loses, less its rain.
void hold_line_to_volumes(const ShoreCells shores, const SedimentTransport transport) {
    constexpr int nx = 24;
    constexpr int ny = 12;
    Grid bed = noise(nx, ny, 0.05);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) bed(x, y) += 0.08 * (nx - x) + 0.02 * std::fabs(y - 5.5);
    }
    WaterParameters water = gauged_water();
    water.shore_cells = shores;
    water.transport = transport;
    water.edges = {edge(GridSide::west, EdgeFlow::discharge, 20.0)};
    water.rain = 60.0;
    // from corner (12, 12) to corner (12, 0), west to the left of the way south: east is
    water.gauges = {line_gauge({24.0, 36.0}, {24.0, 0.0}, "straight"),
                    line_gauge({30.0, 36.0}, {14.0, 0.0}, "oblique"),
                    line_gauge({14.0, 0.0}, {30.0, 36.0}, "back"),
                    side_gauge(GaugeSide::west, "in")};
    GullyRun run(water, bed, 2, 2.0, 3.0);
    run.to(20.0);
    const double rain = 60.0 / 3.6e6 * 20.0;
    const double entered = run.number("entered_volume");
    EXPECT_NEAR(entered, 20.0 * 20.0, 1e-9);
    EXPECT_NEAR(run.number("in_volume_m3"), -entered, 1e-12 * entered);
    const auto straight = [](int /*y*/) { return 12; };
    EXPECT_GT(run.number("straight_volume_m3"), 1.0);
    EXPECT_NEAR(run.number("straight_volume_m3"),
                entered + rain * 6.0 * 12 * ny - volume_west_of(run, 6.0, straight),
                1e-12 * entered);
    // the corner of each row's middle, on the line from (7, 0) to (15, 12) in cells
    const auto oblique = [](int y) {
        return static_cast<int>(std::floor(7.0 + (y + 0.5) * 8.0 / 12.0 + 0.5));
    };
    double cells = 0.0;
    for (int y = 0; y < ny; ++y) cells += oblique(y);
    EXPECT_NEAR(run.number("oblique_volume_m3"),
                entered + rain * 6.0 * cells - volume_west_of(run, 6.0, oblique), 1e-12 * entered);
    EXPECT_EQ(run.number("back_volume_m3"), -run.number("oblique_volume_m3"));
}

TEST(GaugeVolumes, ALineReadsWhatOneSideLosesToTheOther) {
    for (const ShoreCells shores : {ShoreCells::planes, ShoreCells::whole}) {
        for (const SedimentTransport transport :
             {SedimentTransport::none, SedimentTransport::loads})
            hold_line_to_volumes(shores, transport);
    }
}

/// Water that runs to and fro in a bowl, whose shores fall and leave cells behind.
TEST(GaugeVolumes, WhatFallingShoresDeliverCounts) {
    constexpr int n = 24;
    Grid bed(n, n);
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x)
            bed(x, y) = 0.01 * ((x - 11.5) * (x - 11.5) + (y - 11.5) * (y - 11.5));
    }
    WaterParameters water = gauged_water();
    water.shore_cells = ShoreCells::planes;
    water.manning = 0.0;
    RegionSettings west;
    west.window = {0.0, 0.0, 10.0, 24.0};
    west.level = {"", 0.8};
    RegionSettings east = west;
    east.window = {10.0, 0.0, 24.0, 24.0};
    east.level = {"", 0.3};
    water.regions = {west, east};
    water.gauges = {line_gauge({7.0, 24.0}, {7.0, 0.0}, "shore")};
    GullyRun run(water, bed);
    const auto west_of = [](int /*y*/) { return 7; };
    const double first = volume_west_of(run, 1.0, west_of);
    run.to(6.0);
    EXPECT_NEAR(volume_west_of(run, 1.0, west_of) + run.number("shore_volume_m3"), first,
                1e-12 * first);
}

TEST(GaugeVolumes, CipPassesWhatItsDepthsLack) {
    GullyParameters gully;
    gully.scheme = WaterScheme::cip;
    gully.rain = 20.0;
    gully.depth = 0.003;
    gully.time_step = 1.0;
    constexpr int nx = 22;
    constexpr int ny = 18;
    gully.gauges = {line_gauge({8.0, 0.0}, {8.0, 27.0}, "west"),    // westward
                    line_gauge({15.0, 27.0}, {15.0, 0.0}, "east"),  // eastward
                    side_gauge(GaugeSide::south, "south"), side_gauge(GaugeSide::north, "north"),
                    line_gauge({0.0, 13.5}, {22.0, 13.5}, "middle")};
    Grid bed = noise(nx, ny, 0.02);
    for (int y = 0; y < ny; y += 3) bed(15, y) = 2.0;  // from which more would run than there is
    GullyRun run(gully, bed, 2, 1.0, 1.5);
    const auto between = [](const GullyRun& now) {
        return volume_west_of(now, 1.5, [](int) { return 15; }) -
               volume_west_of(now, 1.5, [](int) { return 8; });
    };
    const auto northern = [](const GullyRun& now) {
        const Grid depth = now.field("water_depth");
        double volume = 0.0;
        for (int y = 9; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) volume += 1.5 * depth(x, y);
        }
        return volume;
    };
    const double first = between(run);
    const double first_north = northern(run);
    run.to(20.0);
    const double rain = 20.0 / 3.6e6 * 20.0 * 1.5;
    EXPECT_NEAR(between(run),
                first + rain * 7 * ny - run.number("west_volume_m3") - run.number("east_volume_m3"),
                1e-12);
    EXPECT_NEAR(northern(run),
                first_north + rain * nx * 9 + run.number("middle_volume_m3") -
                    run.number("north_volume_m3"),
                1e-12);
    EXPECT_GT(run.number("south_volume_m3"), 0.1);
    EXPECT_NEAR(run.number("north_volume_m3"), -run.number("south_volume_m3"), 1e-12);
}

TEST(GaugeVolumes, AsPublishedTheMeanOfTheCellsBesideCounts) {
    GullyParameters gully;
    gully.scheme = WaterScheme::cip_as_published;
    gully.transport = SedimentTransport::none;
    gully.gauges = {side_gauge(GaugeSide::south, "south")};
    GullyRun run(gully, Grid(8, 8));
    run.gully.step();
    const double speed = std::sqrt(9.8 * 0.01 * 0.04 / 0.01);
    EXPECT_NEAR(run.number("south_discharge_m3s"), 8.0 * 0.01 * speed, 1e-9);
}

TEST(GaugeVolumes, NothingLeavesAPeriodicPlane) {
    GullyParameters gully;
    gully.gauges = {side_gauge(GaugeSide::all, "all")};
    try {
        const GullyRun run(gully, Grid(8, 8));
        FAIL();
    } catch (const KeyError& error) {
        EXPECT_EQ(error.key(), "gauge.0.side");
    }
}

TEST(GaugeVolumes, AnyNumberOfThreadsReadsTheSameAndARunGoesOn) {
    const MaskedHill hill;
    WaterParameters water = gauged_water();
    water.edges_x = water.edges_y = EdgeKind::open;
    water.initial_water = InitialWater::film;
    water.depth = 0.03;
    water.rain = 100.0;
    water.gauges = gauges_all_round();
    water.gauges.push_back(line_gauge({10.0, 60.0}, {50.0, 10.0}, "across"));
    const auto readings = [](const GullyRun& run) {
        std::vector<double> values;
        for (const SnapshotNumber& number : run.gully.snapshot().numbers)
            values.push_back(number.value);
        return values;
    };
    GullyRun one(water, hill.bed, 1, 2.0, 3.0, hill.nodata);
    GullyRun three(water, hill.bed, 3, 2.0, 3.0, hill.nodata);
    one.to(5.0);
    const TemporaryFolder folder;
    CheckpointWriter writer(folder / "state");
    one.gully.serialise(writer);
    writer.commit();
    one.to(10.0);
    three.to(10.0);
    EXPECT_EQ(readings(one), readings(three));
    GullyRun resumed(water, hill.bed, 2, 2.0, 3.0, hill.nodata);
    CheckpointReader reader(std::make_unique<std::ifstream>(folder / "state", std::ios::binary),
                            "state");
    resumed.gully.serialise(reader);
    reader.finish();
    EXPECT_GT(resumed.number("all_discharge_m3s"), 0.0);
    resumed.to(10.0);
    EXPECT_EQ(readings(resumed), readings(one));
}

}  // namespace
}  // namespace fumon::test
