#include "files/netcdf/netcdf_record.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "files/netcdf/netcdf_fields.h"
#include "support/netcdf_file.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::TemporaryFolder;

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

TEST(NetcdfRecord, ASnapshotIsARecordInTheOutlineOfItsRun) {
    const TemporaryFolder folder;
    FieldsFile file(folder / "fields.nc", slope_with_water(0), {"a slope", "seed = 1\n", 1});
    for (const std::int64_t step : {0, 30, 60}) file.add(slope_with_water(step));
    file.commit();
    Snapshot outline = slope_with_water(0);
    outline.bed = Grid(6, 4);
    outline.nodata = Mask(6, 4);
    outline.fields[0].values = {};
    const Snapshot found = read_fields_snapshot(folder / "fields.nc", 30, outline);
    Snapshot expected = slope_with_water(30);
    expected.bed(5, 1) = 0.0;
    expected.fields[0].values(5, 1) = 0.0;
    EXPECT_EQ(found.step, 30);
    EXPECT_EQ(found.time, expected.time);
    EXPECT_EQ(found.time_unit, "s");
    EXPECT_EQ(found.bed, expected.bed);
    EXPECT_EQ(found.nodata, expected.nodata);
    EXPECT_EQ(found.scale, expected.scale);
    ASSERT_EQ(found.fields.size(), 1U);
    EXPECT_EQ(found.fields[0].long_name, "depth of the water");
    EXPECT_EQ(found.fields[0].values, expected.fields[0].values);
    EXPECT_EQ(found.numbers[1].value, 60.0);

    const auto refusal = [&](std::int64_t step) {
        return message_of<InputError>(
            [&] { static_cast<void>(read_fields_snapshot(folder / "fields.nc", step, outline)); });
    };
    EXPECT_NE(refusal(31).find("has no record of step 31"), std::string::npos);
    outline.bed = Grid(6, 5);
    EXPECT_NE(refusal(30).find("has another size"), std::string::npos);
}

TEST(NetcdfRecord, ATimeOverTwoDimensionsIsNoneOfAStep) {
    const TemporaryFolder folder;
    {
        const test::NetcdfMaker damaged(folder / "fields.nc", NC_CLASSIC_MODEL);
        const int time = damaged.dimension("time", 1);
        const int x = damaged.dimension("x", 2);
        static_cast<void>(damaged.variable("time", NC_DOUBLE, {time, x}));
        const int step = damaged.variable("step", NC_INT, {time});
        damaged.values(step, {1}, {0.0});
    }
    EXPECT_EQ(message_of<InputError>(
                  [&] { static_cast<void>(read_fields_snapshot(folder / "fields.nc", 0, {})); }),
              (folder / "fields.nc").string() +
                  ": has no time of a step; it belongs to another run: delete it");
}

