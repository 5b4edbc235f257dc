// Rasters by their names: what a snapshot has, its numbers, and what is refused.

#include "measure/raster/raster_quantity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.h"

namespace fumon::test {
namespace {

Snapshot valley() {
    // Steep sides and a gentle floor along x = 10; cells of 5 m by 4 m; water leaves at the south.
    Snapshot snapshot;
    snapshot.bed = Grid(21, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 21; ++x) snapshot.bed(x, y) = 5.0 * std::abs(x - 10) + 0.04 * y;
    snapshot.scale = {5.0, 4.0, 1.0, true};
    return snapshot;
}

Snapshot wet() {
    Snapshot snapshot;
    snapshot.step = 30;
    snapshot.bed = Grid(3, 1, 2.0);
    snapshot.bed(1, 0) = 2.5;
    snapshot.scale = {1.0, 1.0, 2.0, true};
    const auto add = [&](const char* name, const std::vector<double>& values) {
        Grid grid(3, 1);
        for (int x = 0; x < 3; ++x) grid(x, 0) = values[static_cast<std::size_t>(x)];
        snapshot.fields.push_back({name, std::string("the ") + name, "u", grid});
    };
    add("water_depth", {0.5, 0.0, 2.0});
    add("velocity_x", {3.0, 9.0, 0.6});
    add("velocity_y", {-4.0, 9.0, 0.8});
    add("silt", {1.0, 2.0, 3.0});
    return snapshot;
}

std::string refusal(std::string_view name, const RasterSource& source) {
    try {
        make_raster(name, source);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(RasterQuantity, AValleyDrainsAndIsWetAlongItsFloor) {
    const Snapshot snapshot = valley();
    const Raster area = make_raster("drainage", {snapshot});
    const Raster wetness = make_raster("wetness", {snapshot});
    EXPECT_EQ(area.unit, "m2");
    EXPECT_EQ(wetness.unit, "1");
    for (int y = 1; y < 39; ++y) {
        EXPECT_EQ(area.values(10, y), 19.0 * 20.0 * (39 - y)) << y;
        // The floor falls by 1 %: its neighbours on both sides are as high.
        const double along = std::log(area.values(10, y) / std::sqrt(20.0) / 0.01);
        EXPECT_NEAR(wetness.values(10, y), along, 1e-9) << y;
        // Of a side: one cell and those above it, 9 - |x - 10| in all but the edge's.
        const double side = std::log(5.0 * 20.0 / std::sqrt(20.0) / std::hypot(1.0, 0.01));
        EXPECT_NEAR(wetness.values(5, y), side, 1e-9) << y;
    }
}

TEST(RasterQuantity, LevelGroundCountsAsSlopingByAThousandth) {
    Snapshot snapshot = valley();
    snapshot.bed = Grid(21, 40, 3.0);
    const Raster area = make_raster("drainage", {snapshot});
    const Raster wetness = make_raster("wetness", {snapshot});
    EXPECT_NEAR(wetness.values(7, 7), std::log(area.values(7, 7) / std::sqrt(20.0) / 0.001), 1e-9);
    EXPECT_TRUE(wetness.nodata.empty());
    EXPECT_EQ(make_raster("aspect", {snapshot}).nodata(7, 7), 1);
}

TEST(RasterQuantity, TheGroundHasThePlaneOfTheModel) {
    Snapshot snapshot;
    snapshot.bed = Grid(5, 5, 1.0);
    snapshot.scale = {2.0, 2.0, 1.0, true};
    snapshot.numbers = {{"mean_slope", "1", 0.1}};
    EXPECT_NEAR(make_raster("slope", {snapshot}).values(2, 2), 5.710593, 1e-6);
    EXPECT_EQ(make_raster("aspect", {snapshot}).values(2, 2), 180.0);
    EXPECT_EQ(make_raster("height", {snapshot}).values(2, 2), 1.0);
}

TEST(RasterQuantity, WaterHasItsNumbers) {
    const Snapshot snapshot = wet();
    const Raster surface = make_raster("water-surface", {snapshot});
    EXPECT_EQ(surface.values(0, 0), 4.5);
    EXPECT_EQ(surface.values(2, 0), 6.0);
    ASSERT_FALSE(surface.nodata.empty());
    EXPECT_EQ(surface.nodata(1, 0), 1) << "dry";
    EXPECT_EQ(surface.unit, "m");
    EXPECT_EQ(make_raster("water-depth", {snapshot}).values(2, 0), 2.0);
    const Raster speed = make_raster("speed", {snapshot});
    EXPECT_EQ(speed.values(0, 0), 5.0);
    EXPECT_EQ(speed.values(1, 0), 0.0) << "dry";
    EXPECT_EQ(speed.unit, "m s-1");
    const Raster discharge = make_raster("discharge", {snapshot});
    EXPECT_EQ(discharge.values(0, 0), 2.5);
    EXPECT_NEAR(discharge.values(2, 0), 2.0, 1e-15);
    EXPECT_EQ(discharge.unit, "m2 s-1");
    EXPECT_EQ(make_raster("height", {snapshot}).values(1, 0), 5.0) << "in metres";
}

TEST(RasterQuantity, ChangeIsAgainstTheFirstRecord) {
    const Snapshot last = wet();
    Snapshot first = wet();
    first.step = 0;
    first.bed(0, 0) = 1.25;
    const Raster change = make_raster("change", {last, &first});
    EXPECT_EQ(change.values(0, 0), 1.5);
    EXPECT_EQ(change.values(1, 0), 0.0);
    EXPECT_NE(change.long_name.find("step 0"), std::string::npos) << change.long_name;
}

TEST(RasterQuantity, FieldsHaveTheirOwnNames) {
    const Snapshot snapshot = wet();
    const Raster silt = make_raster("silt", {snapshot});
    EXPECT_EQ(silt.values(2, 0), 3.0);
    EXPECT_EQ(silt.long_name, "the silt");
    EXPECT_EQ(silt.unit, "u");
}

TEST(RasterQuantity, WhatIsNotThereIsRefusedWithTheList) {
    const Snapshot snapshot = valley();
    const std::string list = "there are height, slope, aspect, hillshade, drainage, wetness";
    EXPECT_EQ(refusal("slop", {snapshot}), "\"slop\" is not a field; " + list);
    EXPECT_EQ(refusal("speed", {snapshot}), "\"speed\" is not in it; " + list);
    EXPECT_EQ(refusal("change", {snapshot}), "\"change\" is not in it; " + list);
    EXPECT_NE(refusal("mud", {wet()}).find("wetness, water_depth, velocity_x, velocity_y, silt"),
              std::string::npos);
}

TEST(RasterQuantity, MaskedCellsHaveNoValue) {
    Snapshot snapshot = valley();
    snapshot.nodata = Mask(21, 40);
    snapshot.nodata(3, 3) = 1;
    for (const auto* name : {"height", "slope", "hillshade", "drainage", "wetness"}) {
        const Raster raster = make_raster(name, {snapshot});
        ASSERT_FALSE(raster.nodata.empty()) << name;
        EXPECT_EQ(raster.nodata(3, 3), 1) << name;
        EXPECT_EQ(raster.values(3, 3), 0.0) << name;
        EXPECT_EQ(raster.nodata(4, 3), 0) << name;
    }
}

}  // namespace
}  // namespace fumon::test
