// Every door through which numbers come, at and beyond the ends of their range (base/limits.h).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "base/stopwatch.h"
#include "bmi/coupled_model.h"
#include "files/atomic_file.h"
#include "picture/png.h"
#include "run/prepared_run.h"
#include "scene/read.h"
#include "support/forged_checkpoint.h"
#include "support/netcdf_file.h"
#include "support/program.h"

namespace fumon::test::number_range {
namespace {

namespace fs = std::filesystem;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Of a smallest picture.
const std::string small = "[grid]\nnx = 8\nny = 6\n[image]\nwidth = 16\nheight = 16\n";

std::string scene_of(const std::string& model, const std::string& more) {
    return "[model]\nname = \"" + model + "\"\n[run]\nsteps = 4\n" + more;
}

std::string refusal(const std::string& scene) {
    try {
        prepare_run(parse_scene(scene, "scene.toml", ""), 1);
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "taken";
}

struct KeyOfRange {
    const char* model;
    const char* more;
    const char* key;
    double end;
};

class NumberRangeOfKeys : public ::testing::TestWithParam<KeyOfRange> {};

TEST_P(NumberRangeOfKeys, EndsAreTakenAndWhatIsBeyondIsRefused) {
    const KeyOfRange& one = GetParam();
    const auto with = [&](const std::string& number) {
        const std::string line = std::string(one.key) + " = " + number + "\n";
        return refusal(line + one.more + scene_of(one.model, ""));
    };
    EXPECT_EQ(with(fmt::format("{:e}", one.end)), "taken") << one.key;
    std::vector<std::string> beyond{fmt::format("{:.17e}", std::nextafter(one.end, infinite)),
                                    "1e300", "1.797e308", "inf", "nan"};
    for (const std::string& number : beyond) {
        const std::string why = with(number);
        EXPECT_TRUE(why.starts_with("scene.toml:1:")) << one.key << " " << number << ": " << why;
        EXPECT_NE(why.find(one.key), std::string::npos) << why;
        EXPECT_EQ(why.find('\n'), std::string::npos) << why;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, NumberRangeOfKeys,
    ::testing::Values(
        KeyOfRange{"static", "bed.kind = \"flat\"\n", "bed.height", largest_height},
        KeyOfRange{"static", "bed.kind = \"noise\"\n", "bed.high", largest_height},
        KeyOfRange{"static", "bed.kind = \"noise\"\nbed.high = 1e6\n", "bed.low", largest_height},
        KeyOfRange{"static", "bed.kind = \"flat\"\n", "grid.cell_size", largest_cell_size},
        KeyOfRange{"sand", "bed.kind = \"flat\"\nbed.height = 0.1\n", "grid.height_unit",
                   largest_height_unit},
        KeyOfRange{"static", "", "look.low", largest_colour_value},
        KeyOfRange{"static", "", "look.high", largest_colour_value},
        KeyOfRange{"static", "", "camera.distance", 100.0},
        KeyOfRange{"static", "camera.aperture = 0.1\n", "camera.focus", largest_coordinate},
        KeyOfRange{"static", "", "sun.azimuth", 360.0},
        KeyOfRange{"static", "", "look.exaggeration", 1e4}));

TEST(NumberRange, OfLists) {
    const auto with = [](const std::string& line) {
        return refusal(line + "\n" + scene_of("static", small));
    };
    EXPECT_EQ(with("camera.at = [1e9, -1e9, 1e9]"), "taken");
    EXPECT_NE(with("camera.at = [1e300, 0, 1]"), "taken");
    EXPECT_NE(with("camera.look_at = [0, nan, 1]"), "taken");
    EXPECT_NE(with("bed.window = [-1e300, 0, 1, 1]"), "taken");
    EXPECT_NE(with("bed.heights = [-1e300, 0]"), "taken");
}

TEST(NumberRange, HeightsInMetresCountWhateverTheirUnitIs) {
    const std::string why =
        refusal(scene_of("sand",
                         "[grid]\nnx = 8\nny = 6\ncell_size = 1\nheight_unit = 100\n[bed]\nkind = "
                         "\"flat\"\nheight = 10001\n"));
    EXPECT_NE(why.find("the bed: the height of cell (0, 0) is 1000100 m; heights go to ±1e+06 m"),
              std::string::npos)
        << why;
}

TEST(NumberRange, OfCouplings) {
    const ScratchFolder folder;
    write_text(folder / "bed.toml", scene_of("static", small));
    CoupledModel model((folder / "bed.toml").string());
    const Variable& bed = model.variables().front();
    std::vector<double> heights(48, largest_height);
    model.set(bed, heights);
    for (const double height :
         {std::nextafter(largest_height, infinite), 1e300, -1.797e308, infinite, std::nan("")}) {
        heights[7] = height;
        EXPECT_THROW(model.set(bed, heights), InputError) << height;
        EXPECT_EQ(model.values(bed)[7], largest_height) << "the model is as it was";
    }
}

class NumberRangeOfFiles : public ::testing::Test {
  protected:
    [[nodiscard]] Ended said(const std::vector<std::string>& arguments) const {
        return fumon(arguments, folder_.path());
    }
    /// That a command is refused in one line that has these words.
    void refused(const std::vector<std::string>& arguments, const std::string& words) const {
        const Ended ended = said(arguments);
        EXPECT_EQ(ended.status, 2) << ended.errors;
        EXPECT_NE(ended.errors.find(words), std::string::npos) << ended.errors;
        EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
    }
    ScratchFolder folder_;
};

TEST_F(NumberRangeOfFiles, ATerrainWithGdalsUndeclaredNoData) {
    std::string text = "ncols 6\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
    for (int cell = 0; cell < 24; ++cell) text += cell == 7 ? "-1.797e308 " : "1 ";
    write_text(folder_ / "bed.asc", text + "\n");
    write_text(folder_ / "scene.toml",
               "[model]\nname = \"static\"\n[bed]\nkind = \"file\"\nfile = \"bed.asc\"\n");
    for (const std::string ground : {"table", "endless"}) {
        refused({"still", "bed.asc", "-o", "a.png", "--set", "look.ground=" + ground},
                "heights beyond ±1e+06 m");
        EXPECT_FALSE(fs::exists(folder_ / "a.png"));
    }
    refused({"check", "scene.toml"}, "heights beyond ±1e+06 m");
    refused({"measure", "bed.asc"}, "heights beyond ±1e+06 m");
}

TEST_F(NumberRangeOfFiles, ATableOfTheWatersEdge) {
    write_text(folder_ / "scene.toml",
               scene_of("water", small + "[[edge]]\nside = \"west\"\nkind = "
                                         "\"discharge\"\ntable = \"q.csv\"\n"));
    write_text(folder_ / "q.csv", "seconds,value\n0,1\n10,inf\n");
    refused({"check", "scene.toml"}, "q.csv:3: value is 'inf'");
    write_text(folder_ / "q.csv", "seconds,value\n0,1\n10,1e300\n");
    refused({"check", "scene.toml"}, "q.csv:3: value is '1e+300'");
    write_text(folder_ / "q.csv", "seconds,value\n0,1\n1e300,1\n");
    refused({"check", "scene.toml"}, "q.csv:3: seconds is '1e+300'");
}

TEST_F(NumberRangeOfFiles, AForgedCheckpoint) {
    const fs::path file = folder_ / "out" / "checkpoint.fumon";
    write_text(folder_ / "scene.toml",
               "[model]\nname = \"sand\"\n[run]\nsteps = 1000000\n[grid]\nnx = 12\nny = 8\n"
               "cell_size = 1\n[output]\nframes = false\nmovie = false\nmeasure_every = 1000000\n");
    Program running({"run", "scene.toml", "-o", "out", "-q", "--checkpoint-every", "0.000001"},
                    folder_.path());
    for (int wait = 0; wait < 6000 && !fs::exists(file); ++wait)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    running.send(SIGINT);
    ASSERT_EQ(running.wait().status, 130);

    const std::string whole = read_text(file);
    std::set<std::string> names;
    for (const auto& [name, at] : reals_of(whole)) {
        names.insert(name);
        for (const double value : {1e300, infinite, std::nan("")}) {
            write_text(file, forged_checkpoint(whole, at, value));
            const Stopwatch watch;
            refused({"run", "--resume", "out", "-q"}, "out/checkpoint.fumon: its " + name);
            EXPECT_LT(watch.seconds(), 5.0) << name;
        }
    }
    EXPECT_TRUE(names.contains("bed")) << "and others";
    EXPECT_GT(names.size(), 1U);
}

/// A bad case is that case's error; the others run, and the page is whole.
TEST_F(NumberRangeOfFiles, ACaseUnderTest) {
    std::string text = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3 4 5 ";
    write_text(folder_ / "bed.asc", text + "-1.797e308\n");
    write_text(folder_ / "bed.toml",
               "[model]\nname = \"static\"\n[bed]\nkind = \"file\"\nfile = \"bed.asc\"\n[image]"
               "\nwidth = 16\nheight = 16\n");
    write_text(folder_ / "flat.toml", scene_of("static", small));
    write_text(folder_ / "bad.toml",
               "scene = \"bed.toml\"\n[cases]\nheights = {settings = [\"look.ground=endless\"]}\n");
    write_text(folder_ / "good.toml", "scene = \"flat.toml\"\n[cases]\nflat = {}\n");
    const Ended ended =
        said({"verify", "bad.toml", "good.toml", "-o", "out", "--junit", "report.xml"});
    EXPECT_EQ(ended.status, 2) << ended.errors;
    EXPECT_NE(ended.output.find("WRONG    bad heights: "), std::string::npos) << ended.output;
    EXPECT_NE(ended.output.find("good flat: "), std::string::npos) << "the others run";
    EXPECT_NE(read_text(folder_ / "report.xml").find("</testsuites>"), std::string::npos);
    EXPECT_TRUE(fs::exists(folder_ / "out" / "index.html"));
    EXPECT_FALSE(fs::exists(folder_ / "out" / "index.html.part"));
}

TEST_F(NumberRangeOfFiles, AStoredBed) {
    write_text(
        folder_ / "scene.toml",
        scene_of("sand", small + "[output]\nframes = false\nmovie = false\nfields_every = 1\n"));
    ASSERT_EQ(said({"run", "scene.toml", "-o", "out", "-q"}).status, 0);
    int file = 0;
    must(nc_open((folder_ / "out" / "fields.nc").c_str(), NC_WRITE, &file));
    int bed = 0;
    must(nc_inq_varid(file, "bed_height", &bed));
    const double height = 1e300;
    const std::array<std::size_t, 3> at{4, 2, 5};
    must(nc_put_var1_double(file, bed, at.data(), &height));
    must(nc_close(file));
    for (const char* command : {"still", "measure"}) {
        std::vector<std::string> arguments{command, "out/fields.nc"};
        if (arguments.front() == "still") arguments.insert(arguments.end(), {"-o", "b.png"});
        refused(arguments, "heights beyond ±1e+06 m");
    }
    refused({"render", "out", "-o", "frames", "-q"},
            "out/fields.nc: the height of cell (5, 2) is 1e+300");
    refused({"export", "out/fields.nc", "-o", "b.glb"}, "heights beyond ±1e+06 m");
}

TEST_F(NumberRangeOfFiles, ASceneInAPictureOfAnother) {
    const PictureText texts{
        {"fumon:scene",
         scene_of("sand", small + "[bed]\nlow = -1e300\n[look]\nground = \"endless\"\n")},
        {"fumon:step", "0"},
        {"fumon:inputs", "[]"}};
    write_file(folder_ / "a.png", encode_png(Image(16, 16), 96, texts));
    refused({"again", "a.png", "-o", "b.png"}, "bed.low is -1e+300");
    EXPECT_FALSE(fs::exists(folder_ / "b.png"));
}

}  // namespace
}  // namespace fumon::test::number_range
