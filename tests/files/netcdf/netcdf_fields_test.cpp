#include "files/netcdf/netcdf_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "support/netcdf_file.h"
#include "support/netcdf_records.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::cell;
using test::fields_text;
using test::height;
using test::message_of;
using test::NetcdfContent;
using test::snapshot;
using test::TemporaryFolder;
using test::write_records;

TEST(NetcdfFields, HoldsEveryRecord) {
    const TemporaryFolder folder;
    write_records(folder / "fields.nc", 3);
    const NetcdfContent content(folder / "fields.nc");
    EXPECT_EQ(content.length("date"), 3U);
    EXPECT_EQ(content.length("y"), 5U);
    EXPECT_EQ(content.length("x"), 7U);
    EXPECT_EQ(content.values("step"), (std::vector<double>{0, 10, 20}));
    EXPECT_EQ(content.values("time"), (std::vector<double>{0, 5, 10}));
    EXPECT_EQ(content.values("lost_grains"), (std::vector<double>{0, 100, 200}));
    EXPECT_EQ(content.values("x"), (std::vector<double>{1, 3, 5, 7, 9, 11, 13})) << "cell centres";
    EXPECT_EQ(content.values("y"), (std::vector<double>{1.5, 4.5, 7.5, 10.5, 13.5}));
    const auto bed = content.values("bed_height");
    const auto depth = content.values("water_depth");
    const auto moved = content.values("last_avalanche");
    for (std::size_t record = 0; record < 3; ++record) {
        const auto step = static_cast<std::int64_t>(10 * record);
        for (int y = 0; y < 5; ++y) {
            for (int x = 0; x < 7; ++x) {
                const std::size_t i = cell(x, y, record);
                if (x == 1 && y == 2) {
                    EXPECT_TRUE(std::isnan(bed[i]) && std::isnan(depth[i]) && std::isnan(moved[i]));
                    continue;
                }
                EXPECT_EQ(bed[i], 0.25 * height(step, x, y)) << "metres";
                EXPECT_EQ(depth[i], 100.0 * x + y);
                EXPECT_EQ(moved[i], static_cast<double>(step) - x);
            }
        }
    }
}

TEST(NetcdfFields, SaysWhatItHolds) {
    const TemporaryFolder folder;
    write_records(folder / "fields.nc", 1);
    const NetcdfContent content(folder / "fields.nc");
    EXPECT_EQ(content.text("", "Conventions"), "CF-1.8");
    EXPECT_EQ(content.text("", "title"), "a title");
    EXPECT_EQ(content.text("", "source"), "fumon " FUMON_VERSION);
    EXPECT_EQ(content.text("", "scene"), fields_text.scene);
    EXPECT_EQ(content.number("", "seed"), 7.0);
    EXPECT_EQ(content.number("", "cell_size_x"), 2.0);
    EXPECT_EQ(content.number("", "cell_size_y"), 3.0);
    EXPECT_EQ(content.number("", "height_unit"), 0.25);
    EXPECT_EQ(content.text("", "periodic"), "no");
    EXPECT_EQ(content.text("x", "units"), "m");
    EXPECT_EQ(content.text("x", "standard_name"), "projection_x_coordinate");
    EXPECT_EQ(content.text("x", "axis"), "") << "a longitude to VTK";
    EXPECT_EQ(content.text("y", "standard_name"), "projection_y_coordinate");
    EXPECT_EQ(content.text("y", "axis"), "");
    EXPECT_EQ(content.text("bed_height", "units"), "m");
    EXPECT_EQ(content.text("bed_height", "standard_name"), "surface_altitude");
    EXPECT_EQ(content.text("time", "units"), "s");
    EXPECT_EQ(content.text("water_depth", "long_name"), "depth of the water");
    EXPECT_EQ(content.text("last_avalanche", "units"), "1") << "udunits knows no grains";
    EXPECT_EQ(content.text("last_avalanche", "long_name"), "cells of the last avalanche (grains)");
    EXPECT_TRUE(std::isnan(content.number("bed_height", "_FillValue")));
}

