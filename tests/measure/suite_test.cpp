#include "measure/suite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <set>

#include "base/worker_pool.h"
#include "files/checkpoint.h"
#include "support/measured_beds.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

Snapshot bed_of(int nx, int ny, std::int64_t step = 0, double shift = 0.0) {
    Snapshot snapshot;
    snapshot.step = step;
    snapshot.periodic = true;
    snapshot.bed = Grid(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x)
            snapshot.bed(x, y) = 2.0 + std::sin(6.283185307179586 * (x - shift) / 10.0);
    }
    return snapshot;
}

double value_of(const MeasureSuite& suite, const std::vector<double>& row,
                const std::string& name) {
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (suite.columns()[k].name == name) return row[k];
    }
    ADD_FAILURE() << "there is no column " << name;
    return 0.0;
}

TEST(MeasureSuite, EveryRowHasAValueForEveryColumnAndNamesAreDistinct) {
    for (const Landform landform :
         {Landform::bed, Landform::profile, Landform::pile, Landform::water, Landform::air}) {
        MeasureSuite suite(landform);
        std::set<std::string> names;
        for (const MeasureColumn& column : suite.columns()) {
            EXPECT_TRUE(names.insert(column.name).second) << column.name;
            EXPECT_FALSE(column.help.empty()) << column.name;
        }
        const bool is_row = landform == Landform::profile || landform == Landform::air;
        EXPECT_EQ(suite.row(bed_of(40, is_row ? 1 : 20)).size(), names.size());
        Snapshot masked = bed_of(40, 20);
        masked.nodata = Mask(40, 20);
        masked.nodata(3, 3) = 1;
        EXPECT_EQ(suite.row(masked).size(), names.size());
    }
}

/// A slope of straight stripes under water of 0.01 m that runs down it.
Snapshot water_of(int nx, int ny) {
    Snapshot snapshot = bed_of(nx, ny);
    snapshot.time_unit = "s";
    snapshot.scale = {2.0, 2.0, 1.0, true};
    Grid depth = snapshot.bed;
    for (double& h : depth.values()) h *= 0.005;
    snapshot.fields = {{"water_depth", "depth of the water", "m", depth},
                       {"velocity_x", "eastward", "m/s", Grid(nx, ny, 0.0)},
                       {"velocity_y", "northward", "m/s", Grid(nx, ny, -0.5)}};
    snapshot.numbers = {{"mean_slope", "1", 0.04}, {"water_volume", "m3", 7.0}};
    return snapshot;
}

Snapshot air_of(int nx) {
    Snapshot snapshot = bed_of(nx, 1);
    SnapshotSection section{0.1, 0.1, {}, {}, {}};
    for (const char* name : {"velocity_x", "velocity_z", "pressure"})
        section.fields.push_back({name, name, "", Grid(nx, 50, 1.0)});
    section.curves = {
        {"bed_shear_stress", "", "Pa",
         std::vector<double>(snapshot.bed.values().begin(), snapshot.bed.values().end())},
        {"flight_length_20", "", "m", std::vector<double>(static_cast<std::size_t>(nx), 0.25)}};
    section.curves.back().values[3] = std::nan("");
    section.curves.back().values[4] = 0.75;
    snapshot.section = std::make_shared<const SnapshotSection>(section);
    snapshot.numbers = {{"hop_base", "1", 5.2}};
    return snapshot;
}

TEST(MeasureSuite, WaterIsMeasuredInMetresAndItsNumbersAreColumns) {
    const Snapshot water = water_of(40, 20);
    EXPECT_EQ(guessed_landform(water), Landform::water);
    MeasureSuite suite(Landform::water, water);
    const auto row = suite.row(water);
    ASSERT_EQ(row.size(), suite.columns().size());
    EXPECT_EQ(value_of(suite, row, "channel_count"), 4.0);
    EXPECT_NEAR(value_of(suite, row, "channel_spacing"), 20.0, 1e-12);
    EXPECT_NEAR(value_of(suite, row, "channel_sinuosity"), 1.0, 1e-12);
    EXPECT_NEAR(value_of(suite, row, "mean_depth"), 0.01, 1e-12);
    EXPECT_NEAR(value_of(suite, row, "downslope_flux"), 0.005, 1e-12);
    EXPECT_NEAR(value_of(suite, row, "downslope_invariant_share"), 1.0, 1e-12);
    EXPECT_EQ(value_of(suite, row, "water_volume"), 7.0);
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (suite.columns()[k].unit != "m") continue;
        const MeasuredValue world = in_world_units({suite.columns()[k], row[k]}, water.scale);
        EXPECT_TRUE(world.value == row[k] || std::isnan(row[k])) << suite.columns()[k].name;
    }
}

