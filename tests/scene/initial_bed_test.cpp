#include "scene/initial_bed.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/read.h"
#include "scene/text/scene_text.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

namespace fs = std::filesystem;

class InitialBedTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("fumon-initial-bed-" + std::to_string(getpid()));
        fs::create_directories(folder_);
        std::ofstream(folder_ / "bed.asc")
            << "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 4\n"
               "NODATA_value -9\n1 2 3\n4 -9 6\n";
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] Scene scene(const std::string& model, const std::string& more) const {
        return parse_scene("[model]\nname = \"" + model + "\"\n[run]\nsteps = 1\n" + more,
                           "scene.toml", folder_);
    }
    [[nodiscard]] std::string refusal(const std::string& more) const {
        try {
            make_initial_bed(scene("static", more));
        } catch (const InputError& fault) {
            return fault.what();
        }
        return "(accepted)";
    }

    fs::path folder_;
};

TEST_F(InitialBedTest, AHeapStandsInTheMiddle) {
    const InitialBed initial = make_initial_bed(
        scene("dunes",
              "[grid]\nnx = 41\nny = 31\ncell_size = [2.0]\n[bed]\nkind = \"heap\"\n"
              "height = 6\nheap_radius = 24\n"));
    EXPECT_DOUBLE_EQ(initial.bed(20, 15), 6.0);
    EXPECT_NEAR(initial.bed(26, 15), 3.0, 1e-12) << "half way";
    EXPECT_NEAR(initial.bed(20, 9), 3.0, 1e-12);
    EXPECT_EQ(initial.bed(32, 15), 0.0);
    EXPECT_NE(test::message_of<InputError>([&] {
                  static_cast<void>(scene("dunes", "[bed]\nkind = \"heap\"\n"));
              }).find("bed.heap_radius is missing"),
              std::string::npos);
}

TEST_F(InitialBedTest, ARefinedTerrainKeepsItsPlaneItsMaskAndItsExtent) {
    std::ofstream plane(folder_ / "plane.asc");
    plane << "ncols 7\nnrows 7\nxllcorner 0\nyllcorner 0\ncellsize 6\nNODATA_value -9\n";
    for (int y = 6; y >= 0; --y) {
        for (int x = 0; x < 7; ++x) plane << (x == 6 && y == 0 ? -9 : 2 * x + 10 * y) << ' ';
        plane << '\n';
    }
    plane.close();
    const InitialBed initial =
        make_initial_bed(scene("static",
                               "[bed]\nfile = \"plane.asc\"\nrefine = 3\nrefine_method = "
                               "\"bicubic\"\n"));
    ASSERT_EQ(initial.bed.nx(), 21);
    ASSERT_EQ(initial.bed.ny(), 21);
    EXPECT_DOUBLE_EQ(initial.scale.dx, 2.0);
    EXPECT_DOUBLE_EQ(initial.scale.dy, 2.0);
    for (int y = 6; y < 15; ++y) {  // away from the border the bicubic is exact for a plane
        for (int x = 6; x < 12; ++x)
            EXPECT_NEAR(initial.bed(x, y), (x - 1) * 2.0 / 3.0 + (y - 1) * 10.0 / 3.0, 1e-12);
    }
    EXPECT_EQ(initial.nodata(17, 2), 0);
    EXPECT_EQ(initial.nodata(18, 2), 1);
    EXPECT_EQ(initial.nodata(18, 3), 0);
    const InitialBed spline =
        make_initial_bed(scene("static", "[bed]\nfile = \"plane.asc\"\nrefine = 3\n"));
    EXPECT_TRUE(std::ranges::equal(spline.nodata.values(), initial.nodata.values()));
    for (int x = 0; x < 9; ++x)  // far from the cell without data, to the very edge
        EXPECT_NEAR(spline.bed(x, 20), (x - 1) * 2.0 / 3.0 + 19 * 10.0 / 3.0, 1e-3);
    EXPECT_NEAR(spline.bed(16, 1), initial.bed(16, 1), 3.0) << "nothing foreign comes in";
    EXPECT_NE(refusal("[bed]\nrefine = 3\n[grid]\nnx = 4\n").find("belongs to a terrain file"),
              std::string::npos);
}

TEST_F(InitialBedTest, OlderScenesAreRefinedAsTheyWere) {
    const auto heights = [&](const char* version, const char* method) {
        SceneText text{
            "[model]\nname = \"static\"\n[bed]\nfile = \"bed.asc\"\nnodata = "
            "\"fill\"\nrefine = 2\n" +
                std::string(method),
            "scene.toml", folder_};
        text.version = version;
        const InitialBed initial = make_initial_bed(parse_scene(text, {}));
        return std::vector<double>(initial.bed.values().begin(), initial.bed.values().end());
    };
    const auto now = heights("0.3.0", "");
    EXPECT_NE(heights("0.2.0", ""), now);
    EXPECT_EQ(heights("0.2.0", ""), heights("0.3.0", "refine_method = \"bicubic\"\n"));
    EXPECT_EQ(heights("0.2.0", "refine_method = \"spline\"\n"), now);
}

