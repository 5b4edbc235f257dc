#include "picture/movie_format.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/pixdesc.h>
}

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "picture/colour_table.h"
#include "picture/encoder_options.h"
#include "picture/movie.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::TemporaryFolder;

/// What a player makes of a file.
struct PlayedFile {
    int frames = 0;
    int width = 0;
    int height = 0;
    std::string pixels;        ///< how they are kept
    std::vector<int> keys;     ///< frames that are key frames
    double even_blocks = 0.0;  ///< share of 8 x 8 blocks of the last frame's luma without detail
};

double share_of_even_blocks(const AVFrame& frame) {
    int even = 0;
    int all = 0;
    for (int y = 0; y + 8 <= frame.height; y += 8) {
        for (int x = 0; x + 8 <= frame.width; x += 8, ++all) {
            std::array<std::uint8_t, 64> block{};
            for (int j = 0; j < 8; ++j)
                std::copy_n(frame.data[0] + (y + j) * frame.linesize[0] + x, 8,
                            block.begin() + 8 * j);
            const auto [low, high] = std::ranges::minmax(block);
            even += low == high ? 1 : 0;
        }
    }
    return all > 0 ? static_cast<double>(even) / all : 0.0;
}

PlayedFile played_file(const std::filesystem::path& file) {
    PlayedFile played;
    AVFormatContext* container = nullptr;
    if (avformat_open_input(&container, file.c_str(), nullptr, nullptr) < 0) return played;
    avformat_find_stream_info(container, nullptr);
    const AVCodecParameters& stream = *container->streams[0]->codecpar;
    AVCodecContext* codec = avcodec_alloc_context3(avcodec_find_decoder(stream.codec_id));
    avcodec_parameters_to_context(codec, &stream);
    avcodec_open2(codec, nullptr, nullptr);
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    const auto receive = [&] {
        while (avcodec_receive_frame(codec, frame) == 0) {
#ifdef AV_FRAME_FLAG_KEY
            const bool is_key = (frame->flags & AV_FRAME_FLAG_KEY) != 0;
#else
            const bool is_key = frame->key_frame != 0;
#endif
            if (is_key) played.keys.push_back(played.frames);
            ++played.frames;
            played.pixels = av_get_pix_fmt_name(static_cast<AVPixelFormat>(frame->format));
            played.even_blocks = share_of_even_blocks(*frame);
        }
    };
    while (av_read_frame(container, packet) == 0) {
        avcodec_send_packet(codec, packet);
        av_packet_unref(packet);
        receive();
    }
    avcodec_send_packet(codec, nullptr);
    receive();
    played.width = stream.width;
    played.height = stream.height;
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&codec);
    avformat_close_input(&container);
    return played;
}

/// A sky of few grey levels, dithered as the renderer does it: the same in every frame.
Image dithered_sky(int width, int height) {
    Image image(width, height);
    std::uint64_t seed = 1;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
            const double level = 180.0 + 12.0 * y / height +
                                 static_cast<double>(seed >> 40U) / static_cast<double>(1U << 24U);
            for (int c = 0; c < 3; ++c)
                image.row(y)[3 * x + c] = static_cast<std::uint8_t>(level - 30.0 + 20.0 * c);
        }
    }
    return image;
}

/// The same over rough ground, which takes most of an encoder's bits.
Image sky_over_ground(int width, int height) {
    Image image = dithered_sky(width, height);
    std::uint64_t seed = 7;
    for (int y = 2 * height / 3; y < height; ++y) {
        for (int x = 0; x < 3 * width; ++x) {
            if (x % 12 == 0) seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
            image.row(y)[x] = static_cast<std::uint8_t>(100 + (seed >> 40U) % 80);
        }
    }
    return image;
}

TEST(MovieKeys, ComeEverySecond) {
    const TemporaryFolder folder;
    Movie movie(folder / "m.mp4", 64, 48, 10.0, 18);
    for (int i = 0; i < 35; ++i) movie.add(dithered_sky(64, 48));
    movie.finish();
    EXPECT_EQ(played_file(folder / "m.mp4").keys, (std::vector<int>{0, 10, 20, 30}));
}

TEST(MovieSky, KeepsItsDither) {
    const TemporaryFolder folder;
    Movie movie(folder / "m.mp4", 480, 360, 10.0, 23);
    for (int i = 0; i < 12; ++i) movie.add(sky_over_ground(480, 360));
    movie.finish();
    // With x264's own settings 60 % of all blocks lose their detail, with ours 20 %.
    EXPECT_LT(played_file(folder / "m.mp4").even_blocks, 0.3);
}

/// Two threads of x264 that is held to a rate would give other bytes each time.
TEST(MovieRate, GivesTheSameBytesWhereItIsHeldTo) {
    const TemporaryFolder folder;
    std::string first;
    for (const char* name : {"a.mp4", "b.mp4", "c.mp4"}) {
        Movie movie(folder / name, 640, 480, 10.0, 8);
        for (std::size_t i = 0; i < 20; ++i) {
            Image image = sky_over_ground(640, 480);
            for (std::size_t n = 0; n < image.rgb.size(); ++n)
                image.rgb[n] = static_cast<std::uint8_t>(image.rgb[n] + n * (i + 3) % (7 + i));
            movie.add(image);
        }
        movie.finish();
        if (first.empty()) first = bytes_of(folder / name);
        EXPECT_EQ(bytes_of(folder / name), first) << name;
    }
}

