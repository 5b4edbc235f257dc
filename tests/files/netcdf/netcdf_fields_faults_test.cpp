#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "files/netcdf/netcdf_fields.h"
#include "support/full_disk.h"
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

TEST(NetcdfFields, BearsItsNameOnlyOnceCommitted) {
    const TemporaryFolder folder;
    folder.file("fields.nc", "old");
    folder.file("fields.nc.part", "left by a killed run");
    {
        FieldsFile file(folder / "fields.nc", snapshot(0), fields_text);
        file.add(snapshot(0));
        EXPECT_EQ(bytes_of(folder / "fields.nc"), "old");
        EXPECT_TRUE(std::filesystem::exists(folder / "fields.nc.part"));
    }
    EXPECT_EQ(folder.entries(), 1) << "uncommitted";
    EXPECT_EQ(bytes_of(folder / "fields.nc"), "old");
    write_records(folder / "fields.nc", 1);
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_EQ(NetcdfContent(folder / "fields.nc").length("date"), 1U);
}

class KilledRun : public ::testing::TestWithParam<int> {};

TEST_P(KilledRun, LeavesAFileThatOpens) {
    const TemporaryFolder folder;
    const int records = GetParam();
    const pid_t child = fork();
    if (child == 0) {
        FieldsFile file(folder / "fields.nc", snapshot(0), fields_text);
        for (int i = 0; i < records; ++i) file.add(snapshot(i));
        kill(getpid(), SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    EXPECT_FALSE(std::filesystem::exists(folder / "fields.nc"));
    const NetcdfContent content(folder / "fields.nc.part");
    ASSERT_EQ(content.length("date"), static_cast<std::size_t>(records));
    const auto steps = content.values("step");
    const auto bed = content.values("bed_height");
    for (int i = 0; i < records; ++i) {
        ASSERT_EQ(steps[static_cast<std::size_t>(i)], i);
        ASSERT_EQ(bed[cell(6, 4, static_cast<std::size_t>(i))], 0.25 * height(i, 6, 4));
    }
}

INSTANTIATE_TEST_SUITE_P(AfterRecords, KilledRun, ::testing::Values(0, 1, 2, 70, 600));

/// Adds until the disk is full; what is left must be every record before.
void fill_up(const std::filesystem::path& path, const std::string& reason) {
    FieldsFile file(path, snapshot(0, 50, 50), fields_text);
    std::string message;
    for (int i = 0; i < 1000 && message.empty(); ++i)
        message = message_of<Error>([&] { file.add(snapshot(i, 50, 50)); });
    EXPECT_EQ(message.find("cannot write " + path.string() + ": " + reason +
                           "; its next record needs up to "),
              0U)
        << message;
    EXPECT_NE(message.find("free some space"), std::string::npos) << message;
    ASSERT_GE(file.records(), 1);
    const auto records = file.records();
    EXPECT_NE(message_of<Error>([&] { file.add(snapshot(0, 50, 50)); }), "") << "still full";
    file.commit();
    const NetcdfContent content(path);
    EXPECT_EQ(content.length("date"), static_cast<std::size_t>(records));
    EXPECT_EQ(content.values("step").back(), static_cast<double>(records - 1));
    EXPECT_EQ(content.values("bed_height").back(), 0.25 * height(records - 1, 49, 49));
}

TEST(NetcdfFields, AFullDiskSpoilsNothing) {
    const TemporaryFolder folder;
    const test::SmallDisk disk(folder.path(), 1024);
    if (!disk.mounted()) GTEST_SKIP() << "this user may not mount a small file system";
    fill_up(folder / "fields.nc", "No space left on device");
}

TEST(NetcdfFields, ALimitOnFilesSpoilsNothing) {
    const TemporaryFolder folder;
    const test::FileSizeLimit limit(1'000'000);
    fill_up(folder / "fields.nc", "File too large");
}

TEST(NetcdfFields, LeavesNothingWhereItCannotBegin) {
    const TemporaryFolder folder;
    const auto missing = folder / "no-such-folder/fields.nc";
    EXPECT_EQ(message_of<Error>([&] { FieldsFile(missing, snapshot(0), fields_text); }),
              "cannot write " + missing.string() + ": No such file or directory");
    EXPECT_EQ(message_of<Error>([&] { FieldsFile("/dev/null", snapshot(0), fields_text); }),
              "cannot write /dev/null: it is a pipe or a device; NetCDF needs a file on disk");
    const test::FileSizeLimit limit(10'000);
    EXPECT_NE(
        message_of<Error>([&] { FieldsFile(folder / "fields.nc", snapshot(0), fields_text); }), "");
    EXPECT_EQ(folder.entries(), 0);
}

TEST(NetcdfFields, MemoryDoesNotGrowWithTheRecords) {
#ifdef FUMON_SANITIZED
    GTEST_SKIP() << "a sanitizer keeps its own memory";
#endif
    const TemporaryFolder folder;
    const Snapshot record = snapshot(0, 32, 32);
    FieldsFile file(folder / "fields.nc", record, fields_text);
    std::size_t early = 0;
    for (int i = 0; i < 3000; ++i) {  // 24 KiB each, 72 MiB in all
        file.add(record);
        if (i == 300) early = mallinfo2().uordblks + mallinfo2().hblkhd;
    }
    const std::size_t late = mallinfo2().uordblks + mallinfo2().hblkhd;
    EXPECT_LT(late, early + (std::size_t{8} << 20));
}

}  // namespace
}  // namespace fumon
