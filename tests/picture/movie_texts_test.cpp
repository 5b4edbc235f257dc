#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "picture/movie.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::message_of;
using test::TemporaryFolder;

std::string big_endian(std::size_t number) {
    std::string bytes;
    for (unsigned shift = 24; shift < 32; shift -= 8)
        bytes += static_cast<char>(number >> shift & 0xFFU);
    return bytes;
}

std::string box(const std::string& type, const std::string& content) {
    return big_endian(content.size() + 8) + type + content;
}

const std::string zeros(8, '\0');

/// A movie's head with one text.
std::string head(const std::string& keyword, const std::string& number, const std::string& text) {
    const std::string keys = box("keys", zeros + box("mdta", keyword));
    const std::string data = box("data", big_endian(1) + big_endian(0) + text);
    const std::string list = box("ilst", box(number, data));
    const std::string meta = box("meta", big_endian(0) + box("hdlr", zeros) + keys + list);
    return box("ftyp", "isom") + box("free", "") +
           box("moov", box("mvhd", zeros) + box("udta", meta));
}

PictureText texts_of(const TemporaryFolder& folder, const std::string& bytes) {
    return read_movie_texts(folder.file("m.mp4", bytes));
}

TEST(MovieTexts, AreThoseThatTheMovieWasGiven) {
    const TemporaryFolder folder;
    const PictureText texts{{"Title", "風紋"}, {"fumon:scene", "a\nb = \"c\"\n"}, {"empty", ""}};
    Movie movie(folder / "m.mp4", 16, 16, 30.0, 18);
    movie.add(Image(16, 16));
    movie.finish(texts);
    EXPECT_TRUE(is_movie(folder / "m.mp4"));
    EXPECT_EQ(read_movie_texts(folder / "m.mp4"), texts);
    const std::string whole = bytes_of(folder / "m.mp4");
    const std::size_t pixels = whole.find("mdat");
    EXPECT_EQ(texts_of(folder, whole.substr(0, pixels)), texts);
}

TEST(MovieTexts, OtherMoviesHaveNone) {
    const TemporaryFolder folder;
    EXPECT_TRUE(texts_of(folder, box("ftyp", "isom") + box("moov", "")).empty());
    EXPECT_TRUE(texts_of(folder, box("moov", box("udta", box("name", "a")))).empty());
    EXPECT_TRUE(texts_of(folder, box("moov", box("udta", box("meta", zeros.substr(4))))).empty());
    EXPECT_EQ(texts_of(folder, head("a", big_endian(1), "b")), (PictureText{{"a", "b"}}));
    EXPECT_TRUE(texts_of(folder, head("a", big_endian(1), "\xFF")).empty());
}

TEST(MovieTexts, ABoxMayHaveALongSizeOrGoToTheEnd) {
    const TemporaryFolder folder;
    const std::string long_box = big_endian(1) + "free" + big_endian(0) + big_endian(20) + "four";
    const std::string moov = head("a", big_endian(1), "b");
    EXPECT_EQ(texts_of(folder, long_box + moov), (PictureText{{"a", "b"}}));
    EXPECT_EQ(texts_of(folder, big_endian(0) + "moov" + moov.substr(moov.find("moov") + 4)),
              (PictureText{{"a", "b"}}));
}

TEST(MovieTexts, DamagedOnesAreRefusedWhateverSizesTheySay) {
    const TemporaryFolder folder;
    const std::string whole = head("key", big_endian(1), "text");
    const auto refusal = [&](const std::string& bytes) {
        return message_of<InputError>([&] { texts_of(folder, bytes); });
    };
    EXPECT_EQ(refusal(whole.substr(0, whole.find("moov"))),
              (folder / "m.mp4").string() +
                  ": is not an MP4 movie or is damaged (it has no header); take an untouched copy");
    for (const char* type : {"moov", "mvhd", "udta", "meta", "keys", "mdta", "data"}) {
        for (const std::size_t size : {std::size_t{0x7FFFFFFF}, std::size_t{1}, std::size_t{7}}) {
            std::string damaged = whole;
            damaged.replace(damaged.find(type) - 4, 4, big_endian(size));
            EXPECT_NE(refusal(damaged), "") << type << ' ' << size;
        }
    }
    EXPECT_NE(refusal(head("", big_endian(1), "text")), "");
    EXPECT_NE(refusal(head("key", big_endian(0), "text")), "");
    EXPECT_NE(refusal(head("key", big_endian(2), "text")), "");
    for (std::size_t length = whole.find("moov"); length < whole.size(); ++length)
        EXPECT_NE(refusal(whole.substr(0, length)), "") << length;
}

}  // namespace
}  // namespace fumon
