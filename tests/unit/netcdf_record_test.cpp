#include "files/netcdf_record.h"

#include <gtest/gtest.h>

#include <fstream>

#include "files/netcdf_fields.h"
#include "support/error.h"
#include "support/netcdf_file.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using testing::message_of;
using testing::TemporaryFolder;

Snapshot slope_with_water(std::int64_t step) {
    Snapshot snapshot;
    snapshot.step = step;
    snapshot.time = 0.1 * static_cast<double>(step);
    snapshot.time_unit = "s";
    snapshot.periodic = true;
    snapshot.scale = {2.0, 2.0, 1.0, true};
    snapshot.bed = Grid(6, 4, 0.5);
    snapshot.nodata = Mask(6, 4);
    snapshot.nodata(5, 1) = 1;
    Grid depth(6, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 6; ++x) depth(x, y) = 10.0 * x + y + static_cast<double>(step);
    }
    snapshot.fields = {{"water_depth", "depth of the water", "m", depth}};
    snapshot.numbers = {{"mean_slope", "1", 0.04},
                        {"rain_volume", "m3", 2.0 * static_cast<double>(step)}};
    return snapshot;
}

TEST(NetcdfRecord, IsWhatTheLastSnapshotHeldBesideItsBed) {
    const TemporaryFolder folder;
    FieldsFile file(folder / "fields.nc", slope_with_water(0), {"a slope", "seed = 1\n", 1});
    file.add(slope_with_water(0));
    file.add(slope_with_water(30));
    file.commit();
    const auto record = read_fields_record(folder / "fields.nc");
    ASSERT_TRUE(record);
    EXPECT_TRUE(record->periodic);
    ASSERT_EQ(record->fields.size(), 1U);
    EXPECT_EQ(record->fields[0].name, "water_depth");
    EXPECT_EQ(record->fields[0].unit, "m");
    Grid expected = slope_with_water(30).fields[0].values;
    expected(5, 1) = 0.0;
    EXPECT_EQ(record->fields[0].values, expected) << "0 where there is no data";
    ASSERT_EQ(record->numbers.size(), 2U);
    EXPECT_EQ(record->numbers[0].name, "mean_slope");
    EXPECT_EQ(record->numbers[1].value, 60.0);
    EXPECT_EQ(record->numbers[1].unit, "m3");
}

TEST(NetcdfRecord, IsNothingInOtherFilesAndAnErrorInDamagedOnes) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read_fields_record(folder / "none.nc"));
    std::ofstream(folder / "bed.asc") << "ncols 2\n";
    EXPECT_FALSE(read_fields_record(folder / "bed.asc"));
    {
        const testing::NetcdfMaker others(folder / "others.nc");
        static_cast<void>(others.dimension("x", 3));
    }
    EXPECT_FALSE(read_fields_record(folder / "others.nc"));
    FieldsFile empty(folder / "empty.nc", slope_with_water(0), {"a slope", "seed = 1\n", 1});
    empty.commit();
    const auto refusal = [&](const char* name) {
        return message_of<InputError>(
            [&] { static_cast<void>(read_fields_record(folder / name)); });
    };
    EXPECT_EQ(refusal("empty.nc"),
              (folder / "empty.nc").string() + ": has no record yet; let the run write one first");
    std::ofstream(folder / "cut.nc") << "\x89HDF\r\n\x1a\n and no more";
    EXPECT_NE(refusal("cut.nc").find("cut.nc: cannot be read as NetCDF: "), std::string::npos);
}

}  // namespace
}  // namespace fumon
