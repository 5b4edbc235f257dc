#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "files/atomic_file.h"
#include "files/hash.h"
#include "picture/png.h"
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
              "text.png: is not a PNG, JPEG or WebP file; name one that is\n");
    EXPECT_EQ(run({"compare", "a.png", "b.png", "--level", "same-ish"}).errors,
              "fumon compare: --level: it takes identical, same or close, not \"same-ish\"; try "
              "`fumon compare --help`\n");
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
