#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "files/netcdf/netcdf_fields.h"
#include "support/program.h"

namespace fumon::test {
namespace {

/// A bed of four waves of 8 sites, one row high or more, as ESRI ASCII.
std::string waves(int rows, double shift = 0.0) {
    std::string text =
        "ncols 32\nnrows " + std::to_string(rows) + "\nxllcorner 0\nyllcorner 0\ncellsize 2\n";
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < 32; ++x) {
            text += std::to_string(3.0 + std::sin(6.283185307179586 * (x - shift) / 8.0));
            text += x < 31 ? ' ' : '\n';
        }
    }
    return text;
}

nlohmann::json measured(const ScratchFolder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "measure");
    arguments.emplace_back("--json");
    const Ended ended = fumon(arguments, folder.path());
    EXPECT_EQ(ended.status, 0) << ended.errors;
    return nlohmann::json::parse(ended.output);
}

nlohmann::json value_of(const nlohmann::json& all, const std::string& name) {
    for (const auto& one : all["measures"]) {
        if (one["name"] == name) return one;
    }
    return nullptr;
}

TEST(Measure, TellsWavelengthsInMetres) {
    const ScratchFolder folder;
    write_text(folder / "bed.asc", waves(8));
    const auto all = measured(folder, {"bed.asc"});
    for (const char* name :
         {"wavelength_spectrum", "wavelength_autocorrelation", "wavelength_crossings"}) {
        const auto wavelength = value_of(all, name);
        EXPECT_NEAR(wavelength["value"].get<double>(), 16.0, 0.2) << name;
        EXPECT_EQ(wavelength["unit"], "m");
    }
    EXPECT_NEAR(value_of(all, "crest_to_trough_height")["value"].get<double>(), 2.0, 1e-5);
    EXPECT_NEAR(value_of(all, "mean_height")["value"].get<double>(), 3.0, 1e-6);
    EXPECT_TRUE(value_of(all, "celerity")["value"].is_null()) << "of one bed alone";
}

TEST(Measure, TwoBedsHaveACelerity) {
    const ScratchFolder folder;
    write_text(folder / "before.asc", waves(8));
    write_text(folder / "after.asc", waves(8, 1.0));
    const auto all = measured(folder, {"after.asc", "--earlier", "before.asc", "--steps", "5"});
    EXPECT_NEAR(value_of(all, "celerity")["value"].get<double>(), 2.0 / 5.0, 0.01);
    EXPECT_EQ(value_of(all, "celerity")["unit"], "m/step");
}

TEST(Measure, ARowIsAProfileAndAPileHasACone) {
    const ScratchFolder folder;
    write_text(folder / "row.asc", waves(1));
    EXPECT_EQ(value_of(measured(folder, {"row.asc"}), "dune_count"), nullptr);
    EXPECT_NE(value_of(measured(folder, {"row.asc"}), "wavelength_crossings"), nullptr);
    std::string pile = "ncols 21\nnrows 21\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (int y = 0; y < 21; ++y) {
        for (int x = 0; x < 21; ++x) {
            const double r = std::sqrt((x - 13.0) * (x - 13.0) + (y - 10.0) * (y - 10.0));
            pile += std::to_string(std::max(0.0, 12.0 - 2.0 * r)) + (x < 20 ? " " : "\n");
        }
    }
    write_text(folder / "pile.asc", pile);
    const auto all = measured(folder, {"pile.asc", "--as", "pile", "--drop", "10", "10"});
    EXPECT_NEAR(value_of(all, "cone_offset")["value"].get<double>(), 3.0, 1e-3);
    EXPECT_NEAR(value_of(all, "cone_offset_azimuth")["value"].get<double>(), 90.0, 0.1);
    EXPECT_NEAR(value_of(all, "cone_slope")["value"].get<double>(), 2.0, 1e-4);
}

