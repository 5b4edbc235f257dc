#include <gtest/gtest.h>

#include <algorithm>
#include <any>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "hop_law/hop_law_scene.h"
#include "models/sand/sand_parameters.h"
#include "scene/read.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* small_air = R"(title = "A small wind"
[model]
name = "airflow"
nz = 15
time_step = 1e-5
launch_angles = [20.0, 40.0]
[grid]
nx = 100
cell_size = 1e-4
[run]
steps = 100
)";

SandParameters sand_of(const Scene& scene) {
    return std::any_cast<SandParameters>(scene.model.parameters);
}

class HopLawTest : public ::testing::Test {
  protected:
    void SetUp() override { write_text(folder_ / "air.toml", small_air); }

    Ended measure(std::vector<std::string> more = {}, const std::string& output = "law.toml") {
        std::vector<std::string> arguments{"hop-law", "air.toml", "-o", output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return fumon(arguments, folder_.path());
    }

    /// One line that says this, the status, and no file left.
    void expect_refused(const Ended& ended, int status, const std::string& what) {
        EXPECT_EQ(ended.status, status);
        EXPECT_NE(ended.errors.find(what), std::string::npos) << ended.errors;
        EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "law.toml"));
        EXPECT_FALSE(fs::exists(folder_ / "law.toml.part"));
    }

    ScratchFolder folder_;
};

TEST_F(HopLawTest, TheSceneItWritesRuns) {
    const Ended ended = measure();
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(ended.output, "");
    EXPECT_NE(ended.errors.find("Reynolds"), std::string::npos) << ended.errors;
    EXPECT_NE(ended.errors.find("schiller-naumann"), std::string::npos) << "they outrun Stokes";
    EXPECT_EQ(fumon({"check", "law.toml"}, folder_.path()).status, 0);
    const Ended run = fumon(
        {"run", "law.toml", "-o", "out", "-q", "--set", "run.steps=5", "--set", "frames.at=[5]",
         "--set", "output.fields_at=[]", "--set", "image.width=64", "--set", "image.height=48"},
        folder_.path());
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(read_manifest(folder_ / "out")["steps_done"], 5);
    EXPECT_TRUE(read_scene(folder_ / "law.toml").figure.panels.empty())
        << "the paper's figure is not the measured law's";
}

TEST_F(HopLawTest, WritesTheSandOfSection5OnTheScaleOfEquation45) {
    ASSERT_EQ(measure({"-q"}).status, 0);
    const Scene scene = read_scene(folder_ / "law.toml");
    const SandParameters sand = sand_of(scene);
    EXPECT_EQ(scene.grid.nx, 100);
    EXPECT_EQ(scene.grid.ny, 100);
    EXPECT_EQ(scene.run.steps, 300);
    EXPECT_EQ(sand.hop_length, HopLength::exponential);
    EXPECT_EQ(sand.landing, Landing::round);
    EXPECT_EQ(sand.amount, 0.1);
    EXPECT_EQ(sand.creep_rate, 0.7);
    EXPECT_EQ(sand.exponential_length, 100.0);
    EXPECT_NEAR(sand.exponential_height, 0.25, 1e-9);
    EXPECT_NEAR(scene.grid.height_unit.value, 0.5e-3, 1e-9) << "the bed's range";
    ASSERT_EQ(scene.grid.cell_size.size(), 1U);
    const double crest = std::sqrt(sand.exponential_base) - 1.0;  // a^(2 h0) - 1, mm
    EXPECT_NEAR(scene.grid.cell_size[0], 1e-4 * crest, 1e-12) << "a tenth of the crest's hop";
}

