#include "files/terrain/netcdf_bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "files/netcdf/netcdf_fields.h"
#include "files/terrain/geographic.h"
#include "files/unit_conversion.h"
#include "scene/initial_bed.h"
#include "scene/read.h"
#include "support/netcdf_beds.h"
#include "support/netcdf_file.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::make_bed;
using test::message_of;
using test::NetcdfBed;
using test::NetcdfMaker;
using test::SimpleBed;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Snapshot own_snapshot(bool in_metres) {
    Snapshot snapshot;
    snapshot.time_unit = "steps";
    snapshot.scale = in_metres ? WorldScale{0.1, 0.3, 0.5, true} : WorldScale{};
    snapshot.bed = Grid(5, 4);
    for (std::size_t i = 0; i < snapshot.bed.size(); ++i)
        snapshot.bed.values()[i] = 1.0 / (1.0 + static_cast<double>(i));
    snapshot.nodata = Mask(5, 4);
    snapshot.nodata(3, 1) = 1;
    snapshot.fields = {{"moved", "moved sand", "1", Grid(5, 4, 8.0)}};
    return snapshot;
}

TEST_F(NetcdfBed, AFieldsFileComesBack) {
    Snapshot snapshot = own_snapshot(true);
    FieldsFile file(path, snapshot, {});
    file.add(snapshot);
    for (double& height : snapshot.bed.values()) height += 1.0;
    file.add(snapshot);
    file.commit();
    const Terrain terrain = read();
    EXPECT_EQ(terrain.dx, 0.1);
    EXPECT_EQ(terrain.dy, 0.3);
    EXPECT_EQ(terrain.nodata, snapshot.nodata);
    EXPECT_EQ(terrain.note, "the last of 2 records of bed_height is read");
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 5; ++x) {
            if (snapshot.nodata(x, y) != 0) continue;
            EXPECT_EQ(terrain.heights(x, y), 0.5 * snapshot.bed(x, y));
        }
    }
    EXPECT_EQ(read("moved").heights(0, 0), 8.0);
    const Terrain first = read_terrain(path, {.record = 1});
    EXPECT_EQ(first.note, "");
    EXPECT_TRUE(read_terrain(path, {.record = 2}).heights == terrain.heights);
    EXPECT_EQ(first.heights(0, 0), 0.5 * (snapshot.bed(0, 0) - 1.0));
    EXPECT_EQ(message_of<InputError>([&] { (void)read_terrain(path, {.record = 3}); }),
              path.string() + ": bed_height has 2 records; name one of them by bed.record, 1 to 2");
}

TEST_F(NetcdfBed, AFieldsFileInSitesBringsNoCellSize) {
    FieldsFile file(path, own_snapshot(false), {});
    file.add(own_snapshot(false));
    file.commit();
    const Terrain terrain = read();
    EXPECT_EQ(terrain.dx, 0.0);
    EXPECT_EQ(terrain.dy, 0.0);
    EXPECT_EQ(terrain.heights(0, 0), 1.0);
    EXPECT_EQ(terrain.note, "");
}

TEST_F(NetcdfBed, EveryFormatAndTypeIsRead) {
    for (const int format :
         {NC_NETCDF4, NC_NETCDF4 | NC_CLASSIC_MODEL, 0, NC_64BIT_OFFSET, NC_64BIT_DATA}) {
        for (const int type : {NC_BYTE, NC_SHORT, NC_INT, NC_FLOAT, NC_DOUBLE}) {
            make_bed(path, {.type = type, .format = format});
            const Terrain terrain = read();
            EXPECT_EQ(terrain.heights(0, 0), 1.0) << format << ' ' << type;
            EXPECT_EQ(terrain.heights(2, 1), 6.0);
            EXPECT_EQ(terrain.dx, 10.0);
            EXPECT_EQ(terrain.dy, 5.0);
            EXPECT_TRUE(terrain.nodata.empty());
        }
    }
}

TEST_F(NetcdfBed, CoordinatesSayWhereNorthAndEastAre) {
    make_bed(path, {.x = {30, 20, 10}, .y = {10, 5}});
    const Terrain terrain = read();
    EXPECT_EQ(terrain.heights(0, 0), 6.0);
    EXPECT_EQ(terrain.heights(2, 0), 4.0);
    EXPECT_EQ(terrain.heights(0, 1), 3.0);
    EXPECT_EQ(terrain.dx, 10.0);
}

