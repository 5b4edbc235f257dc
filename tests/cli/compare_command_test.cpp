#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <span>

#include "files/atomic_file.h"
#include "files/hash.h"
#include "picture/compare.h"
#include "picture/png.h"
#include "picture/stills/picture_file.h"
#include "picture/stills/same_picture_files.h"
#include "support/pictures.h"
#include "support/program.h"

namespace fumon::test {
namespace {

/// Three pictures: a, b with a level of one pixel changed by one, and c of another size.
class Pictures : public ::testing::Test {
  protected:
    Pictures() {
        Image image = some_picture(101, 67);
        write("a.png", image);
        image.rgb[3000] ^= 1U;
        write("b.png", image);
        write("c.png", some_picture(101, 68));
    }

    void write(const std::string& name, const Image& image) const {
        write_file(folder_ / name, encode_png(image, 96.0, {}));
    }
    [[nodiscard]] Ended run(const std::vector<std::string>& arguments) const {
        return fumon(arguments, folder_.path());
    }

    ScratchFolder folder_;
};

TEST_F(Pictures, CompareSaysHowFarAndPassesByLevel) {
    const Ended same = run({"compare", "a.png", "a.png", "--level", "identical"});
    EXPECT_EQ(same.status, 0) << same.errors;
    EXPECT_EQ(same.output,
              "largest difference    0 of 255\n"
              "changed pixels        0 (0 %)\n"
              "mean difference       0\n"
              "smallest tile SSIM    1.0000\n"
              "thumbnail difference  0.000\n"
              "identical\n");
    const Ended near = run({"compare", "a.png", "b.png", "--diff", "d.png"});
    EXPECT_EQ(near.status, 0);
    EXPECT_TRUE(
        near.output.starts_with("largest difference    1 of 255\n"
                                "changed pixels        1 (0.01478 %)\n"))
        << near.output;
    EXPECT_TRUE(near.output.ends_with("\nsame to the eye\n")) << near.output;
    EXPECT_EQ(read_png(folder_ / "d.png").height, 67);
    EXPECT_EQ(run({"compare", "a.png", "b.png", "--level", "identical"}).status, 1);
}

TEST_F(Pictures, OtherSizesDifferAndBadFilesAreWrongInput) {
    const Ended other = run({"compare", "a.png", "c.png", "--level", "close", "--diff", "d.png"});
    EXPECT_EQ(other.status, 1);
    EXPECT_EQ(other.output, "different: 101 x 67 against 101 x 68 pixels\n");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "d.png"));
    EXPECT_EQ(run({"compare", "a.png", "none.png"}).status, 2);
    write_text(folder_ / "text.png", "no picture");
    EXPECT_EQ(run({"compare", "text.png", "a.png"}).errors,
              "text.png: is not a PNG, JPEG, WebP or TIFF file; name one that is\n");
    EXPECT_EQ(run({"compare", "a.png", "b.png", "--level", "same-ish"}).errors,
              "fumon compare: --level: it takes identical, same or close, not \"same-ish\"; try "
              "`fumon compare --help`\n");
}

/// Equal files are not decoded: one whose pixels would be refused is identical to its copy, as long
/// as its checksums hold.
TEST_F(Pictures, EqualFilesEndAtOnceWhereTheyAreWhole) {
    const std::string whole = read_text(folder_ / "a.png");
    write_text(folder_ / "copy.png", whole);
    const Ended same = run({"compare", "a.png", "copy.png", "--json"});
    EXPECT_EQ(same.status, 0) << same.errors;
    EXPECT_EQ(nlohmann::json::parse(same.output)["likeness"], "identical");
    EXPECT_EQ(run({"compare", "a.png", "copy.png", "--diff", "d.png"}).status, 0);
    EXPECT_EQ(read_png(folder_ / "d.png"),
              difference_picture(some_picture(101, 67), some_picture(101, 67)));
    const auto refused = [&](const std::string& bytes) {
        write_text(folder_ / "one.png", bytes);
        write_text(folder_ / "two.png", bytes);
        return run({"compare", "one.png", "two.png"}).status == 2;
    };
    EXPECT_TRUE(refused(whole.substr(0, whole.size() - 1)));
    EXPECT_TRUE(refused(whole.substr(0, 400)));
    EXPECT_TRUE(refused(whole.substr(0, 11)));
    std::string damaged = whole;
    damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 1);
    EXPECT_TRUE(refused(damaged));
    for (const char* name : {"a.jpg", "a.webp"}) {
        const Image image = some_picture(60, 40);
        const auto bytes =
            encode_picture(image, picture_format(name), {}, screen_dots_per_inch, own_text());
        write_file(folder_ / name, bytes);
        EXPECT_TRUE(same_picture_files(folder_ / name, folder_ / name)) << name;
        write_file(folder_ / name, std::span(bytes).first(bytes.size() - 1));
        EXPECT_FALSE(same_picture_files(folder_ / name, folder_ / name)) << name;
    }
    EXPECT_FALSE(same_picture_files(folder_ / "a.png", folder_ / "b.png"));
    EXPECT_FALSE(same_picture_files(folder_ / "none.png", folder_ / "none.png"));
}