TEST(Measure, AFieldsFileHasItsWaterMeasured) {
    const ScratchFolder folder;
    Snapshot slope;
    slope.time_unit = "s";
    slope.periodic = true;
    slope.scale = {2.0, 2.0, 1.0, true};
    slope.bed = Grid(60, 8, 0.25);
    Grid depth(60, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 60; ++x)
            depth(x, y) = 0.01 + 0.001 * std::cos(6.283185307179586 * x / 20.0);
    }
    slope.fields = {{"water_depth", "depth of the water", "m", depth},
                    {"velocity_x", "velocity eastward", "m s-1", Grid(60, 8, 0.0)},
                    {"velocity_y", "velocity northward", "m s-1", Grid(60, 8, -0.5)}};
    slope.numbers = {{"mean_slope", "1", 0.04}, {"rain_volume", "m3", 12.0}};
    FieldsFile file(folder / "fields.nc", slope, {"a slope", "seed = 1\n", 1});
    file.add(slope);
    file.commit();
    const auto all = measured(folder, {"fields.nc"});
    EXPECT_EQ(value_of(all, "channel_count")["value"], 3.0);
    EXPECT_NEAR(value_of(all, "channel_spacing")["value"].get<double>(), 40.0, 1e-9);
    EXPECT_EQ(value_of(all, "channel_spacing")["unit"], "m");
    EXPECT_NEAR(value_of(all, "downslope_flux")["value"].get<double>(), 0.005, 1e-9);
    EXPECT_EQ(value_of(all, "rain_volume")["value"], 12.0);
    EXPECT_NEAR(value_of(all, "mean_height")["value"].get<double>(), 0.25, 1e-12);
    EXPECT_EQ(value_of(measured(folder, {"fields.nc", "--as", "bed"}), "channel_count"), nullptr);
    EXPECT_EQ(value_of(measured(folder, {"fields.nc", "--set", "bed.variable=water_depth"}),
                       "channel_count"),
              nullptr)
        << "that variable alone is measured, as a bed";
}