TEST_F(NetcdfBed, PackedHeightsAndMissingOnesAreUnderstood) {
    make_bed(path, {.heights = {100, -32768, 300, -9999, 500, 600},
                    .type = NC_SHORT,
                    .more = [](const NetcdfMaker& maker, int z) {
                        maker.number(z, "_FillValue", NC_SHORT, {-32768});
                        maker.number(z, "missing_value", NC_SHORT, {-9999});
                        maker.number(z, "valid_max", NC_SHORT, {550});
                        maker.number(z, "scale_factor", NC_DOUBLE, {0.5});
                        maker.number(z, "add_offset", NC_DOUBLE, {1000});
                        maker.text(z, "units", "m");
                    }});
    const Terrain terrain = read();
    EXPECT_EQ(terrain.heights(0, 0), 1050.0);
    EXPECT_EQ(terrain.heights(1, 1), 1250.0);
    ASSERT_FALSE(terrain.nodata.empty());
    const auto mask = terrain.nodata.values();
    EXPECT_EQ(std::vector<int>(mask.begin(), mask.end()), (std::vector<int>{0, 1, 0, 1, 0, 1}));
}

TEST_F(NetcdfBed, NaNAndTheDefaultFillAreNoData) {
    make_bed(path, {.heights = {1, not_a_number, 3, NC_FILL_DOUBLE, 5, 6}});
    const Terrain terrain = read();
    EXPECT_EQ(terrain.nodata(1, 0), 1);
    EXPECT_EQ(terrain.nodata(0, 1), 1);
    EXPECT_EQ(terrain.nodata(2, 1), 0);
}

TEST_F(NetcdfBed, DegreesBecomeMetresAtTheMiddleLatitude) {
    const DegreeLengths lengths = degree_lengths(40.015);
    const SimpleBed bed{.x = {-105.02, -105.01, -105.0},
                        .y = {40.02, 40.01},
                        .unit = "degrees_north",
                        .axis_type = NC_FLOAT,
                        .x_name = "lon",
                        .y_name = "lat"};
    make_bed(path, bed);
    const Terrain terrain = read();
    EXPECT_NEAR(terrain.dx, 0.01 * lengths.east, 0.5) << "single-precision longitudes";
    EXPECT_NEAR(terrain.dy, 0.01 * lengths.north, 0.5);
    EXPECT_EQ(terrain.heights(0, 1), 1.0) << "latitudes fall in the file";
    EXPECT_NE(terrain.note.find("degrees"), std::string::npos) << terrain.note;

    const DegreeLengths middle = degree_lengths(43.0);  // of 41 … 45: 3 % off at either edge
    make_bed(path, {.x = {-106, -104, -102},
                    .y = {44, 42},
                    .unit = "degrees_north",
                    .x_name = "lon",
                    .y_name = "lat"});
    EXPECT_NEAR(read().dx, 2.0 * middle.east, 1e-6);
    EXPECT_NEAR(read().dy, 2.0 * middle.north, 1e-6);

    SimpleBed unsaid = bed;
    unsaid.unit = "";
    make_bed(path, unsaid);
    EXPECT_NEAR(read().dx, 0.01 * lengths.east, 0.5) << "a needle in metres: by is_geographic";
    unsaid.heights = std::vector<double>(6, 1.0);
    make_bed(path, unsaid);
    EXPECT_NEAR(read().dx, 0.01, 1e-4) << "flat: metres";
}

