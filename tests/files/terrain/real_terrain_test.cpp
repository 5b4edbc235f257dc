#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "files/terrain/terrain_file.h"

namespace fumon {
namespace {

/// Elevation data as people have it, which is not part of the project.
class RealTerrain : public ::testing::Test {
  protected:
    std::filesystem::path folder{FUMON_REAL_TERRAIN_FOLDER};
    void SetUp() override {
        if (!std::filesystem::exists(folder / "west_bijou_gully.asc"))
            GTEST_SKIP() << "no real terrain lies in " << folder;
    }
};

TEST_F(RealTerrain, ReadsAGullyWithHoles) {
    const Terrain terrain = read_terrain(folder / "west_bijou_gully.asc", {});
    EXPECT_EQ(terrain.heights.nx(), 43);
    EXPECT_EQ(terrain.heights.ny(), 89);
    EXPECT_EQ(terrain.dx, 3.0);
    EXPECT_EQ(terrain.dy, 3.0);
    EXPECT_EQ(terrain.note, "");
    const auto mask = terrain.nodata.values();
    EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 2739);

    const Grid filled = fill_nodata(terrain.heights, terrain.nodata);
    double lowest = 1e9;
    double highest = -1e9;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] != 0) continue;
        lowest = std::min(lowest, terrain.heights.values()[i]);
        highest = std::max(highest, terrain.heights.values()[i]);
    }
    for (const double height : filled.values()) {
        EXPECT_GE(height, lowest - 1e-9);
        EXPECT_LE(height, highest + 1e-9);
    }
}

TEST_F(RealTerrain, ReadsMountainsInDegrees) {
    const Terrain terrain = read_terrain(folder / "srtm_boulder_front_range.asc", {});
    EXPECT_EQ(terrain.heights.nx(), 240);
    EXPECT_EQ(terrain.heights.ny(), 144);
    EXPECT_TRUE(terrain.nodata.empty());
    EXPECT_EQ(terrain.heights(0, 143), 2569.0);  // the file's first height is the north-west one
    EXPECT_NEAR(terrain.dx, 71.0, 0.2);
    EXPECT_NEAR(terrain.dy, 92.5, 0.1);
    EXPECT_NE(terrain.note.find("degrees"), std::string::npos) << terrain.note;
}

}  // namespace
}  // namespace fumon