TEST(NetcdfFields, LiesWhereItsTerrainLay) {
    const TemporaryFolder folder;
    const auto write = [&](const GeoReference& place) {
        Snapshot first = snapshot(0);
        first.scale.place = place;
        FieldsFile file(folder / "fields.nc", first, fields_text);
        file.add(first);
        file.commit();
        return NetcdfContent(folder / "fields.nc");
    };
    const NetcdfContent metric = write({500000.0, 4400000.0, 2.0, 3.0, false, "PROJCRS[\"a\"]"});
    EXPECT_EQ(metric.values("x").front(), 500001.0);
    EXPECT_EQ(metric.values("y").back(), 4400013.5);
    EXPECT_EQ(metric.text("x", "units"), "m");
    EXPECT_EQ(metric.text("crs", "crs_wkt"), "PROJCRS[\"a\"]");
    EXPECT_EQ(metric.text("water_depth", "grid_mapping"), "crs");
    const NetcdfContent degrees = write({-105.5, 40.0, 0.25, 0.125, true, ""});
    EXPECT_EQ(degrees.values("x").back(), -105.5 + 6.5 * 0.25);
    EXPECT_EQ(degrees.values("y").front(), 40.0625);
    EXPECT_EQ(degrees.text("x", "standard_name"), "longitude");
    EXPECT_EQ(degrees.text("y", "units"), "degrees_north");
    EXPECT_EQ(degrees.text("crs", "grid_mapping_name"), "latitude_longitude");
    EXPECT_EQ(degrees.text("bed_height", "grid_mapping"), "crs");
    EXPECT_EQ(degrees.text("x", "axis"), "X");
    const NetcdfContent feet = write({1000.0, 2000.0, 2.0 / 0.3048, 3.0 / 0.3048, false, "feet"});
    EXPECT_EQ(feet.values("x").front(), 1.0) << "from the south-west corner";
    EXPECT_EQ(feet.text("bed_height", "grid_mapping"), "");
}

TEST(NetcdfFields, SaysSitesWhereThereAreNoMetres) {
    const TemporaryFolder folder;
    Snapshot first = snapshot(0);
    first.scale = {};
    first.time_unit = "steps";
    first.periodic = true;
    FieldsFile file(folder / "fields.nc", first, fields_text);
    file.add(first);
    file.commit();
    const NetcdfContent content(folder / "fields.nc");
    EXPECT_EQ(content.text("x", "units"), "1");
    EXPECT_EQ(content.text("x", "long_name"), "site eastward (downwind)");
    EXPECT_EQ(content.text("x", "standard_name"), "");
    EXPECT_EQ(content.values("x").front(), 0.5);
    EXPECT_EQ(content.text("bed_height", "units"), "1");
    EXPECT_EQ(content.text("bed_height", "long_name"), "height of the bed (model heights)");
    EXPECT_EQ(content.text("bed_height", "standard_name"), "");
    EXPECT_EQ(content.text("time", "units"), "1");
    EXPECT_EQ(content.text("time", "long_name"), "step");
    EXPECT_EQ(content.text("", "periodic"), "yes");
    EXPECT_EQ(content.text("", "cell_size_unit"), "sites");
}

TEST(NetcdfFields, FieldsOfSeveralChunksComeBackWhole) {
    const TemporaryFolder folder;
    constexpr int nx = 700;
    constexpr int ny = 401;  // three chunks, the last shorter
    Snapshot first = snapshot(3, nx, ny);
    first.fields.clear();
    FieldsFile file(folder / "fields.nc", first, fields_text);
    file.add(first);
    file.add(first);
    file.commit();
    const auto bed = NetcdfContent(folder / "fields.nc").values("bed_height");
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (x == 1 && y == 2) continue;
            ASSERT_EQ(bed[cell(x, y, 1, nx, ny)], 0.25 * height(3, x, y)) << x << ", " << y;
        }
    }
}

