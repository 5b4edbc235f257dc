#include "run/frame_list.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

FrameRecord frame(std::int64_t number) {
    FrameRecord frame{number, 7 * number, 0.1 * static_cast<double>(number), {}, {}};
    frame.pixels.fill(static_cast<std::uint8_t>(100 + number));
    frame.file.fill(static_cast<std::uint8_t>(200 + number));
    return frame;
}

void expect_frame(const FrameRecord& found, std::int64_t number) {
    const FrameRecord expected = frame(number);
    EXPECT_EQ(found.number, number);
    EXPECT_EQ(found.step, expected.step);
    EXPECT_EQ(found.time, expected.time);
    EXPECT_EQ(found.pixels, expected.pixels);
    EXPECT_EQ(found.file, expected.file);
}

TEST(FrameList, GivesBackWhatWasAddedWhileMoreIsAdded) {
    const ScratchFolder folder;
    const fs::path file = folder / "frames.fumon";
    FrameList list(file);
    list.add(frame(0));
    FrameListReader reader(file);
    expect_frame(reader.next(), 0);
    list.add(frame(1));
    list.commit();
    EXPECT_EQ(list.frames(), 2);
    EXPECT_EQ(list.last_step(), 7);
    FrameListReader later(file);
    for (const std::int64_t number : {0, 1}) expect_frame(later.next(), number);
    EXPECT_THROW(later.next(), InputError);
    EXPECT_EQ(fs::file_size(file), 160U);
}

TEST(FrameList, GoesOnBehindWhatWasCountedAndEndsAsIfItHadNotBeenCut) {
    const ScratchFolder folder;
    const fs::path whole = folder / "whole";
    const fs::path file = folder / "frames.fumon";
    const FrameList nowhere(std::nullopt);
    EXPECT_EQ(nowhere.last_step(), 0);
    FrameList uncut(whole);
    FrameList unlisted(std::nullopt);
    FrameCount counted;
    {
        FrameList list(file);
        for (std::int64_t number = 0; number < 5; ++number) {
            if (number == 3) counted = list.sync();
            list.add(frame(number));
        }
        list.commit();
    }
    EXPECT_EQ(counted.frames, 3);
    EXPECT_EQ(difference(file, counted), "");
    FrameList list(file, counted);
    EXPECT_EQ(difference(file, counted), "") << "under its temporary name too";
    for (std::int64_t number = 0; number < 6; ++number) {
        if (number >= 3) list.add(frame(number));
        uncut.add(frame(number));
        unlisted.add(frame(number));
    }
    EXPECT_EQ(list.pixels(), uncut.pixels());
    EXPECT_EQ(unlisted.pixels(), uncut.pixels());
    EXPECT_EQ(list.sync().hash, uncut.sync().hash);
    list.commit();
    uncut.commit();
    EXPECT_EQ(read_text(file), read_text(whole));
}

TEST(FrameList, OneThatIsDamagedOrShortIsRefused) {
    const ScratchFolder folder;
    const fs::path file = folder / "frames.fumon";
    FrameList list(file);
    for (std::int64_t number = 0; number < 4; ++number) list.add(frame(number));
    const FrameCount counted = list.sync();
    list.commit();
    const std::string bytes = read_text(file);
    for (const std::size_t at : {std::size_t{0}, std::size_t{50}, bytes.size() - 1}) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 1);
        write_text(file, damaged);
        EXPECT_EQ(difference(file, counted), "has changed since it was written");
        EXPECT_THROW(FrameList(file, counted), InputError);
    }
    write_text(file, bytes.substr(0, bytes.size() - 1));
    EXPECT_EQ(difference(file, counted), "has 319 bytes of 320");
    EXPECT_THROW(FrameList(file, counted), InputError);
    fs::remove(file);
    EXPECT_EQ(difference(file, counted), "does not exist");
    EXPECT_EQ(difference(file, FrameCount{}), "") << "no frames need no list";
}

}  // namespace
}  // namespace fumon::test
