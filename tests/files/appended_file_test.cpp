#include "files/appended_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "files/hash.h"
#include "support/full_disk.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::message_of;
using test::TemporaryFolder;

TEST(AppendedFile, KnowsItsHashAndGoesOnBehindIt) {
    const TemporaryFolder folder;
    AppendedFile whole(folder / "whole.csv");
    whole.write("1\n2\n");
    const FileBeginning beginning = whole.sync();
    EXPECT_EQ(beginning.length, 4);
    EXPECT_EQ(beginning.hash, text_hash("1\n2\n"));
    whole.write("3\n");
    for (const char* left : {"a.csv.part", "a.csv"}) {
        folder.file(left, "1\n2\nhalf a li");
        EXPECT_EQ(surviving_file(folder / "a.csv"), folder / left);
        EXPECT_EQ(difference(folder / "a.csv", beginning), "");
        AppendedFile file(folder / "a.csv", beginning);
        EXPECT_EQ(file.sync().hash, beginning.hash);
        file.write("3\n");
        EXPECT_EQ(file.sync().hash, whole.sync().hash);
        file.commit();
        EXPECT_EQ(bytes_of(folder / "a.csv"), "1\n2\n3\n");
        std::filesystem::remove(folder / "a.csv");
    }
}

TEST(AppendedFile, RefusesABeginningThatIsNotTheFormerOneAndLeavesIt) {
    const TemporaryFolder folder;
    const FileBeginning beginning{4, text_hash("1\n2\n")};
    const auto expect_refusal = [&](const std::string& why) {
        EXPECT_EQ(difference(folder / "a.csv", beginning), why);
        EXPECT_EQ(message_of<InputError>([&] { AppendedFile(folder / "a.csv", beginning); }),
                  (folder / "a.csv").string() + ": cannot be continued: it " + why);
    };
    expect_refusal("does not exist");
    for (const char* text : {"1\n3\n", "0\n2\n and more"}) {
        folder.file("a.csv", text);
        expect_refusal("has changed since it was written");
        EXPECT_EQ(bytes_of(folder / "a.csv"), text);
    }
    folder.file("a.csv", "1\n");
    expect_refusal("has 2 bytes of 4");
    std::filesystem::remove(folder / "a.csv");
    std::filesystem::create_directory(folder / "a.csv");
    expect_refusal("is not a file");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(AppendedFile, WhatItPutOnDiskStaysThereWithoutACommit) {
    const TemporaryFolder folder;
    FileBeginning there;
    {
        AppendedFile file(folder / "a.csv");
        file.write("step\n");
        there = file.sync();
    }
    EXPECT_EQ(difference(folder / "a.csv", there), "");
    { AppendedFile file(folder / "b.csv"); }
    EXPECT_FALSE(std::filesystem::exists(folder / "b.csv.part"));
}

TEST(AppendedFile, AWriteThatFailsIsNotInItsHash) {
    const TemporaryFolder folder;
    AppendedFile file(folder / "a.csv");
    file.write("1\n");
    const test::FileSizeLimit limit(1000);
    EXPECT_THROW(file.write(std::string(5000, 'x')), Error);
    const FileBeginning beginning = file.sync();
    EXPECT_EQ(beginning.length, 2);
    EXPECT_EQ(beginning.hash, text_hash("1\n"));
}

}  // namespace
}  // namespace fumon