TEST_F(InitialBedTest, NoiseIsUniformInItsInterval) {
    const InitialBed initial =
        make_initial_bed(scene("sand", "[bed]\nlow = 2\nhigh = 5\n[grid]\nnx = 200\nny = 150\n"));
    double sum = 0.0;
    double squares = 0.0;
    for (const double height : initial.bed.values()) {
        ASSERT_GE(height, 2.0);
        ASSERT_LT(height, 5.0);
        sum += height;
        squares += (height - 3.5) * (height - 3.5);
    }
    const auto cells = static_cast<double>(initial.bed.size());
    EXPECT_NEAR(sum / cells, 3.5, 5 * 0.866 / std::sqrt(cells));
    EXPECT_NEAR(squares / cells, 0.75, 0.02) << "the variance of a uniform height, 3²/12";
}

TEST_F(InitialBedTest, NoiseFollowsTheSeed) {
    const auto bed = [&](const char* seed) {
        return make_initial_bed(parse_scene(std::string("seed = ") + seed +
                                                "\n[model]\nname=\"sand\"\n[run]\nsteps=1\n",
                                            "s", ""))
            .bed;
    };
    EXPECT_EQ(bed("1"), bed("1"));
    EXPECT_NE(bed("1"), bed("2"));
}

TEST_F(InitialBedTest, AFlatBed) {
    const InitialBed initial =
        make_initial_bed(scene("sand", "[bed]\nkind = \"flat\"\nheight = 1.5\n"));
    EXPECT_EQ(initial.bed, Grid(100, 100, 1.5));
    EXPECT_FALSE(initial.scale.in_metres);
}

TEST_F(InitialBedTest, ATerrainFileComesInMetresAndNorthUp) {
    const InitialBed initial =
        make_initial_bed(scene("static", "[bed]\nkind = \"file\"\nfile = \"bed.asc\"\n"));
    EXPECT_EQ(initial.bed(0, 1), 1.0) << "the file's first row is the northernmost";
    EXPECT_EQ(initial.bed(2, 0), 6.0);
    EXPECT_EQ(initial.nodata(1, 0), 1);
    EXPECT_EQ(initial.scale, (WorldScale{4.0, 4.0, 1.0, true}));
    ASSERT_EQ(initial.inputs.size(), 1U);
    EXPECT_EQ(initial.inputs[0].hash.size(), 64U);
}

TEST_F(InitialBedTest, ForTheSandModelsMetresAreDividedByTheHeightUnit) {
    const std::string file = "[bed]\nkind = \"file\"\nfile = \"bed.asc\"\nnodata = 8\n";
    EXPECT_EQ(make_initial_bed(scene("sand", file)).bed(0, 1), 0.25)
        << "the height unit is the cell size";
    EXPECT_EQ(make_initial_bed(scene("sand", file + "[grid]\nheight_unit = 0.5\n")).bed(0, 1), 2.0);
    EXPECT_EQ(make_initial_bed(scene("sand", file)).bed(1, 0), 2.0) << "no data set to 8 m";
    EXPECT_TRUE(make_initial_bed(scene("sand", file)).nodata.empty());
}

TEST_F(InitialBedTest, AFileFromTheCommandLineTakesThePlaceOfTheScenesBed) {
    const std::string file = (folder_ / "bed.asc").string();
    const Scene scene = parse_scene(
        "[model]\nname = \"static\"\n[grid]\nnx = 50\nny = 60\ncell_size = 9\n[bed]\nlow = 1\n",
        "scene.toml", "elsewhere", {"bed.kind=file", "bed.file=" + file});
    const InitialBed initial = make_initial_bed(scene);
    EXPECT_EQ(initial.bed.nx(), 3);
    EXPECT_EQ(initial.scale.dx, 4.0);
}

TEST_F(InitialBedTest, HolesCanBeFilled) {
    const InitialBed initial = make_initial_bed(
        scene("static", "[bed]\nkind = \"file\"\nfile = \"bed.asc\"\nnodata = \"fill\"\n"));
    EXPECT_TRUE(initial.nodata.empty());
    EXPECT_GE(initial.bed(1, 0), 1.0);
    EXPECT_LE(initial.bed(1, 0), 6.0);
}

