#include "files/netcdf/netcdf_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "base/error.h"
#include "files/netcdf/netcdf_fields.h"
#include "files/netcdf/netcdf_layout.h"
#include "files/netcdf/netcdf_record.h"
#include "support/air_snapshots.h"
#include "support/full_disk.h"
#include "support/netcdf_file.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::air_snapshot;
using test::air_text;
using test::bytes_of;
using test::message_of;
using test::missing;
using test::NetcdfContent;
using test::path;
using test::section;
using test::speed;
using test::TemporaryFolder;

void write_steps(const std::filesystem::path& file, const std::vector<std::int64_t>& steps) {
    FieldsFile fields(file, air_snapshot(0), air_text);
    for (const std::int64_t step : steps) fields.add(air_snapshot(step));
    fields.commit();
}

TEST(NetcdfSection, HoldsFieldsAndCurvesOfEveryRecord) {
    const TemporaryFolder folder;
    write_steps(folder / "fields.nc", {0, 3});
    const NetcdfContent content(folder / "fields.nc");
    EXPECT_EQ(content.values("section_x"), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
    EXPECT_EQ(content.values("z"), (std::vector<double>{0, 0.125, 0.25, 0.375}));
    EXPECT_EQ(content.values("x").front(), 0.125) << "the cells' centres";
    const auto along = content.values("velocity_x");
    const auto pressure = content.values("pressure");
    const auto bed = content.values("section_bed_height");
    const auto flight = content.values("flight_length_12_5");
    ASSERT_EQ(along.size(), 2U * 4 * 5);
    ASSERT_EQ(flight.size(), 2U * 5);
    for (std::size_t record = 0; record < 2; ++record) {
        const std::int64_t step = record == 0 ? 0 : 3;
        for (int i = 0; i < 5; ++i) {
            for (int k = 0; k < 4; ++k) {
                const std::size_t node =
                    (record * 4 + static_cast<std::size_t>(k)) * 5 + static_cast<std::size_t>(i);
                EXPECT_EQ(along[node], speed(step, i, k));
                EXPECT_EQ(pressure[node], -speed(step, i, k));
            }
            const std::size_t column = record * 5 + static_cast<std::size_t>(i);
            EXPECT_EQ(bed[column], 0.01 * i);
            if (i == 2) {
                EXPECT_TRUE(std::isnan(flight[column]));
            } else {
                EXPECT_EQ(flight[column], 0.1 * i + static_cast<double>(step));
            }
        }
    }
    EXPECT_EQ(content.values("bed_height"), std::vector<double>(10, 0.02)) << "the cells'";
}

TEST(NetcdfSection, SaysWhatItHolds) {
    const TemporaryFolder folder;
    write_steps(folder / "fields.nc", {1});
    const NetcdfContent content(folder / "fields.nc");
    EXPECT_EQ(content.text("z", "units"), "m");
    EXPECT_EQ(content.text("z", "axis"), "Z");
    EXPECT_EQ(content.text("z", "positive"), "up");
    EXPECT_EQ(content.text("z", "long_name"), "height");
    EXPECT_EQ(content.text("section_x", "units"), "m");
    EXPECT_EQ(content.text("section_x", "axis"), "") << "a longitude to VTK";
    EXPECT_EQ(content.text("section_x", "long_name"), "distance along the section");
    EXPECT_EQ(content.text("velocity_x", "units"), "m/s");
    EXPECT_EQ(content.text("velocity_x", "long_name"), "velocity of the air along x");
    EXPECT_EQ(content.text("section_bed_height", "units"), "m");
    EXPECT_EQ(content.text("hop_base", "units"), "mm-1") << "as udunits says it";
    EXPECT_EQ(content.text("launch_angle", "units"), "degrees");
    EXPECT_EQ(content.text("path_x", "units"), "m");
    for (const char* name : {"velocity_x", "flight_length_12_5", "launch_angle", "path_z"})
        EXPECT_TRUE(std::isnan(content.number(name, "_FillValue"))) << name;
}

TEST(NetcdfSection, PathsEndWhereTheyEnd) {
    const TemporaryFolder folder;
    write_steps(folder / "fields.nc", {1, 3, 0});  // the longest has 8 points
    const NetcdfContent content(folder / "fields.nc");
    EXPECT_EQ(content.length("path"), 2U);
    ASSERT_EQ(content.length("path_point"), 8U);
    EXPECT_EQ(content.values("launch_angle"), (std::vector<double>{10, 40, 10, 40, 10, 40}));
    const auto x = content.values("path_x");
    const auto z = content.values("path_z");
    const std::vector<std::size_t> points{3, 4, 5, 8, 2, 2};
    for (std::size_t line = 0; line < points.size(); ++line) {
        for (std::size_t n = 0; n < 8; ++n) {
            const auto place = static_cast<double>(n);
            const std::size_t at = 8 * line + n;
            if (n < points[line]) {
                EXPECT_EQ(x[at], 0.1 * place + (line % 2 == 0 ? 10.0 : 40.0));
                EXPECT_EQ(z[at], 0.01 * place * place);
            } else {
                EXPECT_TRUE(std::isnan(x[at]) && std::isnan(z[at])) << line << ", " << n;
            }
        }
    }
}

TEST(NetcdfSection, ComesBackAsItWas) {
    const TemporaryFolder folder;
    write_steps(folder / "fields.nc", {9, 2});
    const auto record = read_fields_record(folder / "fields.nc");
    ASSERT_TRUE(record && record->section);
    const SnapshotSection& read = *record->section;
    const SnapshotSection written = section(2);
    EXPECT_EQ(read.dx, written.dx);
    EXPECT_EQ(read.dz, written.dz);
    ASSERT_EQ(read.fields.size(), 2U);
    for (std::size_t n = 0; n < 2; ++n) {
        EXPECT_EQ(read.fields[n].name, written.fields[n].name);
        EXPECT_EQ(read.fields[n].long_name, written.fields[n].long_name);
        EXPECT_EQ(read.fields[n].unit, written.fields[n].unit);
        EXPECT_EQ(read.fields[n].values, written.fields[n].values);
    }
    ASSERT_EQ(read.curves.size(), 2U);
    EXPECT_EQ(read.curves[0].name, "bed_height");
    EXPECT_EQ(read.curves[0].values, written.curves[0].values);
    EXPECT_EQ(read.curves[1].name, "flight_length_12.5");
    EXPECT_EQ(read.curves[1].unit, "m");
    EXPECT_TRUE(std::isnan(read.curves[1].values[2]));
    EXPECT_EQ(read.curves[1].values[4], written.curves[1].values[4]);
    ASSERT_EQ(read.paths.size(), 2U);
    for (std::size_t n = 0; n < 2; ++n) {
        EXPECT_EQ(read.paths[n].launch_angle, written.paths[n].launch_angle);
        EXPECT_EQ(read.paths[n].x, written.paths[n].x);
        EXPECT_EQ(read.paths[n].z, written.paths[n].z);
    }
    EXPECT_TRUE(record->fields.empty()) << "none over the bed's cells";
    ASSERT_EQ(record->numbers.size(), 2U);
    EXPECT_EQ(record->numbers[0].name, "lid_speed");
}

TEST(NetcdfSection, MayHaveNoPathsAndSeveralChunks) {
    const TemporaryFolder folder;
    SnapshotSection wide = section(1, 700, 401);  // three chunks, the last shorter
    wide.paths.clear();
    FieldsFile file(folder / "fields.nc", air_snapshot(1, wide), air_text);
    file.add(air_snapshot(1, wide));
    file.commit();
    const auto record = read_fields_record(folder / "fields.nc");
    ASSERT_TRUE(record && record->section);
    EXPECT_EQ(record->section->fields[1].values, wide.fields[1].values);
    EXPECT_TRUE(record->section->paths.empty());
}

TEST(NetcdfSection, SameRecordsGiveTheSameBytes) {
    const TemporaryFolder folder;
    write_steps(folder / "a.nc", {0, 5, 700, 2});
    write_steps(folder / "b.nc", {0, 5, 700, 2});
    EXPECT_EQ(bytes_of(folder / "a.nc"), bytes_of(folder / "b.nc"));
}

/// Values that do not compress, and paths of many points.
Snapshot rough_air(std::int64_t step) {
    SnapshotSection made = section(step, 200, 180);
    std::uint64_t state = 12345 + static_cast<std::uint64_t>(step);
    const auto next = [&] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state >> 11);
    };
    for (SnapshotField& field : made.fields) {
        for (double& value : field.values.values()) value = next();
    }
    made.paths = {path(20000 + 600 * step, 10.0), path(5, 40.0), path(700, 70.0)};
    for (double& place : made.paths[0].z) place = next();
    return air_snapshot(step, made);
}

