#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "files/terrain/terrain_file.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

TEST(RealTerrain, ReadsAGullyWithHoles) {
    const Terrain terrain =
        read_terrain(std::filesystem::path(FUMON_TERRAIN_FOLDER) / "west_bijou_gully.asc", {});
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

/// The header of three arc seconds of SRTM over Colorado, with heights of our own.
TEST(RealTerrain, ReadsMountainsInDegrees) {
    constexpr int columns = 240;
    constexpr int rows = 144;
    const auto height = [](int column, int row) { return 1700 + (37 * column + 53 * row) % 2300; };
    std::string text =
        "ncols        240\nnrows        144\nxllcorner    -105.550416666684\n"
        "yllcorner    40.090416666671\ncellsize     0.000833333333\nNODATA_value 0\n";
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            text += ' ' + std::to_string(height(column, row));
        text += '\n';
    }
    const test::TemporaryFolder folder;
    const Terrain terrain = read_terrain(folder.file("mountains.asc", text), {});
    EXPECT_EQ(terrain.heights.nx(), columns);
    EXPECT_EQ(terrain.heights.ny(), rows);
    EXPECT_TRUE(terrain.nodata.empty());
    EXPECT_EQ(terrain.heights(0, rows - 1), height(0, 0))
        << "the file's first height is north-west";
    EXPECT_EQ(terrain.heights(columns - 1, 0), height(columns - 1, rows - 1));
    EXPECT_NEAR(terrain.dx, 71.0, 0.2);
    EXPECT_NEAR(terrain.dy, 92.5, 0.1);
    EXPECT_NE(terrain.note.find("degrees"), std::string::npos) << terrain.note;
}

}  // namespace
}  // namespace fumon