/// The opacities of a WebM movie's first frame, which FFmpeg's own decoder of VP9 leaves out.
std::vector<std::uint8_t> opacities_of_first_frame(const std::filesystem::path& file) {
    std::vector<std::uint8_t> opacities;
    AVFormatContext* container = nullptr;
    if (avformat_open_input(&container, file.c_str(), nullptr, nullptr) < 0) return opacities;
    AVCodecContext* codec = avcodec_alloc_context3(avcodec_find_decoder_by_name("libvpx-vp9"));
    avcodec_parameters_to_context(codec, container->streams[0]->codecpar);
    avcodec_open2(codec, nullptr, nullptr);
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    while (opacities.empty() && av_read_frame(container, packet) == 0) {
        avcodec_send_packet(codec, packet);
        av_packet_unref(packet);
        if (avcodec_receive_frame(codec, frame) != 0 || frame->data[3] == nullptr) continue;
        for (int y = 0; y < frame->height; ++y)
            opacities.insert(opacities.end(), frame->data[3] + y * frame->linesize[3],
                             frame->data[3] + y * frame->linesize[3] + frame->width);
    }
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&codec);
    avformat_close_input(&container);
    return opacities;
}

TEST(MovieAlpha, IsThatOfTheFramesInWebM) {
    const TemporaryFolder folder;
    MovieCoding coding{*find_movie_format("webm"), 10};
    coding.transparent = true;
    Movie movie(folder / "m.webm", 64, 48, 10.0, coding);
    for (int i = 0; i < 5; ++i) {
        Image image = with_alpha(dithered_sky(64, 48));
        for (int y = 0; y < 48; ++y) std::fill_n(image.alpha.begin() + 64 * y, 32, std::uint8_t{0});
        movie.add(image);
    }
    movie.finish();
    const auto opacities = opacities_of_first_frame(folder / "m.webm");
    ASSERT_EQ(opacities.size(), 64U * 48U);
    EXPECT_LT(opacities[64 * 20 + 8], 8);
    EXPECT_GT(opacities[64 * 20 + 56], 247);
}

class MovieFormats : public testing::TestWithParam<std::string> {};

TEST_P(MovieFormats, PlayTheirFramesAndGiveTheSameBytes) {
    const TemporaryFolder folder;
    const MovieFormat& format = *find_movie_format(GetParam());
    const auto file = folder / ("m" + std::string(format.ending));
    const Image sky = dithered_sky(96, 64);
    ColourCounts counts;
    counts.add(sky);
    const ColourTable colours(counts);
    const auto make_one = [&] {
        Movie movie(file, 96, 64, 10.0, {format, 18, format.name == "gif" ? &colours : nullptr});
        for (int i = 0; i < 12; ++i) {
            Image image = sky;
            std::fill_n(image.row(4 * i), 3 * 40, std::uint8_t{0});
            movie.add(image);
        }
        movie.finish({{"Title", "a"}});
    };
    make_one();
    EXPECT_EQ(folder.entries(), 1);
    const std::string bytes = bytes_of(file);
    make_one();
    EXPECT_EQ(bytes_of(file), bytes);
    if (format.name == "webp") {  // which this libavcodec writes and does not read
        EXPECT_EQ(bytes.substr(8, 4), "WEBP");
        std::size_t frames = 0;
        for (std::size_t at = bytes.find("ANMF"); at != std::string::npos;
             at = bytes.find("ANMF", at + 1))
            ++frames;
        EXPECT_EQ(frames, 12U);
        return;
    }
    const PlayedFile played = played_file(file);
    EXPECT_EQ(played.frames, 12);
    EXPECT_EQ(played.width, 96);
    EXPECT_EQ(played.height, 64);
    const std::string kept = format.name == "gif"      ? "bgra"
                             : format.name == "prores" ? "yuva444p12le"
                                                       : std::string(format.pixels);
    EXPECT_EQ(played.pixels, kept);
    if (format.name == "prores") {
        constexpr std::string_view bt709("\1\1\1", 3);  // primaries, curve, matrix
        std::size_t headers = 0;
        for (std::size_t at = bytes.find("icpf"); at != std::string::npos;
             at = bytes.find("icpf", at + 1), ++headers)
            EXPECT_EQ(bytes.substr(at + 18, 3), bt709) << headers;
        EXPECT_GE(headers, 12U);
    }
    if (format.ending != ".mp4" && format.name != "webm") return;
    ASSERT_GE(played.keys.size(), 2U);
    EXPECT_LE(played.keys[1], 10);
}

