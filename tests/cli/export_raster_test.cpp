// Rasters that `fumon export --field` writes: where they lie, what they say of themselves, what is
// refused.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "files/netcdf/netcdf_record.h"
#include "files/terrain/terrain_file.h"
#include "files/terrain/terrain_format.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

class ExportRaster : public ::testing::Test {
  protected:
    /// 24 by 16 cells of 2 m from (4000, 7000), a plane that falls by a quarter toward the north,
    /// with a cell without data.
    void SetUp() override {
        std::string text =
            "ncols 24\nnrows 16\nxllcorner 4000\nyllcorner 7000\ncellsize 2\nNODATA_value -9999\n";
        for (int row = 0; row < 16; ++row) {
            for (int x = 0; x < 24; ++x)
                text += row == 4 && x == 6 ? "-9999 " : std::to_string(0.5 * row) + " ";
        }
        write_text(folder_ / "dem.asc", text);
    }

    Ended write(const std::string& input, const std::string& output, const std::string& field,
                const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"export", input, "-o", output, "--field", field};
        words.insert(words.end(), more.begin(), more.end());
        return fumon(words, folder_.path());
    }

    ScratchFolder folder_;
};

TEST_F(ExportRaster, AGridLiesWhereItsTerrainLies) {
    std::vector<std::string> names{"slope.asc"};
    if (find_written_format("geotiff")->missing().empty()) names.emplace_back("slope.tif");
    for (const std::string& name : names) {
        const Ended ended = write("dem.asc", name, "slope");
        ASSERT_EQ(ended.status, 0) << ended.errors;
        const Terrain slope = read_terrain(folder_ / name, {.any_unit = true});
        EXPECT_EQ(slope.place->west, 4000.0) << name;
        EXPECT_EQ(slope.place->south, 7000.0) << name;
        EXPECT_EQ(slope.place->dx, 2.0) << name;
        EXPECT_NEAR(slope.heights(3, 3), 14.036243, 1e-6) << name;
        EXPECT_EQ(slope.nodata(6, 11), 1) << name;
        EXPECT_EQ(slope.nodata(6, 12), 0) << name;
    }
    const std::string beside = read_text(folder_ / "slope.asc.aux.xml");
    EXPECT_NE(beside.find("<Description>slope: angle of the ground from the horizontal (Horn 1981)"
                          "</Description>"),
              std::string::npos)
        << beside;
    EXPECT_NE(beside.find("<UnitType>degree</UnitType>"), std::string::npos) << beside;
    ASSERT_EQ(fumon({"export", "dem.asc", "-o", "bed.asc"}, folder_.path()).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "bed.asc.aux.xml")) << "heights are as ever";
}

TEST_F(ExportRaster, ANetcdfFileHasTheBedAndTheField) {
    ASSERT_EQ(write("dem.asc", "aspect.nc", "aspect").status, 0);
    const Terrain aspect =
        read_terrain(folder_ / "aspect.nc", {.variable = "aspect", .any_unit = true});
    EXPECT_EQ(aspect.heights(3, 3), 0.0) << "it falls northward";
    EXPECT_EQ(aspect.nodata(6, 11), 1);
    EXPECT_EQ(aspect.place->west, 4000.0);
    EXPECT_EQ(read_terrain(folder_ / "aspect.nc").heights(3, 15), 0.0);
    EXPECT_FALSE(read_fields_record(folder_ / "aspect.nc")->periodic);
}

TEST_F(ExportRaster, TheSunIsTheOneThatIsSet) {
    const auto shade = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"--force"};
        words.insert(words.end(), more.begin(), more.end());
        const Ended ended = write("dem.asc", "shade.asc", "hillshade", words);
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return read_terrain(folder_ / "shade.asc", {.any_unit = true}).heights(3, 3);
    };
    EXPECT_NEAR(shade({}), 1 + 254 * (0.70710678 + 0.5 * 0.25) / 1.0307764, 1e-3);
    EXPECT_NEAR(shade({"--set", "sun.azimuth=0", "--set", "sun.elevation=30"}),
                1 + 254 * (0.5 + 0.8660254 * 0.25) / 1.0307764, 1e-3);
    EXPECT_NEAR(shade({"--exaggeration", "4"}), 1 + 254 * (0.70710678 + 0.5) / 1.41421356, 1e-3);
}