TEST_F(InitialBedTest, HeightsThatNoGroundHasAreToldAndCanBeTakenOut) {
    const auto told = [&](const std::string& cells, const std::string& more = "") {
        std::ofstream(folder_ / "odd.asc")
            << "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 4\nNODATA_value -1\n"
            << cells;
        return make_initial_bed(scene("static", "[bed]\nfile = \"odd.asc\"\n" + more));
    };
    EXPECT_EQ(told("1 2 3\n4 -50 6\n").note, "");
    EXPECT_EQ(told("8000 2 3\n4 -9999 6\n").note,
              "1 of 6 cells have implausible heights, the first -9999 m at cell (1, 0): if they "
              "mean missing data, write bed.nodata_value = -9999");
    for (const char* value : {"9999", "-32768", "32767", "-99999"}) {
        const std::string cells = std::string("1 2 ") + value + "\n4 " + value + " 6\n";
        const std::string note = told(cells).note;
        EXPECT_NE(note.find("2 of 6 cells"), std::string::npos) << note;
        EXPECT_NE(note.find(std::string("write bed.nodata_value = ") + value), std::string::npos)
            << note;
        const InitialBed taken = told(cells, std::string("nodata_value = ") + value + "\n");
        EXPECT_EQ(taken.note, "");
        ASSERT_FALSE(taken.nodata.empty());
        EXPECT_EQ(taken.nodata(1, 0), 1);
        EXPECT_EQ(taken.nodata(2, 1), 1);
        EXPECT_EQ(taken.nodata(0, 0), 0);
    }
    EXPECT_EQ(test::message_of<InputError>([&] { (void)told("1 2 1e30\n4 5 6\n"); }),
              (folder_ / "odd.asc").string() +
                  ": 1 of 6 cells have heights beyond ±1e+06 m, the first 1e+30 m at cell (2, 1); "
                  "if they mean missing data, write bed.nodata_value = 1e+30; if they are in "
                  "another unit, write bed.height_unit");
    EXPECT_EQ(told("1 2 1e30\n4 5 6\n", "nodata_value = 1e30\n").nodata(2, 1), 1);
    const InitialBed feet =
        told("10 -9999 30\n40 50 60\n", "height_unit = \"ft\"\nnodata_value = -9999\n");
    EXPECT_EQ(feet.nodata(1, 1), 1) << "as the file has it";
    EXPECT_DOUBLE_EQ(feet.bed(0, 1), 3.048);
    EXPECT_EQ(refusal("[bed]\nfile = \"bed.asc\"\nnodata_value = 77\n"),
              "scene.toml:7:16: bed.nodata_value is 77 m, but no cell of bed.asc has that height; "
              "leave the key out");
}

TEST_F(InitialBedTest, TerracesAreToldAndTakenOutByChoice) {
    // A slope of 48 x 40 cells, rounded to metres, and as it was.
    const auto write = [&](const char* name, bool rounded) {
        std::ofstream file(folder_ / name);
        file << "ncols 48\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 4\n";
        for (int y = 39; y >= 0; --y) {
            for (int x = 0; x < 48; ++x) {
                const double height = 0.2 * x + 0.03 * y;
                file << (rounded ? std::round(height) : height) << (x < 47 ? ' ' : '\n');
            }
        }
    };
    write("whole.asc", true);
    write("real.asc", false);
    const auto bed = [&](const std::string& file, const std::string& more) {
        return make_initial_bed(
            scene("static", "[bed]\nkind = \"file\"\nfile = \"" + file + "\"\n" + more));
    };
    const InitialBed whole = bed("whole.asc", "");
    EXPECT_EQ(whole.note,
              "heights are multiples of 1 m, which makes terraces (bed.smooth_terraces = true "
              "takes them out)");
    EXPECT_EQ(whole.bed(24, 20), std::round(0.2 * 24 + 0.03 * 20));
    const InitialBed smooth = bed("whole.asc", "smooth_terraces = true\n");
    EXPECT_EQ(smooth.note, "terraces of 1 m are taken out of the heights");
    double farthest = 0.0;
    for (std::size_t cell = 0; cell < smooth.bed.size(); ++cell)
        farthest =
            std::max(farthest, std::abs(smooth.bed.values()[cell] - whole.bed.values()[cell]));
    EXPECT_LE(farthest, 0.5);
    EXPECT_NEAR(smooth.bed(24, 20), 0.2 * 24 + 0.03 * 20, 0.1);
    const InitialBed real = bed("real.asc", "");
    EXPECT_EQ(real.note, "");
    const InitialBed kept = bed("real.asc", "smooth_terraces = true\n");
    EXPECT_EQ(kept.bed, real.bed);
    EXPECT_EQ(kept.note,
              "heights are not multiples of a step: bed.smooth_terraces leaves them unchanged");
}

TEST_F(InitialBedTest, WhatDoesNotFitTheFileIsRefused) {
    const std::string file = "[bed]\nkind = \"file\"\nfile = \"bed.asc\"\n";
    EXPECT_EQ(refusal(file + "[grid]\nnx = 4\n"),
              "scene.toml:9:6: grid.nx is 4, but bed.asc has 3 cells there; leave the key out for "
              "a terrain file");
    EXPECT_EQ(refusal(file + "[grid]\ncell_size = 5\n"),
              "scene.toml:9:13: grid.cell_size is [5, 5] m, but bed.asc has cells of [4, 4] m; "
              "leave the key out");
    EXPECT_EQ(refusal("[bed]\nkind = \"file\"\nfile = \"none.asc\"\n"),
              "scene.toml:7:8: bed.file \"none.asc\" does not exist (looked for " +
                  (folder_ / "none.asc").string() + "); paths are relative to the scene file");
}

}  // namespace
}  // namespace fumon