INSTANTIATE_TEST_SUITE_P(All, MovieFormats,
                         testing::Values("h264", "hevc", "av1", "webm", "prores", "ffv1", "webp",
                                         "gif", "apng"),
                         [](const auto& one) { return one.param; });

// What plays from a slide: at most the 25 Mbit/s of High 4.0 at 1080p.
TEST(MovieFormats, H264TakesNoMoreBitsThanItsLevelAllows) {
    EXPECT_EQ(h264_kilobits({1920, 1080, 30.0}, 18), 16000);
    EXPECT_EQ(h264_kilobits({1080, 1920, 30.0}, 24), 8000);
    EXPECT_EQ(h264_kilobits({3840, 2160, 30.0}, 18), 45255);  // 16,000 times 4 to the power 3/4
    EXPECT_EQ(h264_kilobits({64, 48, 10.0}, 18), 2000);

    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "noise.mp4";
    constexpr int frames = 60;
    {
        Movie movie(file, 320, 240, 30.0, MovieCoding{*find_movie_format("h264"), 1});
        std::uint32_t state = 1;
        for (int frame = 0; frame < frames; ++frame) {
            Image image(320, 240);
            for (std::uint8_t& value : image.rgb) {
                state = state * 1664525U + 1013904223U;
                value = static_cast<std::uint8_t>(state >> 24U);
            }
            movie.add(image);
        }
        movie.finish({});
    }
    const double most = 1000.0 * h264_kilobits({320, 240, 30.0}, 1);
    const double seconds = frames / 30.0;
    const double bits = 8.0 * static_cast<double>(std::filesystem::file_size(file));
    EXPECT_LT(bits, most * (seconds + 1.0)) << "a second more is in the decoder's buffer";
    EXPECT_GT(bits, 0.5 * most * seconds) << "noise takes what it may";
}

TEST(ColourTable, KeepsFewColoursAsTheyAreAndManyNearby) {
    Image few(64, 64);
    for (int y = 0; y < 64; ++y)
        std::fill_n(few.row(y), 3 * 64, static_cast<std::uint8_t>(y < 32 ? 20 : 220));
    ColourCounts counts;
    counts.add(few);
    const ColourTable two(counts);
    const auto level = [](std::uint32_t colour) { return static_cast<int>(colour & 255U); };
    const auto indices = two.indices(few);
    EXPECT_NEAR(level(two.colours().at(indices.front())), 20, 4);
    EXPECT_NEAR(level(two.colours().at(indices.back())), 220, 4);

    const Image sky = dithered_sky(128, 128);
    ColourCounts of_sky;
    of_sky.add(sky);
    const ColourTable table(of_sky);
    const auto places = table.indices(sky);
    double shown = 0.0;
    double meant = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        shown += level(table.colours().at(places[i]));
        meant += sky.rgb[3 * i + 2];
    }
    EXPECT_NEAR(shown / static_cast<double>(places.size()),
                meant / static_cast<double>(places.size()), 4.0);
}

TEST(MovieFormats, KeepAlphaWhereTheyCan) {
    const TemporaryFolder folder;
    Image open = with_alpha(dithered_sky(96, 64));
    for (std::size_t i = 0; i < open.alpha.size() / 2; ++i) open.alpha[i] = 0;
    for (const MovieFormat& format : movie_formats()) {
        // Which FFmpeg's own decoders leave out, or do not read.
        if (format.name == "gif" || format.name == "webp" || format.name == "webm") continue;
        const auto file = folder / (std::string(format.name) + std::string(format.ending));
        Movie movie(file, 96, 64, 10.0, {format, 18, nullptr, true});
        for (int i = 0; i < 3; ++i) movie.add(open);
        movie.finish();
        const std::string pixels = played_file(file).pixels;
        const bool alpha = pixels.find('a') != std::string::npos;
        EXPECT_EQ(alpha, !format.open_pixels.empty()) << format.name << " " << pixels;
    }
    Movie movie(folder / "w.webp", 96, 64, 10.0, {*find_movie_format("webp"), 18, nullptr, true});
    movie.add(open);
    movie.finish();
    EXPECT_NE(bytes_of(folder / "w.webp").find("ALPH"), std::string::npos);
}

TEST(GrowingMovie, PlaysWhileItIsMade) {
    const TemporaryFolder folder;
    Movie movie(folder / "m.mp4", 96, 64, 5.0,
                {movie_formats().front(), 18, nullptr, false, folder / "so-far.mp4"});
    Image image = dithered_sky(96, 64);
    int played = 0;
    for (int i = 0; i < 80 && played == 0; ++i) {
        std::fill_n(image.row(i % 64), 3 * 40, std::uint8_t{0});
        movie.add(image);
        played = played_file(folder / "so-far.mp4").frames;
    }
    EXPECT_GE(played, 5) << "a second at least, before the movie is finished";
    EXPECT_FALSE(std::filesystem::exists(folder / "m.mp4"));
    const std::string whole = [&] {
        movie.finish();
        return bytes_of(folder / "m.mp4");
    }();
    EXPECT_FALSE(whole.empty());
}

}  // namespace
}  // namespace fumon
