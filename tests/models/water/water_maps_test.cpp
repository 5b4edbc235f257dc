// Rain, roughness and water that maps give cell by cell.

#include "models/water/water_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

constexpr int map_columns = 37;
constexpr int map_rows = 21;

CellMap map_of(double value) {
    return {Grid(map_columns, map_rows, value), {}};
}

/// One value in the western half, another in the eastern one.
CellMap halves(double west, double east) {
    CellMap map = map_of(east);
    for (int y = 0; y < map_rows; ++y) {
        for (int x = 0; x < map_columns / 2; ++x) map.values(x, y) = west;
    }
    return map;
}

MapSettings says(MapQuantity quantity, double from = 0.0) {
    MapSettings settings;
    settings.quantity = quantity;
    settings.from = from;
    return settings;
}

struct MappedRun {
    MappedRun(const GullyParameters& parameters, Grid bed, std::vector<CellMap> maps,
              Mask nodata = {})
        : pool(2),
          gully(parameters, {std::move(bed),
                             std::move(nodata),
                             {2.0, 2.0, 1.0, true},
                             1,
                             pool,
                             false,
                             std::move(maps)}) {}

    void to(double seconds) {
        while (gully.time() < seconds - 1e-9) gully.step();
    }
    [[nodiscard]] double number(const std::string& name) const {
        for (const SnapshotNumber& number : gully.snapshot().numbers) {
            if (number.name == name) return number.value;
        }
        return std::nan("");
    }

    WorkerPool pool;
    Gully gully;
};

std::string refusal(const GullyParameters& parameters, std::vector<CellMap> maps,
                    Mask nodata = {}) {
    try {
        const MappedRun run(parameters, Grid(map_columns, map_rows), std::move(maps),
                            std::move(nodata));
    } catch (const KeyError& fault) {
        return fault.key();
    }
    return "";
}

WaterParameters wet_ground() {
    WaterParameters water;
    water.time_step = 1.0;
    water.friction = FrictionLaw::manning;
    water.manning = 0.04;
    return water;
}

TEST(WaterMaps, EvenMapsChangeNothing) {
    const Grid bed = noise(map_columns, map_rows, 0.5);
    for (const SedimentTransport transport : {SedimentTransport::none, SedimentTransport::loads}) {
        for (const FrictionLaw law :
             {FrictionLaw::manning, FrictionLaw::half, FrictionLaw::chezy}) {
            WaterParameters even = wet_ground();
            even.transport = transport;
            even.friction = law;
            even.rain = 300.0;
            WaterParameters mapped = even;
            mapped.rain = 0.0;
            mapped.manning = mapped.chezy = mapped.friction_coefficient = 1.0;
            mapped.maps = {says(MapQuantity::rain), says(MapQuantity::roughness)};
            const double roughness = law == FrictionLaw::manning ? even.manning
                                     : law == FrictionLaw::half  ? even.friction_coefficient
                                                                 : even.chezy;
            MappedRun one(even, bed, {});
            MappedRun other(mapped, bed, {map_of(300.0), map_of(roughness)});
            one.to(20.0);
            other.to(20.0);
            const Snapshot first = one.gully.snapshot();
            const Snapshot second = other.gully.snapshot();
            EXPECT_TRUE(std::ranges::equal(first.bed.values(), second.bed.values()));
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_TRUE(std::ranges::equal(first.fields[k].values.values(),
                                               second.fields[k].values.values()));
            EXPECT_NEAR(other.number("rain_volume"), one.number("rain_volume"), 1e-12);
        }
    }
}

TEST(WaterMaps, RainFallsWhereAndWhenTheyHaveIt) {
    WaterParameters water = wet_ground();
    water.manning = 0.0;
    water.maps = {says(MapQuantity::rain, 2.5), says(MapQuantity::rain, 10.0)};
    water.rain_until = 13.25;
    water.edges_x = water.edges_y = EdgeKind::wall;
    Mask nodata(map_columns, map_rows);
    nodata(0, 0) = 1;
    MappedRun run(water, Grid(map_columns, map_rows, 0.0), {halves(360.0, 0.0), halves(0.0, 720.0)},
                  nodata);
    run.to(2.0);
    EXPECT_EQ(run.number("water_volume"), 0.0);
    run.to(10.0);
    const double west = 4.0 * (map_columns / 2 * map_rows - 1);
    const double east = 4.0 * (map_columns - map_columns / 2) * map_rows;
    const double first = west * 1e-4 * 7.5;
    EXPECT_NEAR(run.number("rain_volume"), first, 1e-12);
    run.to(20.0);
    EXPECT_NEAR(run.number("rain_volume"), first + east * 2e-4 * 3.25, 1e-12);
    EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-13);
    const Grid fallen = run.gully.snapshot().rain(5.0, 11.0);
    EXPECT_NEAR(fallen(1, 3), 5.0 * 1e-4, 1e-15);
    EXPECT_NEAR(fallen(map_columns - 1, 3), 1.0 * 2e-4, 1e-15);
    EXPECT_EQ(run.gully.snapshot().rain(14.0, 20.0)(map_columns - 1, 3), 0.0);
    const Grid depth = run.gully.snapshot().fields[0].values;
    EXPECT_GT(depth(2, 10), 7e-4);
    EXPECT_LT(depth(2, 10), 8e-4);
}