TEST(MeasureSuite, WhatRunsDownTheSlopeHasNoMeaningWithoutOne) {
    Snapshot water = water_of(40, 20);
    water.numbers[0].value = 0.0;
    MeasureSuite suite(Landform::water, water);
    const auto row = suite.row(water);
    for (const char* name : {"channel_count", "channel_sinuosity", "downslope_flux",
                             "downslope_depth_variation", "downslope_invariant_share"})
        EXPECT_TRUE(std::isnan(value_of(suite, row, name))) << name;
    EXPECT_NEAR(value_of(suite, row, "mean_speed"), 0.5, 1e-12);
}

TEST(MeasureSuite, AirHasAColumnForEveryFlightAndNumber) {
    const Snapshot air = air_of(40);
    EXPECT_EQ(guessed_landform(air), Landform::air);
    MeasureSuite suite(Landform::air, air);
    const auto row = suite.row(air);
    ASSERT_EQ(row.size(), suite.columns().size());
    EXPECT_NEAR(value_of(suite, row, "stress_lead"), 0.0, 1e-9) << "the stress is the bed";
    EXPECT_EQ(value_of(suite, row, "hop_base"), 5.2);
    EXPECT_NEAR(value_of(suite, row, "mean_flight_length_20"), (38 * 0.25 + 0.75) / 39, 1e-12);
    EXPECT_EQ(value_of(suite, row, "longest_flight_length_20"), 0.75);
    EXPECT_EQ(value_of(suite, row, "eddy_length"), 0.0);
}

// The order of columns is that of measurements.csv.
TEST(MeasureSuite, EveryLandformHasItsOwnColumnsInOrder) {
    const auto names = [](Landform landform, const Snapshot& first) {
        MeasureSuite suite(landform, first);
        std::vector<std::string> all;
        for (const MeasureColumn& column : suite.columns()) all.push_back(column.name);
        return all;
    };
    const auto place = [](const std::vector<std::string>& all, const char* name) {
        return std::find(all.begin(), all.end(), name) - all.begin();
    };
    for (const Landform landform :
         {Landform::bed, Landform::profile, Landform::pile, Landform::water, Landform::air})
        EXPECT_EQ(names(landform, {}).front(), "mean_height");
    const auto bed = names(Landform::bed, {});
    EXPECT_EQ(bed.size(), 28U);
    EXPECT_EQ(place(bed, "wavelength_spectrum"), 5);
    EXPECT_EQ(place(bed, "celerity"), 10);
    EXPECT_EQ(place(bed, "stoss_slope"), 12);
    EXPECT_EQ(place(bed, "crest_orientation"), 17);
    EXPECT_EQ(place(bed, "dune_horn_lag"), 27);
    const auto profile = names(Landform::profile, {});
    EXPECT_EQ(profile, std::vector<std::string>(bed.begin(), bed.begin() + 17));
    const auto pile = names(Landform::pile, {});
    EXPECT_EQ(place(pile, "resident_grains"), 5);
    EXPECT_EQ(place(pile, "avalanches"), 17);
    EXPECT_EQ(pile.size(), 26U);
    const auto water = names(Landform::water, water_of(40, 20));
    EXPECT_EQ(place(water, "channel_count"), 5);
    EXPECT_EQ(place(water, "mean_depth"), 13);
    EXPECT_EQ(place(water, "downslope_flux"), 21);
    EXPECT_EQ(place(water, "mean_slope"), 30);
    const auto air = names(Landform::air, air_of(40));
    EXPECT_EQ(place(air, "stress_lead"), 5);
    EXPECT_EQ(place(air, "largest_speed"), 9);
    EXPECT_EQ(place(air, "mean_flight_length_20"), 17);
    EXPECT_EQ(place(air, "hop_base"), 19);
    EXPECT_EQ(air.size(), 20U);
}