TEST(NetcdfSection, AFullDiskSpoilsNothing) {
    const TemporaryFolder folder;
    const test::FileSizeLimit limit(6'000'000);
    FieldsFile file(folder / "fields.nc", rough_air(0), air_text);
    std::string message;
    for (int i = 0; i < 100 && message.empty(); ++i)
        message = message_of<Error>([&] { file.add(rough_air(i)); });
    EXPECT_NE(message.find("File too large; its next record needs up to "), std::string::npos)
        << message;
    const auto records = file.records();
    ASSERT_GE(records, 3);
    file.commit();
    const auto record = read_fields_record(folder / "fields.nc");
    ASSERT_TRUE(record && record->section);
    const Snapshot last = rough_air(records - 1);
    EXPECT_EQ(record->section->fields[1].values, last.section->fields[1].values);
    EXPECT_EQ(record->section->paths[0].x, last.section->paths[0].x);
}

TEST(NetcdfSection, ARecordNeedsNoMoreThanIsSetAside) {
    const TemporaryFolder folder;
    FieldsFile file(folder / "fields.nc", rough_air(0), air_text);
    auto size = std::filesystem::file_size(folder / "fields.nc.part");
    for (std::int64_t step = 0; step < 60; step += 5) {
        const Snapshot next = rough_air(step);
        file.add(next);
        const auto grown = std::filesystem::file_size(folder / "fields.nc.part");
        EXPECT_LE(grown - size, static_cast<std::uintmax_t>(record_room(next))) << step;
        size = grown;
    }
}