TEST(WaterMaps, RoughGroundHoldsTheWaterBack) {
    WaterParameters water = wet_ground();
    water.edges_x = water.edges_y = EdgeKind::periodic;
    water.slope = 0.01;
    water.initial_water = InitialWater::film;
    water.depth = 0.1;
    water.initial_flow = InitialFlow::rest;
    water.maps = {says(MapQuantity::roughness)};
    MappedRun run(water, Grid(map_columns, map_rows), {halves(0.02, 0.08)});
    run.to(120.0);
    const Grid v = run.gully.snapshot().fields[2].values;
    const double expected = std::pow(0.1, 2.0 / 3.0) * 0.1;  // times 1/n (Manning), uniform flow
    EXPECT_NEAR(-v(9, 10), expected / 0.02, 0.02 * expected / 0.02);
    EXPECT_NEAR(-v(28, 10), expected / 0.08, 0.02 * expected / 0.08);
}

TEST(WaterMaps, TheWaterAtTheStart) {
    WaterParameters water = wet_ground();
    water.maps = {says(MapQuantity::level), says(MapQuantity::velocity_x),
                  says(MapQuantity::velocity_y)};
    RegionSettings pool;
    pool.window = {0.0, 0.0, 4.0, 4.0};
    pool.depth = 3.0;
    water.regions = {pool};
    Grid bed(map_columns, map_rows, 0.25);
    bed(30, 5) = 2.0;
    CellMap level = halves(1.0, 1.5);
    level.nodata = Mask(map_columns, map_rows);
    level.nodata(8, 8) = 1;
    MappedRun run(water, bed, {level, map_of(0.5), halves(0.0, -0.25)});
    const Snapshot start = run.gully.snapshot();
    const Grid& depth = start.fields[0].values;
    EXPECT_EQ(depth(10, 10), 0.75);
    EXPECT_EQ(depth(30, 10), 1.25);
    EXPECT_EQ(depth(30, 5), 0.0) << "above the level";
    EXPECT_EQ(depth(8, 8), 0.0) << "the map has no data";
    EXPECT_EQ(depth(1, 1), 3.0) << "[[water]] lies over maps";
    EXPECT_EQ(start.fields[1].values(10, 10), 0.5);
    EXPECT_EQ(start.fields[1].values(30, 5), 0.0);
    EXPECT_EQ(start.fields[2].values(30, 10), -0.25);
    water.maps = {says(MapQuantity::depth)};
    EXPECT_EQ(MappedRun(water, bed, {map_of(0.125)}).gully.snapshot().fields[0].values(30, 5),
              0.125);
}

/// Half a metre of water that lies still between walls.
WaterParameters pond(InfiltrationLaw law) {
    WaterParameters water = wet_ground();
    water.edges_x = water.edges_y = EdgeKind::wall;
    water.initial_water = InitialWater::film;
    water.depth = 0.5;
    water.infiltration = law;
    return water;
}

TEST(WaterMaps, EvenGroundTakesWhatItsNumbersSay) {
    const Grid bed = noise(map_columns, map_rows, 0.5);
    for (const InfiltrationLaw law :
         {InfiltrationLaw::constant, InfiltrationLaw::horton, InfiltrationLaw::green_ampt}) {
        WaterParameters even = pond(law);
        even.infiltration_rate = 37.0;
        even.infiltration_start = 900.0;
        even.suction_head = 0.17;
        even.moisture_deficit = 0.23;
        WaterParameters mapped = even;
        mapped.maps = {says(MapQuantity::infiltration_rate)};
        std::vector<CellMap> maps{map_of(37.0)};
        mapped.infiltration_rate = 1.0;
        if (law == InfiltrationLaw::horton) {
            mapped.maps.push_back(says(MapQuantity::infiltration_start));
            maps.push_back(map_of(900.0));
            mapped.infiltration_start = 1.0;
        }
        if (law == InfiltrationLaw::green_ampt) {
            mapped.maps.push_back(says(MapQuantity::suction_head));
            mapped.maps.push_back(says(MapQuantity::moisture_deficit));
            maps.push_back(map_of(0.17));
            maps.push_back(map_of(0.23));
            mapped.suction_head = mapped.moisture_deficit = 1.0;
        }
        MappedRun one(even, bed, {});
        MappedRun other(mapped, bed, maps);
        one.to(30.0);
        other.to(30.0);
        EXPECT_GT(one.number("infiltrated_volume"), 0.0);
        EXPECT_EQ(one.number("infiltrated_volume"), other.number("infiltrated_volume"));
        const Snapshot first = one.gully.snapshot();
        const Snapshot second = other.gully.snapshot();
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_TRUE(std::ranges::equal(first.fields[k].values.values(),
                                           second.fields[k].values.values()));
    }
}

