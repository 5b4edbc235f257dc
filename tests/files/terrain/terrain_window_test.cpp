#include "files/terrain/terrain_window.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "files/terrain/terrain_format.h"
#include "support/grid_values.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::TemporaryFolder;
using test::values_of;

/// Three by two cells of 10 m from (500, 200), heights 1 … 6 as they stand in the file.
std::filesystem::path grid_file(const TemporaryFolder& folder) {
    return folder.file("bed.asc",
                       "ncols 3\nnrows 2\nxllcorner 500\nyllcorner 200\ncellsize 10\n"
                       "NODATA_value -1\n1 2 3\n-1 5 6\n");
}

Terrain read(const TerrainWindow& window) {
    const TemporaryFolder folder;
    return read_terrain(grid_file(folder), {.window = window});
}

TEST(TerrainWindow, TakesTheCellsWhoseCentresItHolds) {
    const Terrain part = read({510, 200, 530, 210});
    EXPECT_EQ(values_of(part.heights), (std::vector<double>{5, 6}));
    ASSERT_TRUE(part.place);
    EXPECT_EQ(part.place->west, 510.0);
    EXPECT_EQ(part.place->south, 200.0);
    EXPECT_TRUE(part.nodata.empty()) << "the hole lies elsewhere";
    EXPECT_EQ(values_of(read({504, 211, 516, 219}).heights), (std::vector<double>{1, 2}));
    EXPECT_EQ(values_of(read({506, 211, 516, 219}).heights), (std::vector<double>{2}));
    EXPECT_EQ(read({496, 196, 534, 224}).heights.size(), 6U) << "less than half a cell beyond";
    EXPECT_EQ(read({500, 200, 520, 210}).nodata(0, 0), 1);
}

TEST(TerrainWindow, OutsideOrEmptyItIsRefused) {
    const auto refusal = [](const TerrainWindow& window) {
        const std::string message = message_of<InputError>([&] { (void)read(window); });
        return message.substr(message.find(": ") + 2);
    };
    constexpr const char* of_file =
        "; west, south, east and north of the file are [500, 200, 530, 220]";
    EXPECT_EQ(refusal({490, 200, 520, 210}),
              std::string("bed.window [490, 200, 520, 210] reaches beyond the file") + of_file);
    EXPECT_EQ(refusal({500, 200, 520, 226}),
              std::string("bed.window [500, 200, 520, 226] reaches beyond the file") + of_file);
    EXPECT_EQ(refusal({501, 201, 504, 204}),
              std::string("bed.window [501, 201, 504, 204] is smaller than a cell") + of_file);
    EXPECT_EQ(refusal({500, 200, 510, 210}), "no cell in bed.window holds data; take another part");
}

TEST(TerrainWindow, DegreesAreConvertedAtItsOwnMiddle) {
    const TemporaryFolder folder;
    const auto file = folder.file("bed.asc",
                                  "ncols 1\nnrows 4\nxllcorner 10\nyllcorner 58\ncellsize 1\n"
                                  "4000\n30\n20\n10\n");
    const Terrain part = read_terrain(file, {.window = TerrainWindow{10, 58, 11, 60}});
    EXPECT_EQ(values_of(part.heights), (std::vector<double>{10, 20}));
    EXPECT_NE(part.note.find("59.0000°"), std::string::npos)
        << "in degrees as the whole file is, though its part is flat: " << part.note;
}

TEST(TerrainFormats, EveryQueryKeyBelongsToAFormat) {
    const TemporaryFolder folder;
    const auto file = grid_file(folder);
    EXPECT_EQ(message_of<InputError>([&] { (void)read_terrain(file, {.band = 2}); }),
              file.string() +
                  ": a band was named for an ESRI ASCII grid, which has none; leave bed.band out");
}

TEST(TerrainFormats, WrittenOnesHaveNamesAndEndingsOfTheirOwn) {
    EXPECT_EQ(written_terrain_formats(), "geotiff, cloud-optimized-geotiff, esri-ascii");
    EXPECT_EQ(terrain_titles(),
              "a NetCDF file, a GeoTIFF, a PNG image, another raster that GDAL reads or an ESRI "
              "ASCII grid");
    EXPECT_EQ(find_written_format("netcdf"), nullptr) << "beds are not written so";
    EXPECT_EQ(find_written_format("esri-ascii")->endings.front(), ".asc");
}

}  // namespace
}  // namespace fumon
