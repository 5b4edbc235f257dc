#include "files/checkpoint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <sstream>

#include "base/error.h"
#include "support/full_disk.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::message_of;
using test::TemporaryFolder;

/// One of every kind of entry.
struct Contents {
    std::vector<double> field{1.5, -0.0, std::numeric_limits<double>::infinity(), 5e-324};
    std::vector<std::int64_t> counts{-3, std::numeric_limits<std::int64_t>::max()};
    std::vector<double> empty;
    std::string scene = "title = \"風紋\"\n";
    std::int64_t step = 12;
    bool steady = true;

    void serialise(StateArchive& archive) {
        archive.text("scene", scene);
        archive.count("step", step);
        archive.value("steady", steady);
        archive.values("field", std::span(field));
        archive.list("counts", counts);
        archive.list("empty", empty);
    }
};

std::string written(const TemporaryFolder& folder) {
    Contents contents;
    CheckpointWriter writer(folder / "checkpoint");
    contents.serialise(writer);
    writer.commit();
    return bytes_of(folder / "checkpoint");
}

void read(const std::string& bytes, Contents& contents) {
    CheckpointReader reader(std::make_unique<std::istringstream>(bytes), "c");
    contents.serialise(reader);
    reader.finish();
}

std::string checkpoint_refusal(const std::string& bytes) {
    return message_of<InputError>([&] {
        Contents contents;
        read(bytes, contents);
    });
}

TEST(Checkpoint, GivesBackWhatWasWrittenBitForBit) {
    const TemporaryFolder folder;
    const std::string bytes = written(folder);
    EXPECT_EQ(folder.entries(), 1) << "nothing temporary is left";
    Contents contents;
    contents.field.assign(4, 7.0);
    contents.counts = {};
    contents.empty = {1.0};
    contents.scene = contents.scene + "x";
    contents.step = 0;
    contents.steady = false;
    read(bytes, contents);
    const Contents expected;
    EXPECT_EQ(contents.field, expected.field);
    EXPECT_TRUE(std::signbit(contents.field[1]));
    EXPECT_EQ(contents.counts, expected.counts);
    EXPECT_TRUE(contents.empty.empty());
    EXPECT_EQ(contents.scene, expected.scene);
    EXPECT_EQ(contents.step, 12);
    EXPECT_TRUE(contents.steady);
}

TEST(Checkpoint, ADamagedByteAnywhereIsNoticed) {
    const TemporaryFolder folder;
    const std::string whole = written(folder);
    ASSERT_EQ(checkpoint_refusal(whole), "");
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (const int bit : {0, 3, 7}) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            EXPECT_NE(checkpoint_refusal(damaged), "") << "byte " << at << ", bit " << bit;
        }
    }
}

TEST(Checkpoint, ACutOrLongerFileIsNoticed) {
    const TemporaryFolder folder;
    const std::string whole = written(folder);
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(checkpoint_refusal(whole.substr(0, size)), "") << size;
    EXPECT_NE(checkpoint_refusal(whole + '\0'), "");
    EXPECT_NE(checkpoint_refusal(whole + whole), "");
}

TEST(Checkpoint, TheRefusalSaysWhatIsWrong) {
    const TemporaryFolder folder;
    const std::string whole = written(folder);
    const std::string remedy =
        "; take an untouched copy of it, or run the scene from its start with --force";
    EXPECT_EQ(checkpoint_refusal("[model]\nname = \"sand\"\n"),
              "c: is not a checkpoint of fumon" + remedy);
    EXPECT_EQ(checkpoint_refusal(""), "c: is not a checkpoint of fumon" + remedy);
    EXPECT_EQ(checkpoint_refusal(whole.substr(0, 20)), "c: is cut short" + remedy);
    EXPECT_EQ(checkpoint_refusal(whole.substr(0, whole.size() - 1)),
              "c: is cut short or damaged" + remedy);
    std::string other = whole;
    other[checkpoint_magic.size()] = 9;
    EXPECT_EQ(
        checkpoint_refusal(other),
        "c: has format 9, but this fumon reads format 3; resume with the version that wrote it");
    other = whole;
    other[40] = static_cast<char>(other[40] ^ 1);
    EXPECT_EQ(checkpoint_refusal(other), "c: is damaged: its SHA-256 does not match" + remedy);
    EXPECT_NE(
        message_of<InputError>([&] { open_checkpoint(folder / "none"); }).find("cannot be read"),
        std::string::npos);
    EXPECT_NE(
        message_of<InputError>([&] { open_checkpoint(folder.path()); }).find("cannot be read"),
        std::string::npos);
}

TEST(Checkpoint, WhatIsAskedForMustBeThere) {
    const TemporaryFolder folder;
    const std::string whole = written(folder);
    const auto ask = [&](auto question) {
        return message_of<InputError>([&] {
            CheckpointReader reader(std::make_unique<std::istringstream>(whole), "c");
            question(reader);
        });
    };
    std::string text;
    std::int64_t number = 0;
    std::vector<double> list;
    EXPECT_NE(ask([&](CheckpointReader& c) {
                  c.text("title", text);
              }).find("holds \"scene\" where \"title\" was expected"),
              std::string::npos);
    EXPECT_NE(ask([&](CheckpointReader& c) { c.list("scene", list); }).find("holds \"scene\""),
              std::string::npos)
        << "of another kind";
    EXPECT_NE(ask([&](CheckpointReader& c) {
                  c.text("scene", text);
                  c.finish();
              }).find("has unexpected data"),
              std::string::npos);
    Contents shorter;
    shorter.field.resize(3);
    EXPECT_NE(ask([&](CheckpointReader& c) {
                  shorter.serialise(c);
              }).find("its field has a different size"),
              std::string::npos);
    EXPECT_NE(ask([&](CheckpointReader& c) {
                  Contents contents;
                  contents.serialise(c);
                  c.value("more", number);
              }).find("is cut short"),
              std::string::npos);
}

TEST(Checkpoint, AFullDiskLeavesTheFormerOne) {
    const TemporaryFolder folder;
    const std::string previous = written(folder);
    {
        const test::FileSizeLimit limit(1000);
        EXPECT_THROW(
            {
                CheckpointWriter writer(folder / "checkpoint");
                std::vector<double> large(1'000'000, 1.0);
                writer.list("large", large);
                writer.commit();
            },
            Error);
    }
    EXPECT_EQ(bytes_of(folder / "checkpoint"), previous);
    EXPECT_EQ(folder.entries(), 1) << "the failed one is gone";
}

}  // namespace
}  // namespace fumon