TEST_F(Pictures, BoxesAndMasksAreLeftOut) {
    Image other = some_picture(101, 67);
    for (int i = 0; i < 60; ++i) other.row(5)[i] ^= 255U;
    write("other.png", other);
    Image mask = flat_picture(101, 67, 0);
    for (int i = 0; i < 60; ++i) mask.row(5)[i] = 255;
    write("mask.png", mask);
    EXPECT_EQ(run({"compare", "a.png", "other.png", "--level", "close"}).status, 1);
    const Ended box = run({"compare", "a.png", "other.png", "--ignore", "0,5,10,1", "--ignore",
                           "10,0,10,10", "--level", "identical", "--diff", "d.png"});
    EXPECT_EQ(box.status, 0) << box.output << box.errors;
    EXPECT_TRUE(box.output.ends_with("ignored pixels        110 (1.626 %)\nidentical\n"))
        << box.output;
    IgnoredPixels ignored(101, 67);
    ignored.add({0, 5, 10, 1});
    ignored.add({10, 0, 10, 10});
    EXPECT_EQ(read_png(folder_ / "d.png"),
              difference_picture(some_picture(101, 67), other, ignored));
    const Ended masked =
        run({"compare", "a.png", "other.png", "--ignore-mask", "mask.png", "--json"});
    EXPECT_EQ(nlohmann::json::parse(masked.output)["likeness"], "identical") << masked.errors;
    EXPECT_EQ(nlohmann::json::parse(masked.output)["ignored_pixels"], 20);
    const auto refused = [&](const std::vector<std::string>& options) {
        std::vector<std::string> all{"compare", "a.png", "other.png", "--diff", "none.png"};
        all.insert(all.end(), options.begin(), options.end());
        const Ended ended = run(all);
        EXPECT_EQ(ended.status, 2);
        EXPECT_FALSE(std::filesystem::exists(folder_ / "none.png"));
        return ended.errors;
    };
    EXPECT_EQ(refused({"--ignore", "0,0,101,21"}),
              "31.3 % of the picture would be ignored, more than 30 %; ignore less\n");
    EXPECT_TRUE(refused({"--ignore", "0,0,3"})
                    .starts_with("fumon compare: --ignore: \"0,0,3\" is not a box; "));
    EXPECT_TRUE(
        refused({"--ignore-mask", "c.png"}).starts_with("c.png: is a mask of 101 x 68 pixels"));
    EXPECT_TRUE(refused({"--ignore-mask", "no.png"}).starts_with("no.png: "));
}

TEST_F(Pictures, HelpNamesTheLevels) {
    const std::string help = run({"compare", "--help"}).output;
    for (const char* level : {"identical", "same to the eye", "close", "different"})
        EXPECT_NE(help.find(level), std::string::npos) << level;
}

TEST_F(Pictures, FingerprintsAreTextAndJson) {
    const Ended text = run({"fingerprint", "a.png", "b.png"});
    EXPECT_EQ(text.status, 0) << text.errors;
    EXPECT_TRUE(text.output.starts_with("[\"a.png\"]\nsize = [101, 67]\npixels = \"" +
                                        hex(pixel_hash(some_picture(101, 67))) + "\"\ndhash = \""))
        << text.output;
    EXPECT_NE(text.output.find("\n[\"b.png\"]\n"), std::string::npos);

    const auto json = nlohmann::json::parse(run({"fingerprint", "--json", "a.png"}).output);
    EXPECT_EQ(json[0]["pixels_sha256"], hex(pixel_hash(some_picture(101, 67))));
    EXPECT_EQ(json[0]["thumbnail"].size(), 18U);
    EXPECT_EQ(json[0]["thumbnail"][0].size(), 32U);
    EXPECT_EQ(run({"fingerprint", "none.png"}).status, 2);
}

}  // namespace
}  // namespace fumon::test