TEST(Measure, MeasuresTheAirThatAFieldsFileHolds) {
    const ScratchFolder folder;
    constexpr int nx = 64;
    constexpr int nz = 20;
    constexpr double turn = 6.283185307179586;
    SnapshotSection section;
    section.dx = 0.5;
    section.dz = 0.25;
    section.fields = {{"velocity_x", "velocity of the air along x", "m/s", Grid(nx, nz, 3.0)},
                      {"velocity_z", "velocity of the air upward", "m/s", Grid(nx, nz, 4.0)},
                      {"pressure", "pressure of the air", "Pa", Grid(nx, nz, 1.0)}};
    section.fields[0].values(7, 15) = -0.5;
    SectionCurve stress{"bed_shear_stress", "shear stress on the bed", "Pa", {}};
    SectionCurve flights{"flight_length_30", "flight length", "m", std::vector<double>(nx, 0.25)};
    flights.values[5] = std::numeric_limits<double>::quiet_NaN();
    flights.values[6] = 0.75;
    Snapshot snapshot;
    snapshot.time_unit = "s";
    snapshot.scale = {0.5, 0.5, 1.0, true};
    snapshot.periodic = true;
    snapshot.bed = Grid(nx, 1);
    for (int i = 0; i < nx; ++i) {
        snapshot.bed(i, 0) = 1.0 + 0.5 * std::cos(turn * 2 * i / nx);
        stress.values.push_back(0.01 + 0.005 * std::cos(turn * (2.0 * i / nx + 1.0 / 12.0)));
    }
    section.curves = {stress, flights};
    snapshot.numbers = {{"lid_speed", "m/s", 0.5}};
    snapshot.section = std::make_shared<const SnapshotSection>(section);
    FieldsFile file(folder / "fields.nc", snapshot, {"air", "seed = 1\n", 1});
    file.add(snapshot);
    file.commit();
    const auto all = measured(folder, {"fields.nc"});
    EXPECT_NEAR(value_of(all, "stress_lead")["value"].get<double>(), 30.0, 1e-6);
    EXPECT_NEAR(value_of(all, "stress_lead_length")["value"].get<double>(), 16.0 / 12.0, 1e-6);
    EXPECT_NEAR(value_of(all, "largest_speed")["value"].get<double>(), 5.0, 1e-12);
    EXPECT_NEAR(value_of(all, "eddy_length")["value"].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(value_of(all, "mean_flight_length_30")["value"].get<double>(),
                (62 * 0.25 + 0.75) / 63, 1e-12);
    EXPECT_EQ(value_of(all, "longest_flight_length_30")["value"], 0.75);
    EXPECT_EQ(value_of(all, "lid_speed")["value"], 0.5);
    EXPECT_EQ(value_of(measured(folder, {"fields.nc", "--as", "profile"}), "stress_lead"), nullptr);
}

TEST(Measure, AvalanchesHaveASizeDistribution) {
    const ScratchFolder folder;
    std::string table = "grain,size,duration,topplings,lost\n";
    long long grain = 0;
    for (int size = 10; size <= 100; ++size) {  // shares fall as size^-2
        for (int k = 0; k < 4000000 / (size * size * 10); ++k)
            table += std::to_string(++grain) + "," + std::to_string(size) + ",1,1,0\n";
    }
    write_text(folder / "avalanches.csv", table);
    const auto all = measured(folder, {"avalanches.csv"});
    EXPECT_EQ(all["avalanches"], grain);
    EXPECT_EQ(all["largest_size"], 100);
    EXPECT_NEAR(all["least_squares"]["slope"].get<double>(), -2.0, 0.01);
    EXPECT_NEAR(all["likelihood"]["exponent"].get<double>(), 2.0, 0.02);
    EXPECT_GT(all["likelihood"]["probability"].get<double>(), 0.1);
    EXPECT_EQ(all["bins"].size(), 91U);
    const Ended text = fumon({"measure", "avalanches.csv", "--window", "12:90"}, folder.path());
    EXPECT_NE(text.output.find("A power law in 12 to 90 cells?"), std::string::npos);
}

TEST(Measure, ChannelsByTheAreaThatDrainsThroughThem) {
    const ScratchFolder folder;
    std::string valley = "ncols 21\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
    for (int y = 39; y >= 0; --y) {
        for (int x = 0; x < 21; ++x)
            valley += std::to_string(10.0 * std::abs(x - 10) + 0.1 * y) + (x < 20 ? ' ' : '\n');
    }
    write_text(folder / "valley.asc", valley);
    EXPECT_EQ(value_of(measured(folder, {"valley.asc"}), "drainage_density"), nullptr);
    const auto all = measured(folder, {"valley.asc", "--channel-area", "4000"});
    EXPECT_EQ(value_of(all, "stream_sources")["value"], 1.0);
    EXPECT_EQ(value_of(all, "drainage_density")["unit"], "1/m");
    // The longest way down is along the valley's floor, and all of it drains through its mouth.
    const Ended profile = fumon({"profile", "valley.asc"}, folder.path());
    ASSERT_EQ(profile.status, 0) << profile.errors;
    EXPECT_TRUE(profile.output.starts_with("distance_m,x,y,level_m,bed_m,depth_m,area_m2\n"));
    EXPECT_NE(profile.output.find(",105,5,0,0,0,72300\n"), std::string::npos) << profile.output;
    // A line across it, down to its floor and along it: heights are linear between cells' centres.
    const Ended line =
        fumon({"profile", "valley.asc", "-o", "-", "--along", "5,105", "105,105", "105,5"},
              folder.path());
    ASSERT_EQ(line.status, 0) << line.errors;
    EXPECT_TRUE(
        line.output.starts_with("distance_m,x,y,level_m,bed_m,depth_m\n0,5,105,101,101,0\n"
                                "5,10,105,96,96,0\n"))
        << line.output;
    EXPECT_NE(line.output.find("\n100,105,105,1,1,0\n105,105,100,0.95,0.95,0\n"), std::string::npos)
        << line.output;
    EXPECT_TRUE(line.output.ends_with("\n200,105,5,0,0,0\n")) << line.output;
    EXPECT_EQ(fumon({"profile", "valley.asc", "--along", "5,105", "5,1e4"}, folder.path()).errors,
              "--along 5,1e4 lies outside the grid, which goes from 0,0 to 210,400 m\n");
    // A run records them too, from its key.
    const Ended run =
        fumon({"run", "valley.asc", "-o", "out", "--quiet", "--set", "model.name=water", "--set",
               "run.steps=1", "--set", "output.frames=false", "--set", "output.movie=false",
               "--set", "output.channel_area=4000"},
              folder.path());
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_NE(read_text(folder / "out/measurements.csv").find(",bifurcation_ratio,"),
              std::string::npos);
}

TEST(Measure, WrongUsageIsOneLine) {
    const ScratchFolder folder;
    write_text(folder / "bed.asc", waves(8));
    write_text(folder / "narrow.asc", waves(4));
    const auto refused = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "measure");
        const Ended ended = fumon(arguments, folder.path());
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.output, "");
        return ended.errors;
    };
    EXPECT_EQ(refused({"none.asc"}), "none.asc: does not exist; check the path\n");
    EXPECT_EQ(refused({"bed.asc", "--as", "profile"}),
              "--as profile: bed.asc has 8 rows; a profile has one\n");
    EXPECT_EQ(refused({"bed.asc", "--as", "pile", "--drop", "40", "2"}),
              "--drop 40 2 lies outside the 32 x 8 cells of bed.asc\n");
    EXPECT_EQ(refused({"bed.asc", "--earlier", "narrow.asc", "--steps", "2"}),
              "narrow.asc has 32 x 4 cells and bed.asc has 32 x 8; celerity needs two beds of the "
              "same size\n");
    EXPECT_EQ(refused({"bed.asc", "--earlier", "narrow.asc"}),
              "fumon measure: --earlier and --steps go together: an earlier bed and the steps "
              "between the two\n");
    write_text(folder / "a.csv", "grain,size,duration,topplings,lost\n1,4,1,1,0\n");
    EXPECT_EQ(refused({"a.csv", "--window", "ten"}),
              "--window is \"ten\"; it takes low:high in cells, for example 10:100\n");
}

}  // namespace
}  // namespace fumon::test
