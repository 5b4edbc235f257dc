// Grids in text that are not Esri's, and GeoClaw's headers; keys that turn heights into metres in
// every format.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/esri_ascii.h"
#include "files/terrain/suspect_heights.h"
#include "files/terrain/terrain_file.h"
#include "files/terrain/text_grid.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

TEST(TextGrids, GeoclawsHeadersHaveTheirNumbersFirst) {
    struct Row {
        const char* name;
        const char* header;
        double west;
        double south;
    };
    const std::vector<Row> rows{
        {"ncols first",
         "3 ncols\n2 nrows\n100 xllcorner\n200 yllcorner\n10 cellsize\n-9 nodata_value\n", 100,
         200},
        {"mx", "3    mx\n2    my\n105.0  xlower\n205.0 ylower\n10.0 dx\n10.0 dy\n-9 nodata_value\n",
         100, 200},
        {"xll", "3 mx\n2 my\n105 xll\n205 yll\n1.0e1 cellsize\n-9 NODATA_value # none\n", 100, 200},
        {"mixed", "ncols 3\n2 nrows\nxllcorner 100\n200 yllcorner\ncellsize 10\n-9 nodata_value\n",
         100, 200},
    };
    const TemporaryFolder folder;
    for (const Row& row : rows) {
        const auto file = folder.file("topo.tt3", std::string(row.header) + "4 5 6\n1 2 -9\n");
        const Terrain terrain = read_terrain(file);
        EXPECT_EQ(terrain.heights.nx(), 3) << row.name;
        EXPECT_EQ(terrain.dx, 10.0) << row.name;
        EXPECT_EQ(terrain.place->west, row.west) << row.name;
        EXPECT_EQ(terrain.place->south, row.south) << row.name;
        EXPECT_EQ(terrain.heights(1, 0), 2.0) << row.name;
        EXPECT_EQ(terrain.nodata(2, 0), 1) << row.name;
        EXPECT_EQ(terrain.heights(2, 1), 6.0) << row.name;
    }
    const Terrain oblong =
        read_terrain(folder.file("oblong.tt3",
                                 "3 ncols\n2 nrows\n105 xlower\n210 ylower\n10 20 cellsize\n-9 "
                                 "nodata_value\n4 5 6\n1 2 -9\n"));
    EXPECT_EQ(oblong.dx, 10.0);
    EXPECT_EQ(oblong.dy, 20.0);
    EXPECT_EQ(oblong.place->south, 200.0);
    const auto twice = folder.file("twice.asc", "3 ncols\n3 mx\n");
    EXPECT_EQ(
        message_of<InputError>([&] { (void)read_terrain(twice); }),
        twice.string() + ":2: ncols occurs again (first on line 1); keep one of the two lines");
}

TEST(TextGrids, OthersAreNamedWithTheirRemedy) {
    const TemporaryFolder folder;
    const auto surfer = folder.file("grid.grd", "DSAA\n3 2\n0 2\n0 1\n1 6\n1 2 3\n4 5\n");
    EXPECT_EQ(message_of<InputError>([&] {
                  (void)parse_esri_ascii({"grid.grd", "DSAA\n3 2\n"});
              }),
              "grid.grd:1: this is a Surfer ASCII grid (DSAA); make an ESRI ASCII grid or a "
              "GeoTIFF of it (gdal_translate -of AAIGrid IN OUT.asc)");
    EXPECT_NE(message_of<InputError>([&] { (void)read_terrain(surfer); }), "") << "cut short";
    for (const char* text :
         {"x,y,z\n0,0,1\n1,0,2\n", "# points\nLon;Lat;Height\n7;46;800.5\n8;46;nan\n",
          "\"X\"\t\"Y\"\t\"Z\"\r\n0\t0\t1\r\n1\t0\t2\r\n"}) {
        const auto file = folder.file("points.xyz", text);
        const std::string message = message_of<InputError>([&] { (void)read_terrain(file); });
        EXPECT_NE(message.find(": is a list of points (XYZ) that do not form a regular grid; "),
                  std::string::npos)
            << message;
    }
    EXPECT_FALSE(other_text_grid("ncols 3\nnrows 2\ncellsize 1\n1 2 3\n"));
    EXPECT_FALSE(other_text_grid("3 ncols\n2 nrows\n"));
    EXPECT_FALSE(other_text_grid(""));
}