TEST(NetcdfFields, ALongSceneTextFits) {
    const TemporaryFolder folder;
    const FieldsText much{"", std::string(300'000, 's'), 1};
    FieldsFile(folder / "fields.nc", snapshot(0), much).commit();
    const NetcdfContent content(folder / "fields.nc");
    EXPECT_EQ(content.text("", "scene"), much.scene);
    EXPECT_EQ(content.length("date"), 0U);
}

TEST(NetcdfFields, SameRecordsGiveTheSameBytes) {
    const TemporaryFolder folder;
    write_records(folder / "a.nc", 4);
    write_records(folder / "b.nc", 4);
    const std::string bytes = bytes_of(folder / "a.nc");
    EXPECT_EQ(bytes, bytes_of(folder / "b.nc"));
    // Object headers of HDF5, version 2: bit 5 of their flags says that times are stored.
    int headers = 0;
    for (std::size_t at = bytes.find("OHDR\2"); at != std::string::npos;
         at = bytes.find("OHDR\2", at + 1), ++headers)
        EXPECT_EQ(bytes[at + 5] & 0x20, 0) << "the clock is in the file";
    EXPECT_GT(headers, 5);
}

TEST(NetcdfFields, RefusesRecordsOfAnotherForm) {
    const TemporaryFolder folder;
    FieldsFile file(folder / "fields.nc", snapshot(0), fields_text);
    const auto refusal = [&](const Snapshot& other) {
        return message_of<Error>([&] { file.add(other); });
    };
    EXPECT_EQ(refusal(snapshot(4, 8, 5)), "cannot write " + (folder / "fields.nc").string() +
                                              ": step 4 has 8 x 5 cells, the file 7 x 5; all "
                                              "records of a file must have the same form");
    Snapshot other = snapshot(4);
    other.fields.pop_back();
    EXPECT_NE(refusal(other).find("step 4 has other fields or numbers"), std::string::npos);
    other = snapshot(4);
    other.numbers.front().name = "kept_grains";
    EXPECT_NE(refusal(other).find("step 4 has other fields or numbers"), std::string::npos);
    other = snapshot(4);
    other.scale.height_unit = 1.0;
    EXPECT_NE(refusal(other).find("step 4 has another scale"), std::string::npos);
    other = snapshot(4);
    other.fields.front().values = Grid(7, 4);
    EXPECT_NE(refusal(other).find("water_depth has 7 x 4 cells, the bed 7 x 5"), std::string::npos);
    file.add(snapshot(5));
    file.commit();
    EXPECT_EQ(NetcdfContent(folder / "fields.nc").values("step"), (std::vector<double>{5}));
}

TEST(NetcdfFields, RefusesNamesThatDoNotDo) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& name) {
        Snapshot first = snapshot(0);
        first.fields.front().name = name;
        return message_of<Error>([&] { FieldsFile(folder / "fields.nc", first, fields_text); });
    };
    EXPECT_EQ(
        refusal("water depth"),
        "a field is called \"water depth\"; NetCDF names are letters, digits and underscores");
    EXPECT_EQ(refusal("time"), "two fields are called \"time\"; each needs its own name");
    EXPECT_EQ(refusal("lost_grains"),
              "two fields are called \"lost_grains\"; each needs its own name");
    EXPECT_EQ(folder.entries(), 0);
}