TEST_F(NetcdfBed, OtherLengthsBecomeMetres) {
    make_bed(path, {.unit = "km",
                    .more = [](const NetcdfMaker& maker, int z) { maker.text(z, "units", "cm"); }});
    const Terrain terrain = read();
    EXPECT_EQ(terrain.dx, 10'000.0);
    EXPECT_DOUBLE_EQ(terrain.heights(2, 1), 0.06);
    EXPECT_EQ(terrain.note, "heights converted to metres from cm");
    make_bed(path, {.more = [](const NetcdfMaker& maker, int z) {
                 maker.text(z, "units", "meters above mean sea level");
             }});
    EXPECT_EQ(read().heights(2, 1), 6.0);
    EXPECT_EQ(read().note, "");
    make_bed(path,
             {.more = [](const NetcdfMaker& maker, int z) { maker.text(z, "units", "m s-1"); }});
    EXPECT_NE(refusal().find("z is in \"m s-1\""), std::string::npos);
    EXPECT_EQ(metres_per_unit("Feet"), 0.3048);
    EXPECT_FALSE(metres_per_unit("K").has_value());
}

TEST_F(NetcdfBed, CoordinatesMustBeEven) {
    make_bed(path, {.x = {0, 10, 22.2}});
    EXPECT_EQ(refusal(),
              "x is not evenly spaced: x[1] is 10 where even spacing has 11.1; interpolate the "
              "heights to even spacing first");
    make_bed(path, {.x = {0, 10, 20.000001}});
    EXPECT_EQ(read().dx, 10.0000005);
    make_bed(path, {.x = {0, 20, 10}});
    EXPECT_NE(refusal().find("x is not evenly spaced"), std::string::npos);
    make_bed(path, {.x = {10, 10, 10}});
    EXPECT_EQ(refusal(), "x begins and ends at 10; coordinates must rise or fall evenly");
    make_bed(path, {.x = {0, not_a_number, 20}});
    EXPECT_EQ(refusal(), "x[1] is not a finite number; all coordinates must be finite");
    make_bed(path, {.unit = "K"});
    EXPECT_EQ(refusal(),
              "the unit of x is \"K\"; coordinates are in a unit of length (\"m\") or in degrees");
}

TEST_F(NetcdfBed, SinglePrecisionCoordinatesAreEvenEnough) {
    SimpleBed bed{.y = {4'000'000.0, 4'000'030.0}, .axis_type = NC_FLOAT};
    bed.x.clear();
    for (int i = 0; i < 1000; ++i) bed.x.push_back(500'000.1 + 30.1 * i);
    bed.heights.assign(2000, 1.0);
    make_bed(path, bed);
    EXPECT_NEAR(read().dx, 30.1, 1e-4);
}

TEST_F(NetcdfBed, ASingleRowHasSquareCells) {
    make_bed(path, {.y = {5}, .heights = {1, 2, 3}});
    const Terrain terrain = read();
    EXPECT_EQ(terrain.heights.ny(), 1);
    EXPECT_EQ(terrain.dx, 10.0);
    EXPECT_EQ(terrain.dy, 10.0);
}

TEST_F(NetcdfBed, WithoutCoordinatesTheFirstRowIsTheSouthernmost) {
    {
        const NetcdfMaker maker(path);
        const int rows = maker.dimension("rows", 2);
        const int columns = maker.dimension("columns", 3);
        maker.values(maker.variable("Band1", NC_FLOAT, {rows, columns}), {2, 3},
                     {1, 2, 3, 4, 5, 6});
    }
    const Terrain terrain = read();
    EXPECT_EQ(terrain.heights(2, 0), 3.0);
    EXPECT_EQ(terrain.dx, 0.0);
    EXPECT_EQ(terrain.note,
              "no coordinates for rows: its first row is taken for the southernmost, and the cell "
              "size is unknown; no coordinates for columns: its first column is taken for the "
              "westernmost, and the cell size is unknown");
}

TEST_F(NetcdfBed, TheVariableIsNamedOrTheOnlyOne) {
    const auto second = [](const char* name) {
        return [name](const NetcdfMaker& maker, int) {
            maker.text(maker.variable(name, NC_DOUBLE, {0, 1}), "long_name", "another");
            maker.text(maker.variable("crs", NC_CHAR, {}), "grid_mapping_name", "mercator");
        };
    };
    make_bed(path, {.more = second("slope")});
    EXPECT_EQ(refusal(),
              "holds 2 variables that may be the bed; name one by bed.variable: z, slope");
    EXPECT_EQ(read("z").heights(0, 0), 1.0);
    EXPECT_EQ(refusal("slpoe"), "has no variable \"slpoe\"; did you mean \"slope\"?");
    EXPECT_EQ(
        refusal("x"),
        "x has 1 dimensions; a bed is a numeric variable over y and x, or over these and one of "
        "time, band or the like");
    EXPECT_EQ(refusal("slope"),
              "slope holds no data in any cell; at least one height must differ "
              "from the _FillValue");
    make_bed(path, {.more = second("bed_height")});
    EXPECT_NE(refusal().find("bed_height holds no data"), std::string::npos) << "before others";
    make_bed(path, {.more = [](const NetcdfMaker& maker, int z) {
                 maker.text(z, "coordinates", "longitudes");
                 (void)maker.variable("longitudes", NC_DOUBLE, {0, 1});
             }});
    EXPECT_EQ(read().heights(0, 0), 1.0) << "two-dimensional coordinates are no bed";
}

TEST_F(NetcdfBed, WhatIsNoBedIsRefused) {
    {
        const NetcdfMaker maker(path);
        const int time = maker.dimension("time", NC_UNLIMITED);
        const int x = maker.dimension("x", 3);
        const int y = maker.dimension("y", 2);
        (void)maker.variable("profile", NC_DOUBLE, {time, x});
        (void)maker.variable("words", NC_CHAR, {y, x});
    }
    EXPECT_EQ(
        refusal(),
        "holds no bed; a bed is a numeric variable over y and x, or over these and one of time, "
        "band or the like");
    EXPECT_NE(
        refusal("profile").find("profile has the dimensions time and x, which do not form a map; "),
        std::string::npos);
    EXPECT_NE(refusal("words").find("words does not hold numbers; "), std::string::npos);
}

TEST_F(NetcdfBed, ARunWithoutARecordHasNoBed) {
    FieldsFile(path, own_snapshot(true), {}).commit();
    EXPECT_EQ(refusal(), "bed_height has no record yet; let the run write one first");
}

TEST_F(NetcdfBed, HeightsMustBeHeights) {
    make_bed(path, {.more = [](const NetcdfMaker& maker, int z) { maker.text(z, "units", "K"); }});
    EXPECT_EQ(refusal(),
              "z is in \"K\"; heights are in a unit of length (\"m\"); name another "
              "variable by bed.variable");
    make_bed(path, {.heights = {1, 2, 3, 4, std::numeric_limits<double>::infinity(), 6}});
    EXPECT_EQ(refusal(),
              "z is infinite at row 2, column 2 from the south-west; write a finite "
              "number or the _FillValue");
}

TEST_F(NetcdfBed, KeysOfOtherFilesAreRefused) {
    make_bed(path, {});
    EXPECT_EQ(message_of<InputError>([&] {
                  (void)read_terrain(path, {{0, 850}});
              }),
              path.string() +
                  ": a height range was given for a NetCDF file, which holds its own heights; "
                  "leave bed.heights or --heights out");
    const auto esri = folder.file("bed.asc", "ncols 1\nnrows 1\ncellsize 1\n5\n");
    EXPECT_EQ(message_of<InputError>([&] { (void)read_terrain(esri, {.variable = "z"}); }),
              esri.string() +
                  ": a variable was named for an ESRI ASCII grid, which has none; "
                  "leave bed.variable out");
}

TEST_F(NetcdfBed, AFileByAnOddNameIsRead) {
    std::filesystem::create_directory(folder / "#mode=zarr");
    path = folder / "#mode=zarr/a bed [1] 砂.dat";
    make_bed(path, {});
    EXPECT_EQ(read().heights(0, 0), 1.0);
}

TEST_F(NetcdfBed, ASceneStartsFromOne) {
    make_bed(path, {.more = [](const NetcdfMaker& maker, int) {
                 (void)maker.variable("slope", NC_DOUBLE, {0, 1});
             }});
    const std::string begin = "[model]\nname = \"static\"\n[bed]\nkind = \"file\"\n";
    const Scene scene =
        parse_scene(begin + "file = \"bed.nc\"\nvariable = \"z\"\n", "scene.toml", folder.path());
    const InitialBed initial = make_initial_bed(scene);
    EXPECT_EQ(initial.bed(2, 1), 6.0);
    EXPECT_EQ(initial.scale, (WorldScale{10.0, 5.0, 1.0, true, GeoReference{5.0, 2.5, 10.0, 5.0}}));
    EXPECT_EQ(
        message_of<InputError>([] {
            parse_scene("[model]\nname = \"static\"\n[bed]\nvariable = \"z\"\n", "scene.toml", "");
        }),
        "scene.toml:4:12: bed.variable belongs to a NetCDF bed; write bed.kind = \"file\" and "
        "bed.file");
}

}  // namespace
}  // namespace fumon