TEST(HeightKeys, HoldForFormatsWithoutUnits) {
    const TemporaryFolder folder;
    const auto file = folder.file("feet.asc", "ncols 2\nnrows 1\ncellsize 5\n100 -9999\n");
    const Terrain feet = read_terrain(file, {.height_unit = "US survey foot"});
    EXPECT_NEAR(feet.heights(0, 0), 100.0 * 1200.0 / 3937.0, 1e-12);
    EXPECT_EQ(feet.heights(1, 0), 0.0);
    EXPECT_EQ(feet.nodata(1, 0), 1) << "no data as the file has it";
    EXPECT_EQ(feet.note, "heights converted to metres from US survey foot (bed.height_unit)");
    const Terrain depths =
        read_terrain(file, {.height_factor = 0.5, .height_sign = HeightSign::down});
    EXPECT_EQ(depths.heights(0, 0), -50.0);
    EXPECT_EQ(depths.metres_per_number, -0.5);
    EXPECT_EQ(read_terrain(file, {.height_sign = HeightSign::up}).heights(0, 0), 100.0);
    EXPECT_EQ(
        message_of<InputError>([&] { (void)read_terrain(file, {.height_unit = "K"}); }),
        file.string() +
            ": the unit of heights is given as \"K\"; heights are in a unit of length (\"m\"); "
            "write bed.height_unit = \"ft\", say");
}

Terrain of_heights(const std::vector<double>& heights, double metres_per_number = 1.0) {
    Terrain terrain;
    terrain.heights = Grid(static_cast<int>(heights.size()), 1);
    std::ranges::copy(heights, terrain.heights.values().begin());
    terrain.metres_per_number = metres_per_number;
    return terrain;
}

TEST(DoubtfulHeights, CustomaryNumbersFarFromOthersAreTold) {
    struct Row {
        std::vector<double> heights;
        double metres_per_number;
        const char* number;  ///< that the note names; "" for no note
    };
    for (const Row& row : std::vector<Row>{
             {{1, 2, 3}, 1.0, ""},
             {{8000, 2, 3}, 1.0, ""},
             {{1, 9999, 3}, 1.0, "9999"},
             {{9100, 9999, 9400}, 1.0, ""},
             {{9999, 9999, 9999}, 1.0, ""},
             {{1, -9999, 3}, 1.0, "-9999"},
             {{-9500, -9999, -9300}, 1.0, ""},
             {{1, -32768, 3}, 1.0, "-32768"},
             {{1, 32767, 3}, 1.0, "32767"},
             {{1, -99999, 3}, 1.0, "-99999"},
             {{1, -9999 * 0.3048, 3}, 0.3048, "-9999"},
             {{1, 9999, 3}, -1.0, "-9999"},
             {{1, 40000, 3}, 1.0, "40000"},
         }) {
        const std::string note =
            suspect_heights(of_heights(row.heights, row.metres_per_number), "f");
        if (*row.number == '\0') {
            EXPECT_EQ(note, "");
            continue;
        }
        const std::string end = std::string("write bed.nodata_value = ") + row.number;
        EXPECT_TRUE(note.starts_with("1 of 3 cells have implausible heights")) << note;
        EXPECT_TRUE(note.ends_with(end)) << note;
    }
}

TEST(DoubtfulHeights, NoGroundIsAThousandKilometresHigh) {
    for (const auto& [height, number] : std::vector<std::pair<double, const char*>>{
             {1e20, "1e+20"},
             {-1.7976931348623157e308, "-1.7976931348623157e+308"},
             {3.4028234663852886e38, "3.4028234663852886e+38"},
             {1.1e6, "1100000"}}) {
        const Terrain terrain = of_heights({1, height, 3});
        const std::string message =
            message_of<InputError>([&] { (void)suspect_heights(terrain, "bed.asc"); });
        EXPECT_TRUE(
            message.starts_with("bed.asc: 1 of 3 cells have heights beyond ±1e+06 m, the first "))
            << message;
        EXPECT_NE(message.find(std::string("write bed.nodata_value = ") + number + ";"),
                  std::string::npos)
            << message;
    }
    EXPECT_NE(suspect_heights(of_heights({1, 9e5, 3}), "bed.asc"), "");
}

}  // namespace
}  // namespace fumon::test