TEST(MeasureSuite, CelerityIsSinceTheRowBefore) {
    MeasureSuite suite(Landform::bed);
    EXPECT_TRUE(std::isnan(value_of(suite, suite.row(bed_of(40, 20)), "celerity")));
    EXPECT_NEAR(value_of(suite, suite.row(bed_of(40, 20, 10, 2.0)), "celerity"), 0.2, 0.005);
    EXPECT_NEAR(value_of(suite, suite.row(bed_of(40, 20, 14, 1.0)), "celerity"), -0.25, 0.005);
}

TEST(MeasureSuite, AvalanchesCountWhetherOrNotTheirStepIsMeasured) {
    MeasureSuite suite(Landform::pile);
    const std::vector<Avalanche> first{{1, 12, 2, 3, 0}, {2, 40, 3, 5, 1}};
    const std::vector<Avalanche> second{{3, 7, 1, 1, 0}};
    suite.note(first);
    suite.note({});
    suite.note(second);
    const auto row = suite.row(bed_of(9, 9));
    EXPECT_EQ(value_of(suite, row, "avalanches"), 3.0);
    EXPECT_EQ(value_of(suite, row, "last_avalanche_size"), 7.0);
    EXPECT_EQ(value_of(suite, row, "largest_avalanche_size"), 40.0);
}

