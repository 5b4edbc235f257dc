#include "picture/movie.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.h"
#include "support/full_disk.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::message_of;
using test::TemporaryFolder;

using Colour = std::array<std::uint8_t, 3>;

Image plain(int width, int height, Colour colour) {
    Image image(width, height);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = colour[i % 3];
    return image;
}

/// Noise that no encoder can make small (a linear congruential generator, Knuth's constants).
Image noise(int width, int height, std::uint64_t seed) {
    Image image(width, height);
    for (std::uint8_t& value : image.rgb) {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        value = static_cast<std::uint8_t>(seed >> 56U);
    }
    return image;
}

/// What a player makes of a movie.
struct Played {
    int frames = 0;
    int width = 0;
    int height = 0;
    double rate = 0.0;
    double seconds = 0.0;
    std::array<int, 4> tags{};                ///< matrix, primaries, transfer, range
    std::vector<std::array<int, 3>> centres;  ///< Y, Cb, Cr in the middle of each frame
    std::array<int, 3> last_corner{};         ///< of the last frame, bottom right
};

std::array<int, 3> sample(const AVFrame& frame, int x, int y) {
    return {frame.data[0][y * frame.linesize[0] + x],
            frame.data[1][y / 2 * frame.linesize[1] + x / 2],
            frame.data[2][y / 2 * frame.linesize[2] + x / 2]};
}

Played play(const std::filesystem::path& file) {
    Played played;
    AVFormatContext* container = nullptr;
    if (avformat_open_input(&container, file.c_str(), nullptr, nullptr) < 0) return played;
    avformat_find_stream_info(container, nullptr);
    AVStream& stream = *container->streams[0];
    AVCodecContext* codec = avcodec_alloc_context3(avcodec_find_decoder(stream.codecpar->codec_id));
    avcodec_parameters_to_context(codec, stream.codecpar);
    avcodec_open2(codec, nullptr, nullptr);
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    const auto receive = [&] {
        while (avcodec_receive_frame(codec, frame) == 0) {
            ++played.frames;
            played.centres.push_back(sample(*frame, frame->width / 2, frame->height / 2));
            played.last_corner = sample(*frame, frame->width - 1, frame->height - 1);
            played.tags = {frame->colorspace, frame->color_primaries, frame->color_trc,
                           frame->color_range};
        }
    };
    while (av_read_frame(container, packet) == 0) {
        avcodec_send_packet(codec, packet);
        av_packet_unref(packet);
        receive();
    }
    avcodec_send_packet(codec, nullptr);
    receive();
    played.width = stream.codecpar->width;
    played.height = stream.codecpar->height;
    played.rate = av_q2d(stream.avg_frame_rate);
    played.seconds = static_cast<double>(stream.duration) * av_q2d(stream.time_base);
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&codec);
    avformat_close_input(&container);
    return played;
}

/// ITU-R BT.709-6, limited range, 8 bits.
std::array<double, 3> bt709(Colour colour) {
    const double r = colour[0] / 255.0;
    const double g = colour[1] / 255.0;
    const double b = colour[2] / 255.0;
    const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    return {16.0 + 219.0 * y, 128.0 + 224.0 * (b - y) / 1.8556, 128.0 + 224.0 * (r - y) / 1.5748};
}

void make(const std::filesystem::path& file, int width, int height, int frames,
          double rate = 30.0) {
    Movie movie(file, width, height, rate, 18);
    for (int i = 0; i < frames; ++i) movie.add(noise(width, height, static_cast<std::uint64_t>(i)));
    movie.finish();
}