TEST(NetcdfFields, SeveralThreadsWriteAndReadAtOnce) {
    const TemporaryFolder folder;
    write_records(folder / "alone.nc", 30);
    constexpr int threads = 6;
    ::testing::internal::CaptureStderr();
    {
        std::vector<std::jthread> writers;
        for (int i = 0; i < threads; ++i) {
            writers.emplace_back([&folder, i] {
                const auto path = folder / ("fields" + std::to_string(i) + ".nc");
                write_records(path, 30);
                for (int again = 0; again < 10; ++again)
                    EXPECT_EQ(read_terrain(path, {}).heights(0, 0), 0.25 * height(290, 0, 0));
            });
        }
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "HDF5 speaks of its own accord";
    for (int i = 0; i < threads; ++i)
        EXPECT_EQ(bytes_of(folder / ("fields" + std::to_string(i) + ".nc")),
                  bytes_of(folder / "alone.nc"));
}

TEST(NetcdfFields, NcdumpShowsIt) {
    if (std::system("command -v ncdump > /dev/null") != 0) GTEST_SKIP() << "no ncdump here";
    const TemporaryFolder folder;
    write_records(folder / "fields.nc", 2);
    const auto spoken = test::run_command("ncdump -h " + (folder / "fields.nc").string());
    EXPECT_EQ(spoken.status, 0);
    for (const char* line :
         {"date = UNLIMITED ; // (2 currently)", "double date(date) ;", "double time(date) ;",
          "double step(date) ;", "date:units = \"seconds since 2000-01-01 00:00:00\" ;",
          "double bed_height(date, y, x) ;", "bed_height:_FillValue = NaN ;",
          "bed_height:units = \"m\" ;", "bed_height:standard_name = \"surface_altitude\" ;",
          "double water_depth(date, y, x) ;", "double lost_grains(date) ;",
          "x:standard_name = \"projection_x_coordinate\" ;", ":Conventions = \"CF-1.8\" ;",
          ":seed = 7 ;", ":title = \"a title\" ;"})
        EXPECT_NE(spoken.words.find(line), std::string::npos) << line << " in\n" << spoken.words;
}

TEST(NetcdfFields, XarrayOpensItWithoutAWarning) {
    if (std::system("/usr/bin/python3 -c 'import xarray, netCDF4' > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "/usr/bin/python3 has no xarray with netCDF4 here";
    const TemporaryFolder folder;
    write_records(folder / "metres.nc", 3);
    Snapshot first = snapshot(0);
    first.scale = {};
    first.time_unit = "steps";
    FieldsFile file(folder / "sites.nc", first, fields_text);
    file.add(first);
    file.commit();
    const auto script = folder.file("check.py", R"(
import math, sys, warnings
import cftime, netCDF4, pandas, xarray
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    metres = xarray.open_dataset(sys.argv[1]).load()
    sites = xarray.open_dataset(sys.argv[2]).load()
assert not caught, [str(w.message) for w in caught]
assert metres.bed_height.dims == ("date", "y", "x"), metres.bed_height.dims
assert dict(metres.sizes) == {"date": 3, "y": 5, "x": 7}, metres.sizes
assert set(metres.coords) == {"date", "y", "x"}, metres.coords
assert metres.time.values.tolist() == [0.0, 5.0, 10.0], metres.time
assert metres.time.dtype == "float64" and metres.time.attrs["units"] == "s"
assert metres.step.values.tolist() == [0, 10, 20] and metres.step.dtype == "float64"
assert str(metres.date.values[2]) == "2000-01-01T00:00:10.000000000", metres.date
assert metres.x.attrs["units"] == "m" and metres.bed_height.attrs["units"] == "m"
value = float(metres.bed_height.sel(date="2000-01-01T00:00:10", x=13.0, y=4.5))
assert abs(value - 0.25 * (math.sin(0.3 * 6 + 0.7 * 1) + 0.2)) < 1e-15, value
assert int(metres.bed_height.isnull().sum()) == 3
assert float(metres.water_depth.isel(date=0, y=2, x=3)) == 302.0
assert metres.lost_grains.dims == ("date",)
assert metres.attrs["seed"] == 7 and metres.attrs["scene"].startswith("seed = 7\n")
assert sites.time.values.tolist() == [0.0] and sites.time.dtype == "float64"
assert sites.x.values[0] == 0.5 and sites.x.attrs["units"] == "1"
print("all is well")
)");
    const auto spoken =
        test::run_command("/usr/bin/python3 " + script.string() + " " +
                          (folder / "metres.nc").string() + " " + (folder / "sites.nc").string());
    EXPECT_EQ(spoken.status, 0);
    EXPECT_EQ(spoken.words, "all is well\n");
}

}  // namespace
}  // namespace fumon