/// What two soils take side by side is what each takes alone.
TEST(WaterMaps, EachSoilTakesItsOwn) {
    const Grid bed(map_columns, map_rows);
    constexpr double cell = 4.0;
    constexpr double west = cell * (map_columns / 2) * map_rows;
    constexpr double east = cell * (map_columns - map_columns / 2) * map_rows;
    const auto taken = [&](const WaterParameters& water, std::vector<CellMap> maps) {
        MappedRun run(water, bed, std::move(maps));
        run.to(100.0);
        EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-13);
        return run.number("infiltrated_volume");
    };
    WaterParameters constant = pond(InfiltrationLaw::constant);
    constant.maps = {says(MapQuantity::infiltration_rate)};
    EXPECT_NEAR(taken(constant, {halves(36.0, 9.0)}), west * 1e-3 + east * 0.25e-3, 1e-11);
    WaterParameters horton = pond(InfiltrationLaw::horton);
    horton.infiltration_rate = 36.0;
    horton.infiltration_decay = 1e-4;
    horton.maps = {says(MapQuantity::infiltration_start)};
    EXPECT_NEAR(taken(horton, {halves(72.0, 36.0)}), west * 2e-3 + east * 1e-3, west * 1e-8);
    // F of Green & Ampt (1911): F − S ln(1 + F / S) = K t.
    WaterParameters front = pond(InfiltrationLaw::green_ampt);
    front.infiltration_rate = 36.0;
    front.suction_head = 0.1;
    front.maps = {says(MapQuantity::moisture_deficit)};
    front.time_step = 0.05;
    const auto depth_of = [](double suction) {
        double depth = 0.01;
        for (int k = 0; k < 200; ++k) depth = 1e-3 + suction * std::log1p(depth / suction);
        return depth;
    };
    const double expected = west * depth_of(0.04) + east * depth_of(0.01);
    EXPECT_NEAR(taken(front, {halves(0.4, 0.1)}), expected, 0.01 * expected);
}

TEST(WaterMaps, WhatDoesNotGoTogetherIsRefused) {
    WaterParameters water = wet_ground();
    water.maps = {says(MapQuantity::rain)};
    EXPECT_EQ(refusal(water, {map_of(1.0)}), "");
    EXPECT_EQ(refusal(water, {map_of(-1.0)}), "map.0.file");
    EXPECT_EQ(refusal(water, {map_of(std::nan(""))}), "map.0.file");
    CellMap holed = map_of(1.0);
    holed.nodata = Mask(map_columns, map_rows);
    holed.nodata(3, 4) = 1;
    EXPECT_EQ(refusal(water, {holed}), "map.0.file");
    EXPECT_EQ(refusal(water, {holed}, holed.nodata), "") << "the bed has none there either";
    water.rain = 5.0;
    EXPECT_EQ(refusal(water, {map_of(1.0)}), "model.rain");
    water.rain = 0.0;
    water.maps = {says(MapQuantity::rain, 10.0), says(MapQuantity::rain, 10.0)};
    EXPECT_EQ(refusal(water, {map_of(1.0), map_of(1.0)}), "map.1.from");
    water.maps = {says(MapQuantity::depth), says(MapQuantity::level)};
    EXPECT_EQ(refusal(water, {map_of(1.0), map_of(1.0)}), "map.1.quantity");
    water.maps = {says(MapQuantity::depth, 3.0)};
    EXPECT_EQ(refusal(water, {map_of(1.0)}), "map.0.from");
    water.maps = {says(MapQuantity::infiltration_rate)};
    EXPECT_EQ(refusal(water, {map_of(1.0)}), "map.0.quantity");
    water.infiltration = InfiltrationLaw::constant;
    EXPECT_EQ(refusal(water, {map_of(1.0)}), "");
    EXPECT_EQ(refusal(water, {map_of(-1.0)}), "map.0.file");
    EXPECT_EQ(refusal(water, {holed}), "map.0.file");
    water.maps = {says(MapQuantity::infiltration_start)};
    EXPECT_EQ(refusal(water, {map_of(1.0)}), "map.0.quantity");
    water.infiltration = InfiltrationLaw::horton;
    water.maps = {says(MapQuantity::moisture_deficit)};
    EXPECT_EQ(refusal(water, {map_of(0.5)}), "map.0.quantity");
    water.infiltration = InfiltrationLaw::green_ampt;
    EXPECT_EQ(refusal(water, {map_of(1.5)}), "map.0.file");
    EXPECT_EQ(refusal(water, {holed}, holed.nodata), "");
    water.infiltration = InfiltrationLaw::none;
    water.maps = {says(MapQuantity::roughness)};
    water.friction = FrictionLaw::chezy;
    EXPECT_EQ(refusal(water, {map_of(0.0)}), "map.0.file");
    water.scheme = WaterScheme::cip;
    water.edges_x = water.edges_y = EdgeKind::periodic;
    EXPECT_EQ(refusal(water, {map_of(30.0)}), "model.scheme");
}

}  // namespace
}  // namespace fumon::test