TEST(Movie, PlaysBackWithItsColours) {
    const TemporaryFolder folder;
    const std::vector<Colour> colours{{255, 255, 255}, {0, 0, 0},      {255, 0, 0},
                                      {0, 255, 0},     {0, 0, 255},    {194, 160, 110},
                                      {90, 120, 200},  {128, 128, 128}};
    Movie movie(folder / "m.mp4", 64, 48, 30.0, 10);
    for (const Colour& colour : colours) movie.add(plain(64, 48, colour));
    movie.finish();
    EXPECT_EQ(folder.entries(), 1);

    const Played played = play(folder / "m.mp4");
    ASSERT_EQ(played.frames, 8);
    EXPECT_EQ(played.width, 64);
    EXPECT_EQ(played.height, 48);
    EXPECT_DOUBLE_EQ(played.rate, 30.0);
    EXPECT_NEAR(played.seconds, 8.0 / 30.0, 1e-4);
    EXPECT_EQ(played.tags, (std::array<int, 4>{AVCOL_SPC_BT709, AVCOL_PRI_BT709, AVCOL_TRC_BT709,
                                               AVCOL_RANGE_MPEG}));
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const auto expected = bt709(colours[i]);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(played.centres[i][c], expected[c], 2.0) << "frame " << i << " part " << c;
    }
}

TEST(Movie, TakesItsQuality) {
    const TemporaryFolder folder;
    const auto size = [&](int quality) {
        Movie movie(folder / "m.mp4", 64, 48, 30.0, quality);
        for (std::uint64_t i = 0; i < 3; ++i) movie.add(noise(64, 48, i));
        movie.finish();
        return std::filesystem::file_size(folder / "m.mp4");
    };
    const auto fine = size(0);
    EXPECT_GT(fine, 2 * size(30));
    EXPECT_GT(size(30), size(51));
}