TEST(MeasureSuite, WhatRowsDrawOnGoesOverACheckpoint) {
    const test::TemporaryFolder folder;
    const auto carried = [&](MeasureSuite& from, MeasureSuite& to) {
        CheckpointWriter writer(folder / "suite");
        from.serialise(writer);
        writer.commit();
        to.serialise(*open_checkpoint(folder / "suite"));
    };
    const auto same = [](const std::vector<double>& one, const std::vector<double>& other) {
        return std::equal(
            one.begin(), one.end(), other.begin(), other.end(),
            [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
    };
    MeasureSuite beds(Landform::bed);
    MeasureSuite beds_later(Landform::bed);
    static_cast<void>(beds.row(bed_of(40, 8, 2)));
    carried(beds, beds_later);
    const std::vector<double> row = beds.row(bed_of(40, 8, 4, 1.0));
    EXPECT_TRUE(same(row, beds_later.row(bed_of(40, 8, 4, 1.0))));
    MeasureSuite forgetful(Landform::bed);
    EXPECT_FALSE(same(row, forgetful.row(bed_of(40, 8, 4, 1.0))))
        << "the celerity needs the row before";

    MeasureSuite piles(Landform::pile);
    MeasureSuite piles_later(Landform::pile);
    const std::vector<Avalanche> avalanches{{3, 12, 2, 5, 0}, {4, 30, 3, 9, 1}, {9, 12, 1, 2, 0}};
    piles.note(avalanches);
    carried(piles, piles_later);
    EXPECT_TRUE(same(piles.row(bed_of(10, 10)), piles_later.row(bed_of(10, 10))));
}

TEST(MeasureSuite, LandformsAreToldApart) {
    Snapshot some = bed_of(10, 1);
    EXPECT_EQ(guessed_landform(some), Landform::terrain);
    some.numbers.push_back({"dropped_grains", "grains", 4.0});
    EXPECT_EQ(guessed_landform(some), Landform::pile);
}

TEST(MeasureSuite, ABedOrTerrainOfASingleRowIsMeasuredAsAProfile) {
    for (const Landform landform : {Landform::bed, Landform::terrain}) {
        Snapshot one = bed_of(10, 10);
        one.landform = landform;
        EXPECT_EQ(measured_landform(one), Landform::bed);
        one.bed = Grid(10, 1);
        EXPECT_EQ(measured_landform(one), Landform::profile);
    }
    Snapshot pile = bed_of(10, 1);
    pile.landform = Landform::pile;
    EXPECT_EQ(measured_landform(pile), Landform::pile);
}

TEST(MeasureSuite, MetresTakeThePlaceOfSitesAndHeights) {
    const WorldScale scale{2.0, 3.0, 0.5, true};
    const auto metres = [&](const char* unit) {
        const MeasuredValue found = in_world_units({{"some", unit, ""}, 8.0}, scale);
        return std::pair(found.value, found.column.unit);
    };
    using Found = std::pair<double, std::string>;
    EXPECT_EQ(metres("sites"), Found(16.0, "m"));
    EXPECT_EQ(metres("heights"), Found(4.0, "m"));
    EXPECT_EQ(metres("cells"), Found(48.0, "m2"));
    EXPECT_EQ(metres("heights x cells"), Found(24.0, "m3"));
    EXPECT_EQ(metres("heights/site"), Found(2.0, ""));
    EXPECT_EQ(metres("sites/step"), Found(16.0, "m/step"));
    EXPECT_EQ(metres("degrees"), Found(8.0, "degrees"));
    const MeasuredValue sites = in_world_units({{"some", "sites", ""}, 8.0}, {});
    EXPECT_EQ(sites.value, 8.0);
    EXPECT_EQ(sites.column.unit, "sites");
}

TEST(MeasureSuite, AChoiceOfColumnsMeasuresTheseAloneAndTheSame) {
    MeasureSuite all(Landform::bed);
    MeasureChoice choice;
    choice.columns = {"lee_slope", "waves", "mean_height"};
    MeasureSuite some(Landform::bed, {}, choice);
    std::string names;
    for (const MeasureColumn& column : some.columns()) names += column.name + " ";
    EXPECT_EQ(names,
              "mean_height wavelength_spectrum wavelength_autocorrelation wavelength_crossings "
              "top_one_percent_height crest_to_trough_height lee_slope ")
        << "in the order that all have";
    const Snapshot bed = bed_of(40, 20);
    const std::vector<double> whole = all.row(bed);
    const std::vector<double> row = some.row(bed);
    ASSERT_EQ(row.size(), some.columns().size());
    for (const MeasureColumn& column : some.columns())
        EXPECT_EQ(value_of(some, row, column.name), value_of(all, whole, column.name))
            << column.name;
}

TEST(MeasureSuite, WhatIsNotChosenIsNotComputed) {
    const test::TemporaryFolder folder;
    const auto bytes_after_a_row = [&](const std::vector<std::string>& columns) {
        MeasureChoice choice;
        choice.columns = columns;
        MeasureSuite suite(Landform::bed, {}, choice);
        static_cast<void>(suite.row(bed_of(40, 20)));
        CheckpointWriter writer(folder / "suite");
        suite.serialise(writer);
        writer.commit();
        return std::filesystem::file_size(folder / "suite");
    };
    const auto kept_bed = 40 * 20 * sizeof(double);
    EXPECT_LT(bytes_after_a_row({"mean_height"}), kept_bed) << "no bed for a celerity";
    EXPECT_GT(bytes_after_a_row({"celerity"}), kept_bed);
}

TEST(MeasureSuite, ThreadsMeasureTheSameBits) {
    const auto bits = [](const std::vector<double>& row) {
        std::vector<std::uint64_t> all;
        for (const double value : row) all.push_back(std::bit_cast<std::uint64_t>(value));
        return all;
    };
    for (const int threads : {2, 3, 7}) {
        WorkerPool pool(threads);
        MeasureSuite alone(Landform::bed);
        MeasureSuite together(Landform::bed);
        for (int step = 0; step < 4; ++step) {
            Snapshot snapshot;
            snapshot.step = step;
            snapshot.periodic = true;
            snapshot.bed = test::noise(96, 64, static_cast<std::uint64_t>(step / 2 + 1));
            EXPECT_EQ(bits(alone.row(snapshot)), bits(together.row(snapshot, &pool)));
        }
    }
}

TEST(MeasureSuite, GroupsAndColumnsHaveDistinctNames) {
    for (const Landform landform :
         {Landform::bed, Landform::profile, Landform::pile, Landform::water, Landform::air}) {
        const std::vector<std::string> names =
            MeasureSuite(landform, landform == Landform::water ? water_of(8, 8) : air_of(8),
                         {100.0})
                .names();
        EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
        EXPECT_EQ(names.front(), "statistics");
    }
}

}  // namespace
}  // namespace fumon