TEST_F(HopLawTest, TheSceneSaysWhatItComesFrom) {
    ASSERT_EQ(measure({"-q", "--hops", "2", "--set", "seed=4", "--set",
                       "model.drag=schiller-naumann", "--set", "title=two\nlines"})
                  .status,
              0);
    const std::string text = read_text(folder_ / "law.toml");
    for (const char* part :
         {" hop-law: air of air.toml (seed 4) after 100 steps, "
          "0.001 s, not steady yet",
          "# 200 grains of 0.3 mm and 2650 kg/m^3, Schiller and Naumann's drag, 2 hops",
          "# --set model.drag=schiller-naumann\n", "# --set title=two?lines\n",
          "# The law: L = 10 (a^(2 h0 h) - 1)"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text.substr(0, 1500);
    }
}

/// The law again from the table of flights, by the mean of the squares' derivative: at the least
/// squares in l, Σ h a^h (l − a^h + 1) = 0.
TEST_F(HopLawTest, TheBaseIsTheLeastSquaresOfTheFlightsWritten) {
    ASSERT_EQ(measure({"-q", "--flights", "flights.csv"}).status, 0);
    const double base = sand_of(read_scene(folder_ / "law.toml")).exponential_base;
    std::istringstream table(read_text(folder_ / "flights.csv"));
    std::string line;
    ASSERT_TRUE(std::getline(table, line));
    EXPECT_EQ(line, "x,height,slope,angle,length,time,reynolds");
    double along = 0.0;
    double size = 0.0;
    int rows = 0;
    while (std::getline(table, line)) {
        std::istringstream cells(line);
        std::vector<double> values;
        for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
        ASSERT_EQ(values.size(), 7U);
        const double height = 1e3 * values[1];
        const double grown = std::pow(base, height);
        along += height * grown * (1e3 * values[4] - grown + 1.0);
        size += height * grown * std::fabs(1e3 * values[4]);
        EXPECT_EQ(values[3], rows < 100 ? 20.0 : 40.0);
        ++rows;
    }
    EXPECT_EQ(rows, 200);
    EXPECT_LT(std::fabs(along), 1e-9 * size);
}

TEST_F(HopLawTest, IsTheSameOnAnyThreadsAndReplacesItsFile) {
    ASSERT_EQ(measure({"-q", "--threads", "2", "--hops", "2"}, "one.toml").status, 0);
    ASSERT_EQ(measure({"-q", "--threads", "1"}, "one.toml").status, 0);
    ASSERT_EQ(measure({"-q", "--threads", "3"}, "three.toml").status, 0);
    EXPECT_EQ(read_text(folder_ / "one.toml"), read_text(folder_ / "three.toml"));
}

TEST_F(HopLawTest, ATableOfFlightsBelongsToTheLawThatNamesIt) {
    fs::create_directory(folder_ / "tables");
    const std::vector<std::string> flights{"-q", "--flights", "tables/f.csv"};
    ASSERT_EQ(measure(flights).status, 0);
    EXPECT_NE(read_text(folder_ / "law.toml").find("\n# Every flight: tables/f.csv\n"),
              std::string::npos);
    EXPECT_EQ(measure(flights).status, 0) << "the same command once more";
    const std::string table = read_text(folder_ / "tables/f.csv");
    const Ended other = measure({"-q", "--hops", "2", "--flights", "tables/f.csv"}, "other.toml");
    EXPECT_EQ(other.status, 2);
    EXPECT_EQ(other.errors,
              "tables/f.csv: already exists and was not made by fumon; name another output, or "
              "replace it with --force\n");
    EXPECT_EQ(read_text(folder_ / "tables/f.csv"), table);
    EXPECT_FALSE(fs::exists(folder_ / "other.toml"));
    EXPECT_EQ(measure({"-q", "--hops", "2", "--flights", "tables/f.csv", "--force"}).status, 0);
}

TEST_F(HopLawTest, FliesWithAndWithoutModelFlights) {
    ASSERT_EQ(measure({"-q", "--set", "model.flights=false"}, "without.toml").status, 0);
    ASSERT_EQ(measure({"-q", "--set", "model.flights=true"}, "with.toml").status, 0);
    EXPECT_EQ(sand_of(read_scene(folder_ / "with.toml")).exponential_base,
              sand_of(read_scene(folder_ / "without.toml")).exponential_base);
}

TEST_F(HopLawTest, HopsInSuccessionAreLonger) {
    ASSERT_EQ(measure({"-q"}, "one.toml").status, 0);
    ASSERT_EQ(measure({"-q", "--hops", "5"}, "five.toml").status, 0);
    const double one = sand_of(read_scene(folder_ / "one.toml")).exponential_base;
    const double five = sand_of(read_scene(folder_ / "five.toml")).exponential_base;
    EXPECT_GT(std::sqrt(five) - 1.0, 2.0 * (std::sqrt(one) - 1.0));
}

TEST_F(HopLawTest, IntoKeepsAllButTheHopLength) {
    write_text(folder_ / "sand.toml", R"(title = "My sand"
seed = 7
[model]
name = "sand"
order = "random-sequential"
hop_base = 3.0
amount = 0.05
creep_rate = 0.2
[grid]
nx = 40
ny = 30
cell_size = 0.02
[bed]
high = 0.5
[run]
steps = 4
[camera]
azimuth = 190
)");
    ASSERT_EQ(measure({"-q", "--into", "sand.toml"}).status, 0);
    const auto with_old_law = [&](const std::string& file) {
        return fumon({"still", file, "-o", "a.png", "-q", "--set", "model.hop_length=linear",
                      "--set", "image.width=64", "--set", "image.height=48"},
                     folder_.path());
    };
    const Scene before = read_scene(folder_ / "sand.toml");
    const Scene after = read_scene(folder_ / "law.toml");
    EXPECT_EQ(after.title, "My sand");
    EXPECT_EQ(after.seed, 7);
    EXPECT_EQ(after.grid.nx, 40);
    EXPECT_EQ(after.grid.cell_size, before.grid.cell_size);
    EXPECT_TRUE(after.grid.height_unit.is_word()) << "the sand has a scale of its own";
    EXPECT_EQ(after.view.camera.azimuth, 190.0);
    EXPECT_EQ(sand_of(after).order, HopOrder::random_sequential);
    EXPECT_EQ(sand_of(after).creep_rate, 0.2);
    EXPECT_EQ(sand_of(after).hop_base, 3.0);
    EXPECT_EQ(sand_of(after).hop_length, HopLength::exponential);
    EXPECT_EQ(with_old_law("law.toml").status, 0);
}

TEST_F(HopLawTest, IntoFindsABedFileFromWhereTheLawIs) {
    fs::create_directories(folder_ / "sands");
    fs::create_directories(folder_ / "laws");
    std::string grid = "ncols 8\nnrows 6\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (int row = 0; row < 6; ++row) grid += "0 0.1 0.2 0.3 0.4 0.3 0.2 0.1\n";
    write_text(folder_ / "sands" / "bed.asc", grid);
    write_text(folder_ / "sands" / "sand.toml",
               "[model]\nname = \"sand\"\nhop_base = 1\n[bed]\nkind = \"file\"\nfile = "
               "\"bed.asc\"\n[run]\nsteps = 3\n");
    ASSERT_EQ(measure({"-q", "--into", "sands/sand.toml"}, "laws/law.toml").status, 0);
    EXPECT_EQ(read_scene(folder_ / "laws" / "law.toml").bed.file, "../sands/bed.asc");
    const Ended check = fumon({"check", "laws/law.toml"}, folder_.path());
    EXPECT_EQ(check.status, 0) << check.errors;
}

TEST_F(HopLawTest, IntoFindsTheFilesOfAFigureFromWhereTheLawIs) {
    fs::create_directories(folder_ / "sands");
    fs::create_directories(folder_ / "laws");
    write_text(folder_ / "sands" / "other.toml", small_scene());
    write_text(folder_ / "sands" / "points.csv", "x,y\n1,2\n");
    write_text(folder_ / "sands" / "sand.toml", R"([model]
name = "sand"
hop_base = 1
[run]
steps = 3
[[figure.panel]]
kind = "map"
scene = "other.toml"
[[figure.panel]]
kind = "plot"
[[figure.panel.curve]]
table = "file"
file = "points.csv"
x = "x"
y = "y"
)");
    ASSERT_EQ(measure({"-q", "--into", "sands/sand.toml"}, "laws/law.toml").status, 0);
    const Scene law = read_scene(folder_ / "laws" / "law.toml");
    ASSERT_EQ(law.figure.panels.size(), 2U);
    EXPECT_EQ(law.figure.panels[0].scene, "../sands/other.toml");
    EXPECT_EQ(law.figure.panels[1].curves[0].file, "../sands/points.csv");
    const Ended check = fumon({"check", "laws/law.toml"}, folder_.path());
    EXPECT_EQ(check.status, 0) << check.errors;
}

TEST_F(HopLawTest, LinesTablesAndSlopesAreCheckedScenesToo) {
    for (const char* form : {"linear", "table", "slope"}) {
        const Ended ended = measure({"-q", "--form", form}, "form.toml");
        ASSERT_EQ(ended.status, 0) << form << ": " << ended.errors;
        EXPECT_EQ(fumon({"check", "form.toml"}, folder_.path()).status, 0) << form;
        const SandParameters sand = sand_of(read_scene(folder_ / "form.toml"));
        if (sand.hop_length == HopLength::linear) {
            // near the exponential's 10 sites from the crest, height 1
            EXPECT_NEAR(sand.hop_base + sand.hop_per_height, 10.0, 2.0);
        } else if (sand.hop_length == HopLength::tabulated) {
            EXPECT_GT(sand.hop_table_heights.size(), 10U);
            EXPECT_GE(sand.hop_table_heights.front(), 0.0);
            EXPECT_LE(sand.hop_table_heights.back(), 1.0);
            EXPECT_NEAR(sand.hop_table_lengths.back(), 10.0, 2.0);
        } else {
            EXPECT_EQ(sand.hop_length, HopLength::slope);
            EXPECT_GE(sand.hop_slope_factor, 0.0);
        }
    }
}

/// Flights of 1 mm per 1 mm of height and 0.1 mm from the trough, over a bed of 0.4 mm.
std::vector<Flight> straight_flights() {
    std::vector<Flight> flights;
    for (int n = 0; n <= 40; ++n) {
        Flight flight;
        flight.height = 0.003 + 1e-5 * n;
        flight.length = 1e-4 + 1e-5 * n;
        flight.angle = 30.0;
        flights.push_back(flight);
    }
    return flights;
}

double value_of(const std::vector<Override>& settings, const std::string& key) {
    for (const Override& one : settings) {
        if (one.path == key) return std::stod(one.value);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

TEST(HopLawScale, LinesAndSlopesAreInSitesAndModelHeights) {
    std::vector<Flight> flights = straight_flights();
    const std::vector<double> angles{30.0};
    const MeasuredHops straight = measure_hops(flights, angles);
    EXPECT_NEAR(straight.height, 0.4, 1e-12);
    const auto line = law_settings(straight, HopForm::linear);
    EXPECT_NEAR(value_of(line, "model.hop_base"), 0.1 / straight.site, 1e-9);
    EXPECT_NEAR(value_of(line, "model.hop_per_height"), 0.4 / straight.site, 1e-9);

    // the same flights from where the dune rule has them: L = 6 - 8 tanh(dh/dx), in model units
    for (Flight& flight : flights) {
        const double sites = 1e3 * flight.length / straight.site;
        flight.slope = std::atanh((6.0 - sites) / 8.0) * straight.height / straight.site;
    }
    const auto dunes = law_settings(measure_hops(flights, angles), HopForm::slope);
    EXPECT_NEAR(value_of(dunes, "model.hop_base"), 6.0, 1e-9);
    EXPECT_NEAR(value_of(dunes, "model.hop_slope_factor"), 8.0, 1e-9);
}

TEST_F(HopLawTest, AHopBaseBelowNothingIsALawOfTheSandModel) {
    ASSERT_EQ(measure({"-q", "--form", "linear"}).status, 0);
    EXPECT_LT(sand_of(read_scene(folder_ / "law.toml")).hop_base, 0.0);
    EXPECT_EQ(fumon({"check", "law.toml"}, folder_.path()).status, 0);
}

TEST_F(HopLawTest, RefusesTheDuneRuleWhereFlightsLengthenWithTheSlope) {
    expect_refused(measure({"-q", "--form", "slope", "--set", "model.scheme=boundary-fitted",
                            "--set", "run.steps=600"}),
                   3, "needs alpha >= 0");
}

TEST_F(HopLawTest, RefusesWhatItCannotUse) {
    write_text(folder_ / "sand.toml", small_scene());
    expect_refused(fumon({"hop-law", "sand.toml", "-o", "law.toml"}, folder_.path()), 2,
                   "but this scene has the model sand");
    expect_refused(measure({"--into", "air.toml"}), 2, "a hop law is for the model sand");
    expect_refused(measure({"--form", "cubic"}), 2, "cubic");
    expect_refused(measure({"--hops", "0"}), 2, "--hops");
    expect_refused(measure({"--flights", "./law.toml"}), 2, "the name of a table must end in .csv");
    expect_refused(measure({}, "air.toml"), 2, "would be replaced");
    EXPECT_EQ(read_text(folder_ / "air.toml"), small_air);
    expect_refused(measure({}, "nowhere/law.toml"), 3, "cannot write nowhere/law.toml");
    expect_refused(measure({"--flights", "nowhere/f.csv"}), 3, "cannot write nowhere/f.csv");
}

TEST_F(HopLawTest, GrainsThatDoNotLandAreOneLineAndNoFile) {
    expect_refused(measure({"-q", "--set", "model.lid_speed=8", "--set", "model.time_step=1e-6",
                            "--flights", "flights.csv"}),
                   3, "leaves through the lid");
    EXPECT_FALSE(fs::exists(folder_ / "flights.csv"));
    expect_refused(measure({"-q", "--set", "model.bed=given"}), 3, "needs a bed with relief");
    expect_refused(measure({"-q", "--set", "model.launch_angles=[150]"}), 3,
                   "do not grow with the height");
}

TEST_F(HopLawTest, AnInterruptLeavesNoFile) {
    Program program({"hop-law", "air.toml", "-o", "law.toml", "-q", "--set", "run.steps=100000000"},
                    folder_.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    program.send(SIGINT);
    const Ended ended = program.wait();
    EXPECT_EQ(ended.status, 130) << ended.errors;
    EXPECT_FALSE(fs::exists(folder_ / "law.toml"));
    EXPECT_FALSE(fs::exists(folder_ / "law.toml.part"));
}

}  // namespace
}  // namespace fumon::test