TEST(NetcdfSection, RefusesRecordsOfAnotherForm) {
    const TemporaryFolder folder;
    FieldsFile file(folder / "fields.nc", air_snapshot(0), air_text);
    const auto refusal = [&](const Snapshot& other) {
        return message_of<Error>([&] { file.add(other); });
    };
    const std::string other_section =
        "cannot write " + (folder / "fields.nc").string() +
        ": step 4 has another section, in its spacing, fields, curves or number of paths; all "
        "records of a file must have the same form";
    Snapshot without = air_snapshot(4);
    without.section.reset();
    EXPECT_EQ(refusal(without), other_section);
    SnapshotSection other = section(4);
    other.dz = 0.5;
    EXPECT_EQ(refusal(air_snapshot(4, other)), other_section);
    other = section(4);
    other.curves.pop_back();
    EXPECT_EQ(refusal(air_snapshot(4, other)), other_section);
    other = section(4);
    other.fields[1].name = "vorticity";
    EXPECT_EQ(refusal(air_snapshot(4, other)), other_section);
    other = section(4);
    other.paths.pop_back();
    EXPECT_EQ(refusal(air_snapshot(4, other)), other_section);
    EXPECT_EQ(refusal(air_snapshot(4, section(4, 5, 7))), other_section);
    other = section(4);
    other.fields[1].values = Grid(5, 3);
    EXPECT_NE(refusal(air_snapshot(4, other)).find("pressure has 5 x 3 nodes, the section 5 x 4"),
              std::string::npos);
    other = section(4);
    other.curves[1].values.pop_back();
    EXPECT_NE(refusal(air_snapshot(4, other))
                  .find("flight_length_12.5 has 4 values, the section 5 columns"),
              std::string::npos);
    other = section(4);
    other.paths[0].z.pop_back();
    EXPECT_NE(refusal(air_snapshot(4, other)).find("a path has 6 x and 5 z"), std::string::npos);
    file.add(air_snapshot(5));
    file.commit();
    EXPECT_EQ(NetcdfContent(folder / "fields.nc").values("step"), (std::vector<double>{5}));
}