TEST(Movie, StartsWithItsIndex) {
    const TemporaryFolder folder;
    make(folder / "m.mp4", 64, 48, 5);
    const std::string bytes = bytes_of(folder / "m.mp4");
    ASSERT_NE(bytes.find("moov"), std::string::npos);
    EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(Movie, SameFramesGiveTheSameBytesWithoutClockOrVersions) {
    const TemporaryFolder folder;
    make(folder / "a.mp4", 128, 96, 12);
    make(folder / "b.mp4", 128, 96, 12);
    const std::string bytes = bytes_of(folder / "a.mp4");
    EXPECT_EQ(bytes, bytes_of(folder / "b.mp4"));
    for (const std::string_view version : {"x264", "Lavf", "Lavc"})
        EXPECT_EQ(bytes.find(version), std::string::npos) << version;
    const std::string creation_time = bytes.substr(bytes.find("mvhd") + 8, 8);
    EXPECT_EQ(creation_time, std::string(8, '\0'));
}

TEST(Movie, PadsOddSizesByRepeatingTheEdge) {
    const TemporaryFolder folder;
    Image image = plain(33, 17, {0, 0, 255});
    for (int x = 0; x < 33; ++x) image.row(16)[3 * x] = 255;
    for (int y = 0; y < 17; ++y) image.row(y)[3 * 32] = 255;
    Movie movie(folder / "m.mp4", 33, 17, 30.0, 1);
    EXPECT_EQ(movie.padded_width(), 34);
    EXPECT_EQ(movie.padded_height(), 18);
    movie.add(image);
    movie.finish();
    const Played played = play(folder / "m.mp4");
    EXPECT_EQ(played.width, 34);
    EXPECT_EQ(played.height, 18);
    const auto magenta = bt709({255, 0, 255});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(played.last_corner[c], magenta[c], 8.0) << c;
}

TEST(Movie, TakesTheSmallestSizeAndASingleFrame) {
    const TemporaryFolder folder;
    make(folder / "m.mp4", 16, 16, 1);
    const Played played = play(folder / "m.mp4");
    EXPECT_EQ(played.frames, 1);
    EXPECT_NEAR(played.seconds, 1.0 / 30.0, 1e-4);
}

TEST(Movie, KeepsBroadcastRates) {
    const TemporaryFolder folder;
    make(folder / "m.mp4", 32, 32, 7, 23.976);
    const Played played = play(folder / "m.mp4");
    EXPECT_EQ(played.frames, 7);
    EXPECT_DOUBLE_EQ(played.rate, 24000.0 / 1001.0);
}

TEST(Movie, LeavesNothingWithoutFrames) {
    const TemporaryFolder folder;
    make(folder / "m.mp4", 32, 32, 0);
    EXPECT_EQ(folder.entries(), 0);
}

TEST(Movie, LeavesNothingUnlessFinished) {
    const TemporaryFolder folder;
    folder.file("m.mp4", "an older one");
    {
        Movie movie(folder / "m.mp4", 32, 32, 30.0, 18);
        movie.add(noise(32, 32, 1));
        EXPECT_TRUE(std::filesystem::exists(folder / "m.mp4.part"));
    }
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_EQ(bytes_of(folder / "m.mp4"), "an older one");
}

TEST(Movie, TakesNamesWithColonsAndPercents) {
    const TemporaryFolder folder;
    make(folder / "pipe:1 %d 風.mp4", 32, 32, 2);
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_TRUE(std::filesystem::exists(folder / "pipe:1 %d 風.mp4"));
}

TEST(Movie, RefusesAFrameOfAnotherSize) {
    const TemporaryFolder folder;
    Movie movie(folder / "m.mp4", 32, 32, 30.0, 18);
    EXPECT_EQ(message_of<Error>([&] { movie.add(Image(33, 32)); }),
              "cannot write " + (folder / "m.mp4").string() +
                  ": a frame has 33 × 32 pixels, the movie 32 × 32");
}

TEST(Movie, NamesFileAndReasonWhereItCannotBegin) {
    const TemporaryFolder folder;
    const auto missing = folder / "none/m.mp4";
    EXPECT_EQ(message_of<Error>([&] { Movie(missing, 32, 32, 30.0, 18); }),
              "cannot write " + missing.string() + ": No such file or directory");
    EXPECT_EQ(message_of<Error>([&] { Movie(folder.path(), 32, 32, 30.0, 18); }),
              "cannot write " + folder.path().string() + ": Is a directory");
    EXPECT_FALSE(std::filesystem::exists(folder.path().string() + ".part"));
    EXPECT_THROW(Movie(folder / "m.mp4", 0, 32, 30.0, 18), Error);
    EXPECT_THROW(Movie(folder / "m.mp4", 32, 32, 0.0, 18), Error);
    EXPECT_EQ(folder.entries(), 0);
}

/// Adds noise until a write fails, tries to finish nevertheless, and returns the first message.
std::string fill_up(const std::filesystem::path& file) {
    Movie movie(file, 128, 128, 30.0, 1);
    std::string message = message_of<Error>([&] {
        for (std::uint64_t i = 0; i < 60; ++i) movie.add(noise(128, 128, i));
        movie.finish();
    });
    EXPECT_THROW(movie.finish(), Error);
    return message;
}

TEST(Movie, LeavesNothingWhenAWriteFails) {
    const TemporaryFolder folder;
    const test::FileSizeLimit limit(100'000);
    EXPECT_EQ(fill_up(folder / "m.mp4"),
              "cannot write " + (folder / "m.mp4").string() + ": File too large");
    EXPECT_EQ(folder.entries(), 0);
}

TEST(Movie, LeavesNothingOnAFullDisk) {
    const TemporaryFolder folder;
    const test::SmallDisk disk(folder.path());
    if (!disk.mounted()) GTEST_SKIP() << "this user may not mount a small file system";
    EXPECT_EQ(fill_up(folder / "m.mp4"),
              "cannot write " + (folder / "m.mp4").string() + ": No space left on device");
    EXPECT_EQ(folder.entries(), 0);
}

// The index is moved to the front only in the end: that must not fail silently either.
TEST(Movie, SaysWhenOnlyTheEndDoesNotFit) {
    const TemporaryFolder folder;
    make(folder / "whole.mp4", 128, 128, 20);
    const auto whole = std::filesystem::file_size(folder / "whole.mp4");
    for (const std::uintmax_t missing : {1U, 100U, 400U, 1000U}) {
        const test::FileSizeLimit limit(whole - missing);
        EXPECT_THROW(make(folder / "m.mp4", 128, 128, 20), Error) << missing;
        EXPECT_EQ(folder.entries(), 1) << missing;
    }
    make(folder / "m.mp4", 128, 128, 20);
    EXPECT_EQ(folder.entries(), 2);
}

}  // namespace
}  // namespace fumon