TEST_F(ExportRaster, ARunHasItsWaterAndWhatItMoved) {
    const Ended run = fumon({"run", "dem.asc", "-o", "rain", "-q", "--set", "model.rain=30",
                             "--set", "run.steps=2", "--set", "output.fields_every=1", "--set",
                             "output.frames=false", "--set", "output.movie=false"},
                            folder_.path());
    ASSERT_EQ(run.status, 0) << run.errors;
    for (const std::string field :
         {"water-depth", "water-surface", "speed", "discharge", "change", "water_depth"})
        EXPECT_EQ(write("rain", field + ".asc", field).status, 0) << field;
    const auto value = [&](const char* file) {
        return read_terrain(folder_ / file, {.any_unit = true}).heights(3, 3);
    };
    EXPECT_GT(value("water-depth.asc"), 0.0);
    EXPECT_EQ(value("water-depth.asc"), value("water_depth.asc"));
    EXPECT_NEAR(value("discharge.asc"), value("speed.asc") * value("water-depth.asc"), 1e-15);
    EXPECT_EQ(value("change.asc"), 0.0) << "this water moves nothing";
    ASSERT_EQ(write("rain", "first.asc", "water-depth", {"--step", "1"}).status, 0);
    EXPECT_GT(value("first.asc"), 0.0);
    EXPECT_LT(value("first.asc"), value("water-depth.asc")) << "it rains on";
    EXPECT_EQ(fumon({"export", "rain", "-o", "one.nc", "--step", "1"}, folder_.path()).status, 0);
    EXPECT_NEAR(read_terrain(folder_ / "one.nc", {.variable = "water_depth", .any_unit = true})
                    .heights(3, 3),
                value("first.asc"), 1e-15);
    const Ended none = write("rain", "none.asc", "water-depth", {"--step", "7"});
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.errors, "rain/fields.nc: has no record of step 7; its nearest is of step 2\n");
    EXPECT_EQ(write("rain", "all.nc", "speed").status, 0);
    EXPECT_EQ(fumon({"export", "rain", "-o", "last.nc"}, folder_.path()).status, 0);
    EXPECT_NEAR(read_terrain(folder_ / "last.nc", {.variable = "water_depth", .any_unit = true})
                    .heights(3, 3),
                value("water-depth.asc"), 1e-15);
}

TEST_F(ExportRaster, WhatIsNotThereIsRefused) {
    const auto errors = [&](const std::string& file, const std::string& field) {
        const Ended ended = write("dem.asc", file, field);
        EXPECT_EQ(ended.status, 2) << file;
        EXPECT_FALSE(fs::exists(folder_ / file)) << file;
        return ended.errors;
    };
    const std::string list = "there are height, slope, aspect, hillshade, drainage, wetness\n";
    EXPECT_EQ(errors("x.asc", "slop"), "dem.asc: --field: \"slop\" is not a field; " + list);
    EXPECT_EQ(errors("x.nc", "speed"), "dem.asc: --field: \"speed\" is not in it; " + list);
    EXPECT_EQ(errors("x.stl", "slope"),
              "--field slope: a field is written as a grid: .tif, .cog.tif, .asc or .nc, not as "
              "stl\n");
    EXPECT_EQ(write("dem.asc", "x.asc", "slope", {"--step", "0"}).errors,
              "--step 0: dem.asc has a single record; --step takes a run's folder, its "
              "fields.nc, or the NetCDF of another model\n");
    EXPECT_EQ(fumon({"export", "dem.asc", "-o", "x.pvd", "--step", "0"}, folder_.path()).errors,
              "--step: a .pvd holds all records; name a .vts for one of them\n");
}

TEST_F(ExportRaster, TheHelpListsThem) {
    const Ended help = fumon({"export", "--help"}, folder_.path());
    for (const char* name : {"water-depth", "change", "slope", "aspect", "hillshade", "drainage"})
        EXPECT_NE(help.output.find(std::string("\n  ") + name + " "), std::string::npos) << name;
}

}  // namespace
}  // namespace fumon::test