TEST(NetcdfSection, RefusesWhatNoFileCanHold) {
    const TemporaryFolder folder;
    const auto refusal = [&](const Snapshot& first) {
        return message_of<Error>([&] { FieldsFile(folder / "fields.nc", first, air_text); });
    };
    SnapshotSection first = section(0);
    first.curves[0].name = "velocity_x";
    EXPECT_EQ(refusal(air_snapshot(0, first)),
              "two fields are called \"velocity_x\"; each needs its own name");
    first = section(0);
    first.fields[0].name = "z";
    EXPECT_EQ(refusal(air_snapshot(0, first)),
              "two fields are called \"z\"; each needs its own name");
    first = section(0);
    first.curves[0].name = "lid_speed";
    EXPECT_EQ(refusal(air_snapshot(0, first)),
              "two fields are called \"lid_speed\"; each needs its own name");
    Snapshot rows = air_snapshot(0);
    rows.bed = Grid(5, 3);
    const std::string too_small = "a section needs 2 x 2 nodes or more, and a bed of one row";
    EXPECT_NE(
        refusal(rows).find("a section of 5 x 4 nodes lies over a bed of 5 x 3 cells; " + too_small),
        std::string::npos);
    EXPECT_NE(refusal(air_snapshot(0, section(0, 1, 4))).find(too_small), std::string::npos);
    EXPECT_NE(refusal(air_snapshot(0, section(0, 5, 1))).find(too_small), std::string::npos);
    Snapshot bare = air_snapshot(0);
    bare.section = std::make_shared<const SnapshotSection>();
    EXPECT_NE(refusal(bare).find(too_small), std::string::npos);
    EXPECT_EQ(folder.entries(), 0);
}

// ---- as other programs see it ----

TEST(NetcdfSection, NcdumpShowsIt) {
    if (std::system("command -v ncdump > /dev/null") != 0) GTEST_SKIP() << "no ncdump here";
    const TemporaryFolder folder;
    write_steps(folder / "fields.nc", {0, 4});
    const auto spoken = test::run_command("ncdump -h " + (folder / "fields.nc").string());
    EXPECT_EQ(spoken.status, 0);
    for (const char* line :
         {"z = 4 ;", "section_x = 5 ;", "path_point = UNLIMITED ; // (10 currently)",
          "double velocity_x(date, z, section_x) ;", "velocity_x:units = \"m/s\" ;",
          "double section_bed_height(date, section_x) ;", "double launch_angle(date, path) ;",
          "double path_x(date, path, path_point) ;", "z:positive = \"up\" ;"})
        EXPECT_NE(spoken.words.find(line), std::string::npos) << line << " in\n" << spoken.words;
}

TEST(NetcdfSection, XarrayOpensItWithoutAWarning) {
    if (std::system("/usr/bin/python3 -c 'import xarray, netCDF4' > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "/usr/bin/python3 has no xarray with netCDF4 here";
    const TemporaryFolder folder;
    write_steps(folder / "fields.nc", {0, 4});
    const auto script = folder.file("check.py", R"(
import sys, warnings
import cftime, netCDF4, pandas
import xarray
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    air = xarray.open_dataset(sys.argv[1]).load()
assert not caught, [str(w.message) for w in caught]
assert set(air.coords) == {"date", "x", "z", "section_x"}, air.coords
assert air.velocity_x.dims == ("date", "z", "section_x"), air.velocity_x.dims
assert float(air.velocity_x.isel(date=1).sel(z=0.25, section_x=0.75)) == 25.5
assert air.section_bed_height.dims == ("date", "section_x")
assert int(air.flight_length_12_5.isnull().sum()) == 2
assert air.path_x.dims == ("date", "path", "path_point"), air.path_x.dims
assert air.path_x.notnull().sum("path_point").values.tolist() == [[2, 2], [6, 10]]
print("all is well")
)");
    const auto spoken = test::run_command("/usr/bin/python3 " + script.string() + " " +
                                          (folder / "fields.nc").string());
    EXPECT_EQ(spoken.status, 0);
    EXPECT_EQ(spoken.words, "all is well\n");
}

}  // namespace
}  // namespace fumon
