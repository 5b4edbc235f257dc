#include "files/atomic_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/error.h"
#include "support/full_disk.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::message_of;
using test::TemporaryFolder;

TEST(AtomicFile, BearsItsNameOnlyOnceComplete) {
    const TemporaryFolder folder;
    AtomicFile file(folder / "a.csv");
    file.write("step,");
    file.write(std::string_view("time\n"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
    EXPECT_TRUE(std::filesystem::exists(folder / "a.csv.part"));
    file.commit();
    EXPECT_EQ(bytes_of(folder / "a.csv"), "step,time\n");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, LeavesNothingWhenNotCommitted) {
    const TemporaryFolder folder;
    { AtomicFile(folder / "a.csv").write("half"); }
    EXPECT_EQ(folder.entries(), 0);
}

TEST(AtomicFile, AFailedWriteLeavesWhatWasThereBefore) {
    const TemporaryFolder folder;
    AtomicFile file(folder / "a.csv");
    file.write("whole row\n");
    {
        const test::FileSizeLimit limit(14);
        EXPECT_THROW(file.write("another row\n"), Error);
    }
    file.write("last\n");
    file.commit();
    EXPECT_EQ(bytes_of(folder / "a.csv"), "whole row\nlast\n");
}

TEST(AtomicFile, KeepsTheOldFileUntilTheNewOneIsComplete) {
    const TemporaryFolder folder;
    folder.file("a.csv", "old");
    { AtomicFile(folder / "a.csv").write("half"); }
    EXPECT_EQ(bytes_of(folder / "a.csv"), "old");
    write_file(folder / "a.csv", "new");
    EXPECT_EQ(bytes_of(folder / "a.csv"), "new");
}

TEST(AtomicFile, ReplacesWhatAnInterruptedRunLeft) {
    const TemporaryFolder folder;
    folder.file("a.csv.part", "a long left-over text");
    write_file(folder / "a.csv", "new");
    EXPECT_EQ(bytes_of(folder / "a.csv"), "new");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, WritesThroughALink) {
    const TemporaryFolder folder;
    folder.file("target", "old");
    std::filesystem::create_symlink("target", folder / "link");
    write_file(folder / "link", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(bytes_of(folder / "target"), "new");
}

TEST(AtomicFile, WritesEveryByte) {
    const TemporaryFolder folder;
    std::vector<std::uint8_t> bytes(3'000'001);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7);
    write_file(folder / "a.bin", bytes);
    EXPECT_EQ(bytes_of(folder / "a.bin"), std::string(bytes.begin(), bytes.end()));
}

TEST(AtomicFile, NamesFileAndReasonWhereItCannotBegin) {
    const TemporaryFolder folder;
    const auto missing = folder / "no-such-folder/a.csv";
    EXPECT_EQ(message_of<Error>([&] { write_file(missing, "x"); }),
              "cannot write " + missing.string() + ": No such file or directory");
    EXPECT_EQ(message_of<Error>([&] { write_file(folder.path(), "x"); }),
              "cannot write " + folder.path().string() + ": Is a directory");
}

TEST(AtomicFile, SaysThatADeviceIsFull) {
    EXPECT_EQ(message_of<Error>([&] { write_file("/dev/full", "x"); }),
              "cannot write /dev/full: No space left on device");
    EXPECT_FALSE(std::filesystem::exists("/dev/full.part"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(AtomicFile, LeavesNothingWhenAWriteFails) {
    const TemporaryFolder folder;
    const test::FileSizeLimit limit(10'000);
    EXPECT_EQ(message_of<Error>([&] { write_file(folder / "x.png", std::string(20'000, 'x')); }),
              "cannot write " + (folder / "x.png").string() + ": File too large");
    EXPECT_EQ(folder.entries(), 0);
}

TEST(AtomicFile, LeavesNothingOnAFullDisk) {
    const TemporaryFolder folder;
    const test::SmallDisk disk(folder.path());
    if (!disk.mounted()) GTEST_SKIP() << "this user may not mount a small file system";
    EXPECT_EQ(message_of<Error>([&] { write_file(folder / "x.png", std::string(200'000, 'x')); }),
              "cannot write " + (folder / "x.png").string() + ": No space left on device");
    EXPECT_EQ(folder.entries(), 0);
}

TEST(AtomicFile, GoesOnWithWhatAKilledOrStoppedRunLeft) {
    const TemporaryFolder folder;
    for (const char* left : {"a.csv.part", "a.csv"}) {
        folder.file(left, "1\n2\n3\nhalf a li");
        AtomicFile file(folder / "a.csv", 6);
        EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
        EXPECT_EQ(file.length(), 6);
        file.write("4\n");
        file.sync();
        EXPECT_EQ(bytes_of(folder / "a.csv.part"), "1\n2\n3\n4\n");
        file.commit();
        EXPECT_EQ(bytes_of(folder / "a.csv"), "1\n2\n3\n4\n");
        EXPECT_EQ(folder.entries(), 1);
        std::filesystem::remove(folder / "a.csv");
    }
}

TEST(AtomicFile, OneThatGoesOnIsKeptAndRefusedWhereItIsTooShort) {
    const TemporaryFolder folder;
    folder.file("a.csv.part", "1\n2\n");
    { const AtomicFile uncommitted(folder / "a.csv", 2); }
    EXPECT_EQ(bytes_of(folder / "a.csv.part"), "1\n");
    EXPECT_NE(message_of<InputError>([&] {
                  AtomicFile(folder / "a.csv", 3);
              }).find("a.csv.part: cannot be continued: it has 2 bytes of 3"),
              std::string::npos);
    EXPECT_NE(message_of<InputError>([&] {
                  AtomicFile(folder / "b.csv", 0);
              }).find("No such file or directory"),
              std::string::npos);
    EXPECT_EQ(folder.entries(), 1);
}

}  // namespace
}  // namespace fumon