TEST(NetcdfRecord, IsNothingInOtherFilesAndAnErrorInDamagedOnes) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read_fields_record(folder / "none.nc"));
    std::ofstream(folder / "bed.asc") << "ncols 2\n";
    EXPECT_FALSE(read_fields_record(folder / "bed.asc"));
    {
        const test::NetcdfMaker others(folder / "others.nc");
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

/// A file that says it is fumon's, with a bed over these dimensions (of two cells each).
class Forged {
  public:
    Forged(const std::filesystem::path& file, int bed_dimensions) : maker_(file) {
        maker_.text(NC_GLOBAL, "source", "fumon 0.1.0");
        for (const char* name : {"time", "y", "x"}) over_.push_back(maker_.dimension(name, 2));
        const std::vector<int> over(over_.end() - bed_dimensions, over_.end());
        const int bed = maker_.variable("bed_height", NC_DOUBLE, over);
        maker_.values(bed, std::vector<std::size_t>(over.size(), 2),
                      std::vector<double>(std::size_t{1} << over.size(), 1.0));
    }
    [[nodiscard]] const test::NetcdfMaker& maker() const { return maker_; }
    [[nodiscard]] const std::vector<int>& time_y_and_x() const { return over_; }

  private:
    test::NetcdfMaker maker_;
    std::vector<int> over_;
};

TEST(NetcdfRecord, ABedWithoutTimeOrPlaceIsNoneOfOurs) {
    const TemporaryFolder folder;
    for (const int dimensions : {0, 1, 2}) {
        const auto file = folder / ("forged" + std::to_string(dimensions) + ".nc");
        { const Forged forged(file, dimensions); }
        EXPECT_FALSE(read_fields_record(file)) << dimensions;
    }
}

TEST(NetcdfRecord, PathsOfTwoLengthsEndWithTheShorter) {
    const TemporaryFolder folder;
    {
        const Forged forged(folder / "forged.nc", 3);
        const test::NetcdfMaker& maker = forged.maker();
        const int time = forged.time_y_and_x().front();
        const int along = maker.dimension("section_x", 2);
        const int up = maker.dimension("z", 2);
        const int angle = maker.dimension("angle", 1);
        const int longer = maker.dimension("longer", 7);
        const int shorter = maker.dimension("shorter", 3);
        maker.values(maker.axis("section_x", along, "m"), {2}, {0.0, 1.0});
        maker.values(maker.axis("z", up, "m"), {2}, {0.0, 1.0});
        static_cast<void>(maker.variable("velocity_x", NC_DOUBLE, {time, up, along}));
        maker.values(maker.variable("launch_angle", NC_DOUBLE, {time, angle}), {2, 1}, {20., 30.});
        maker.values(maker.variable("path_x", NC_DOUBLE, {time, angle, longer}), {2, 1, 7},
                     std::vector<double>(14, 1.0));
        maker.values(maker.variable("path_z", NC_DOUBLE, {time, angle, shorter}), {2, 1, 3},
                     std::vector<double>(6, 1.0));
    }
    const auto record = read_fields_record(folder / "forged.nc");
    ASSERT_TRUE(record && record->section);
    ASSERT_EQ(record->section->paths.size(), 1U);
    EXPECT_EQ(record->section->paths.front().launch_angle, 30.0);
    EXPECT_EQ(record->section->paths.front().x.size(), 3U);
    EXPECT_EQ(record->section->paths.front().z.size(), 3U);
}

TEST(NetcdfRecord, ALoneScalarIsNoPath) {
    const TemporaryFolder folder;
    {
        const Forged forged(folder / "forged.nc", 3);
        const test::NetcdfMaker& maker = forged.maker();
        const int time = forged.time_y_and_x().front();
        const int along = maker.dimension("section_x", 2);
        const int up = maker.dimension("z", 2);
        maker.values(maker.axis("section_x", along, "m"), {2}, {0.0, 1.0});
        maker.values(maker.axis("z", up, "m"), {2}, {0.0, 1.0});
        static_cast<void>(maker.variable("velocity_x", NC_DOUBLE, {time, up, along}));
        for (const char* name : {"launch_angle", "path_x", "path_z"})
            static_cast<void>(maker.variable(name, NC_DOUBLE, {}));
    }
    const auto record = read_fields_record(folder / "forged.nc");
    ASSERT_TRUE(record && record->section);
    EXPECT_TRUE(record->section->paths.empty());
}

TEST(NetcdfRecord, FieldsBeyondTheLimitAreRefusedBeforeMemoryIsAskedFor) {
    const TemporaryFolder folder;
    {
        const Forged forged(folder / "forged.nc", 3);
        const test::NetcdfMaker& maker = forged.maker();
        const int along = maker.dimension("section_x", 1000000);
        const int up = maker.dimension("z", 1000000);
        static_cast<void>(maker.axis("section_x", along, "m"));
        static_cast<void>(maker.axis("z", up, "m"));
        static_cast<void>(
            maker.variable("velocity_x", NC_DOUBLE, {forged.time_y_and_x().front(), up, along}));
    }
    EXPECT_EQ(message_of<InputError>(
                  [&] { static_cast<void>(read_fields_record(folder / "forged.nc")); }),
              (folder / "forged.nc").string() +
                  ": has more than 134217728 values in one record; cut out or coarsen the part "
                  "you need");
}

TEST(NetcdfRecord, AClassicFileWithANameLongerThanItselfIsRefusedBeforeMemoryIsAskedFor) {
    const TemporaryFolder folder;
    const std::string one_dimension("CDF\1\0\0\0\0\0\0\0\12\0\0\0\1", 16);
    const std::string a_gigabyte("\x40\0\0\0", 4);
    std::ofstream(folder / "forged.nc") << one_dimension << a_gigabyte << "x";
    EXPECT_EQ(message_of<InputError>(
                  [&] { static_cast<void>(read_fields_record(folder / "forged.nc")); }),
              (folder / "forged.nc").string() +
                  ": ends within its header, after 21 bytes; it is damaged or cut short: copy it "
                  "again");
}

TEST(NetcdfRecord, AClassicFileWithoutAVariablesDimensionOrTypeIsRefused) {
    const TemporaryFolder folder;
    const auto number = [](int value) {
        return std::string{'\0', '\0', '\0', static_cast<char>(value)};
    };
    const auto header = [&](int second_dimension, int type) {
        std::string text = "CDF\1" + number(0);
        text += number(10) + number(2);                             // two dimensions
        text += number(1) + std::string("t\0\0\0", 4) + number(0);  // the records'
        text += number(1) + std::string("x\0\0\0", 4) + number(3);
        text += number(0) + number(0);   // no attributes
        text += number(11) + number(1);  // one variable
        text += number(1) + std::string("v\0\0\0", 4);
        text += number(2) + number(0) + number(second_dimension);
        text += number(0) + number(0);
        return text + number(type) + number(24) + number(96);
    };
    const auto refusal = [&](int second_dimension, int type = NC_DOUBLE) {
        std::ofstream(folder / "forged.nc")
            << header(second_dimension, type) << std::string(24, '\0');
        return message_of<InputError>(
            [&] { static_cast<void>(read_fields_record(folder / "forged.nc")); });
    };
    EXPECT_EQ(refusal(1), "") << "a sound file, though none of ours";
    const std::string line = (folder / "forged.nc").string() +
                             ": it has an element of unknown type, or with a missing or empty "
                             "dimension; it is damaged: copy it again";
    for (const int wrong : {0, 2, 7}) EXPECT_EQ(refusal(wrong), line) << wrong;
    for (const int wrong : {0, 12, 99}) EXPECT_EQ(refusal(1, wrong), line) << wrong;
}

}  // namespace
}  // namespace fumon
