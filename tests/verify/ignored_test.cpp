#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "files/atomic_file.h"
#include "picture/compare.h"
#include "picture/pixels/ignored_pixels.h"
#include "picture/png.h"
#include "support/pictures.h"
#include "support/program.h"

namespace fumon::test {
namespace {

/// RFC 4648.
std::string base64(const std::vector<std::uint8_t>& bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    unsigned bits = 0;
    int held = 0;
    for (const std::uint8_t byte : bytes) {
        bits = bits << 8U | byte;
        for (held += 8; held >= 6; held -= 6) text += digits[bits >> (held - 6) & 63U];
    }
    if (held > 0) text += digits[bits << (6 - held) & 63U];
    while (text.size() % 4 != 0) text += '=';
    return text;
}

/// A case whose picture has the time on it, as an overlay in its upper left corner.
class VerifyIgnored : public ::testing::Test {
  protected:
    VerifyIgnored() {
        std::string scene = small_scene() + "[[overlay]]\nkind = \"time\"\nfont_size = 8\n";
        const std::string small = "width = 64\nheight = 48";
        scene.replace(scene.find(small), small.size(), "width = 128\nheight = 80");
        write_text(folder_ / "scene.toml", scene);
    }

    /// A case that keeps its picture, of 128 × 80 pixels from above.
    void write_case(const std::string& ignore, const std::string& more = "") const {
        write_text(folder_ / "b.toml",
                   "scene = \"scene.toml\"\nstep = 10\n[cases]\nmap = {picture = true, settings = "
                   "[\"camera."
                   "projection=map\", \"image.width=128\", \"image.height=80\"" +
                       more + "]" + ignore + "}\n");
    }

    [[nodiscard]] Ended verify(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"verify", "b.toml"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return fumon(arguments, folder_.path());
    }

    ScratchFolder folder_;
};

TEST_F(VerifyIgnored, AnOverlayByItsKind) {
    write_case("");
    EXPECT_EQ(verify({"--update", "--pinned"}).status, 0);
    write_case("", ", \"overlay.0.opacity=0.3\"");
    EXPECT_EQ(verify().status, 1) << "it is a part of the picture";
    write_case(", ignore = [\"time\"]");
    const Ended changed = verify();
    EXPECT_EQ(changed.status, 1);
    EXPECT_TRUE(
        contains(changed.output, "what is ignored is not what it was when this was recorded"))
        << changed.output;
    const Ended update = verify({"--update", "--pinned"});
    EXPECT_TRUE(contains(update.output, "what is ignored changes")) << update.output;
    EXPECT_TRUE(contains(read_text(folder_ / "b.lock"), "\nignored = \""));
    write_case(", ignore = [\"time\"]", ", \"overlay.0.opacity=0.3\"");
    const Ended same = verify();
    EXPECT_EQ(same.status, 0) << same.output;
    EXPECT_TRUE(contains(same.output, "ok       b map: strict: state and pixels as recorded; "))
        << same.output;
    EXPECT_TRUE(contains(same.output, " % of the picture ignored\n")) << same.output;
}

TEST_F(VerifyIgnored, BoxesAreHatchedOnThePageAndInTheDifference) {
    write_case(", ignore = [[100, 60, 20, 10]]");
    ASSERT_EQ(verify({"--update", "--pinned"}).status, 0);
    const Image kept = read_png(folder_ / "b/map.png");
    write_case(", ignore = [[100, 60, 20, 10]]", ", \"sun.azimuth=320\"");
    const Ended ended = verify({"-o", "out"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_TRUE(contains(ended.output, "; 1.95 % of the picture ignored\n")) << ended.output;
    IgnoredPixels ignored(128, 80);
    ignored.add({100, 60, 20, 10});
    const Image got = read_png(folder_ / "out/b/map-got.png");
    EXPECT_NE(got, kept);
    EXPECT_EQ(read_png(folder_ / "out/b/map-expected.png"), kept) << "the files are not hatched";
    EXPECT_EQ(read_png(folder_ / "out/b/map-difference.png"),
              difference_picture(kept, got, ignored));
    const std::string page = read_text(folder_ / "out/index.html");
    EXPECT_TRUE(contains(page, "1.95 % of the picture ignored"));
    EXPECT_TRUE(contains(page, base64(encode_png(hatched(got, ignored), 96.0, own_text()))));
}

TEST_F(VerifyIgnored, AMaskBesideTheBaseline) {
    Image mask = flat_picture(128, 80, 0);
    for (int i = 0; i < 3 * 128; ++i) mask.row(79)[i] = 255;
    write_file(folder_ / "mask.png", encode_png(mask, 96.0, {}));
    write_case(", ignore_mask = \"mask.png\"");
    const Ended ended = verify({"--update", "--pinned"});
    ASSERT_EQ(ended.status, 0) << ended.output << ended.errors;
    EXPECT_TRUE(contains(verify().output, "; 1.25 % of the picture ignored\n"));
    write_file(folder_ / "mask.png", encode_png(some_picture(128, 79), 96.0, {}));
    EXPECT_TRUE(
        contains(verify().output,
                 "WRONG    b map: b.toml:4:1: cases.map: ignore_mask: mask.png is not a PNG of "
                 "128 x 80 pixels like the picture; --trust gives details\n"))
        << verify().output;
    EXPECT_TRUE(contains(verify({"--trust"}).output,
                         "mask.png: is a mask of 128 x 79 pixels for a picture of 128 x 80"));
    std::filesystem::remove(folder_ / "mask.png");
    EXPECT_EQ(verify().status, 2);
}

TEST_F(VerifyIgnored, WrongOnesAreRefusedInALine) {
    const auto said = [&](const std::string& ignore) {
        write_case(", ignore = " + ignore);
        const Ended ended = verify();
        EXPECT_EQ(ended.status, 2) << ignore << ended.output;
        return ended.errors + ended.output;
    };
    EXPECT_TRUE(contains(said("[[0, 0, 128, 40]]"),
                         "WRONG    b map: b.toml:4:1: cases.map: 50.0 % of the picture would be "
                         "ignored, more than 30 %; ignore less\n"));
    EXPECT_TRUE(contains(said("[[0, 0, 128]]"), "b.toml:4:")) << said("[[0, 0, 128]]");
    EXPECT_TRUE(
        contains(said("[\"tme\"]"), "unknown kind of overlay \"tme\"; did you mean \"time\"?"))
        << said("[\"tme\"]");
    EXPECT_TRUE(contains(said("[\"coordinates\"]"), "coordinates cover the whole picture"));
    EXPECT_TRUE(contains(said("[\"title\"]"), "its picture has no overlay \"title\""));
    EXPECT_TRUE(contains(said("7"), "cases.map.ignore is a list of boxes"));
    EXPECT_TRUE(contains(said("[7]"), "cases.map.ignore takes boxes"));
    EXPECT_TRUE(contains(said("[[128, 0, 1, 1]]"), "lies outside of the picture of 128 x 80"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b.lock"));
    // What holds for all cases, and a case's own instead.
    write_text(folder_ / "b.toml",
               "scene = \"scene.toml\"\nstep = 10\nignore = [[0, 0, 3, 4]]\n[cases]\na = {}\nb = "
               "{ignore = []}\n");
    EXPECT_EQ(verify({"--update", "--pinned"}).status, 0);
    const std::string output = verify().output;
    EXPECT_TRUE(contains(output,
                         "ok       b a: strict: state and pixels as recorded; 0.117 % of the "
                         "picture ignored\nok       b b: strict: state and pixels as "
                         "recorded\n"))
        << output;
}

}  // namespace
}  // namespace fumon::test
