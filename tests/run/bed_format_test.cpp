// Beds that a run writes, in each format and where their terrain lay.

#include <gtest/gtest.h>

#include "files/terrain/terrain_file.h"
#include "files/terrain/terrain_format.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// 24 by 16 cells of 2 m from (4000, 7000), a slope that sinks toward the north-west.
void write_terrain(const ScratchFolder& folder) {
    std::string text = "ncols 24\nnrows 16\nxllcorner 4000\nyllcorner 7000\ncellsize 2\n";
    for (int row = 0; row < 16; ++row) {
        for (int x = 0; x < 24; ++x) text += std::to_string(0.01 * (x + row + 1)) + " ";
    }
    write_text(folder / "dem.asc", text);
}

std::string scene(const std::string& bed, const std::string& output) {
    return "[model]\nname = \"sand\"\n[run]\nsteps = 2\n[bed]\nfile = \"dem.asc\"\n" + bed +
           "[image]\nwidth = 64\nheight = 48\n[output]\nmovie = false\nframes = false\n"
           "bed_at = [0, 2]\n" +
           output;
}

class BedFormat : public ::testing::Test {
  protected:
    void SetUp() override { write_terrain(folder_); }

    Ended run(const std::string& bed, const std::string& output) {
        write_text(folder_ / "scene.toml", scene(bed, output));
        return fumon({"run", "scene.toml", "-o", "out", "--force", "--quiet"}, folder_.path());
    }

    ScratchFolder folder_;
};

TEST_F(BedFormat, AnEsriGridLiesWhereItsTerrainLay) {
    const Ended ended = run("window = [4002.0, 7000.0, 4042.0, 7030.0]\nrefine = 2\n", "");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const Terrain bed = read_terrain(folder_ / "out/beds/bed_00000000.asc");
    EXPECT_EQ(bed.heights.nx(), 40);
    EXPECT_EQ(bed.heights.ny(), 30);
    EXPECT_EQ(bed.dx, 1.0);
    ASSERT_TRUE(bed.place);
    EXPECT_EQ(bed.place->west, 4002.0);
    EXPECT_EQ(bed.place->south, 7000.0);
    EXPECT_FALSE(fs::exists(folder_ / "out/beds/bed_00000000.tif"));
    EXPECT_FALSE(fs::exists(folder_ / "out/beds/bed_00000000.prj")) << "no system is known";
}

TEST_F(BedFormat, FramesOfMapsAreGeoTiffsToo) {
    const auto still = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"still",
                                       "dem.asc",
                                       "-o",
                                       "map.png",
                                       "-q",
                                       "--set",
                                       "image.width=64",
                                       "--set",
                                       "image.height=48",
                                       "--set",
                                       "output.geotiff_frames=true"};
        words.insert(words.end(), more.begin(), more.end());
        return fumon(words, folder_.path());
    };
    EXPECT_EQ(still({}).errors,
              "--set 3:23: output.geotiff_frames belongs to camera.projection = \"map\"\n");
    EXPECT_FALSE(fs::exists(folder_ / "map.png"));
    const Ended ended = still({"--set", "camera.projection=map"});
    if (!find_written_format("geotiff")->missing().empty()) {
        EXPECT_EQ(ended.status, 2);
        EXPECT_NE(ended.errors.find("needs GDAL"), std::string::npos) << ended.errors;
        return;
    }
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(read_text(folder_ / "map.tif").substr(0, 2), "II");
    EXPECT_FALSE(fs::exists(folder_ / "map.pgw"));
    EXPECT_EQ(still({"--set", "camera.projection=map"}).status, 0) << "its own is replaced";
}

TEST_F(BedFormat, ABedIsExportedAsAGridOfItsFormatOrToStandardOutput) {
    const Ended written = fumon({"export", "dem.asc", "-o", "bed.asc"}, folder_.path());
    ASSERT_EQ(written.status, 0) << written.errors;
    const Terrain bed = read_terrain(folder_ / "bed.asc");
    EXPECT_EQ(bed.heights, read_terrain(folder_ / "dem.asc").heights);
    EXPECT_EQ(bed.place->west, 4000.0);
    const Ended told = fumon({"export", "dem.asc", "-o", "-"}, folder_.path());
    EXPECT_EQ(told.output, read_text(folder_ / "bed.asc"));
    EXPECT_EQ(told.errors, "");
    EXPECT_EQ(
        fumon({"export", "dem.asc", "-o", "bed.txt"}, folder_.path()).errors,
        "bed.txt: the output's name must end in .vts, .pvd, .glb, .stl, .ply, .obj, .html, .nc, "
        ".cog.tif, .tif, .asc; or give the format with --as\n");
    EXPECT_EQ(
        fumon({"export", "dem.asc", "-o", "bed.txt", "--as", "esri-ascii"}, folder_.path()).status,
        0);
    EXPECT_EQ(read_text(folder_ / "bed.txt"), told.output);
    EXPECT_EQ(fumon({"export", "dem.asc", "-o", "-", "--as", "pvd"}, folder_.path()).status, 2);
    const Ended series = fumon({"export", "dem.asc", "-o", "dem.pvd"}, folder_.path());
    EXPECT_EQ(series.status, 2);
    EXPECT_EQ(series.errors,
              "dem.asc: has a single record, and a .pvd is a time series; export .vts, or name a "
              "run's folder or fields.nc\n");
    const Ended solid = fumon({"export", "dem.asc", "-o", "-", "--as", "stl"}, folder_.path());
    EXPECT_EQ(fumon({"export", "dem.asc", "-o", "dem.stl"}, folder_.path()).status, 0);
    EXPECT_TRUE(solid.output == read_text(folder_ / "dem.stl"));
}

TEST_F(BedFormat, ResampledCellsAreTheModels) {
    const Ended ended = run("resample = 4.0\n", "");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const Terrain bed = read_terrain(folder_ / "out/beds/bed_00000000.asc");
    EXPECT_EQ(bed.heights.nx(), 12);
    EXPECT_EQ(bed.heights.ny(), 8);
    EXPECT_NEAR(bed.heights(0, 0), (0.15 + 0.16 + 0.16 + 0.17) / 4.0, 1e-12);
    EXPECT_EQ(read_manifest(folder_ / "out")["grid"]["dx"], 4.0);
    EXPECT_EQ(read_manifest(folder_ / "out")["grid"]["height_unit"], 4.0)
        << "of the sand, as long as its cells";
}

TEST_F(BedFormat, GeotiffAndEsriGridHoldTheSameBed) {
    if (!find_written_format("geotiff")->missing().empty()) GTEST_SKIP() << "GDAL is not installed";
    const Ended ended = run("", "bed_format = [\"geotiff\", \"esri-ascii\"]\n");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    for (const std::string name : {"bed_00000000", "bed_00000002"}) {
        const Terrain tiff = read_terrain(folder_ / ("out/beds/" + name + ".tif"));
        const Terrain grid = read_terrain(folder_ / ("out/beds/" + name + ".asc"));
        EXPECT_EQ(tiff.heights, grid.heights) << name;
        EXPECT_EQ(tiff.place, grid.place) << name;
    }
    const auto beds = read_manifest(folder_ / "out")["beds"];
    ASSERT_EQ(beds.size(), 4U);
    EXPECT_EQ(beds[0]["file"], "beds/bed_00000000.tif");
    EXPECT_EQ(beds[1]["file"], "beds/bed_00000000.asc");

    ASSERT_EQ(run("", "").status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/beds/bed_00000000.tif"))
        << "the former run's beds are taken away";
}

TEST_F(BedFormat, WrongKeysAreLocated) {
    const auto line = [&](const std::string& bed, const std::string& output) {
        const Ended ended = run(bed, output);
        EXPECT_EQ(ended.status, 2);
        EXPECT_FALSE(fs::exists(folder_ / "out"));
        return ended.errors;
    };
    EXPECT_EQ(line("window = [1.0, 2.0]\n", ""),
              "scene.toml:7:10: bed.window has 2 numbers; it takes [west, south, east, north]\n");
    EXPECT_EQ(line("window = [5.0, 2.0, 1.0, 4.0]\n", ""),
              "scene.toml:7:10: bed.window must have west < east and south < north; write [west, "
              "south, east, north]\n");
    EXPECT_EQ(line("resample = 50.0\n", ""),
              "scene.toml:7:12: bed.resample is 50 m, more than the terrain's 48 x 32 m; take "
              "smaller cells\n");
    EXPECT_EQ(line("", "bed_format = [\"xyz\"]\n"),
              "scene.toml:14:14: output.bed_format has \"xyz\"; it takes geotiff, "
              "cloud-optimized-geotiff, esri-ascii\n");
    EXPECT_EQ(line("", "bed_format = [\"esri-ascii\", \"esri-ascii\"]\n"),
              "scene.toml:14:14: output.bed_format has \"esri-ascii\" twice\n");
}

}  // namespace
}  // namespace fumon::test
