// OpenEXR, PNG of 16 bits, JPEG and WebP, as a user makes them.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "picture/exr.h"
#include "picture/png.h"
#include "support/program.h"
#include "support/same_run.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

class LightFiles : public ::testing::Test {
  protected:
    void SetUp() override {
        write_text(folder_ / "scene.toml", R"(title = "Light"
[model]
name = "sand"
[grid]
nx = 30
ny = 20
[run]
steps = 8
[frames]
every = 8
[look]
ground = "table"
[image]
supersampling = 1
width = 64
height = 48
[[overlay]]
kind = "time"
[output]
movie = false
)");
    }

    [[nodiscard]] Ended run(const std::vector<std::string>& arguments) const {
        return fumon(arguments, folder_.path());
    }

    const ScratchFolder folder_{};
};

TEST_F(LightFiles, AStillIsMadeAgainToTheByte) {
    const Ended still = run({"still", "scene.toml", "-o", "a.exr", "--threads", "1"});
    ASSERT_EQ(still.status, 0) << still.errors;
    EXPECT_NE(still.errors.find("overlays are not part of an OpenEXR file"), std::string::npos);
    const Ended again = run({"again", "a.exr", "--threads", "3"});
    EXPECT_NE(again.errors.find("a-again.exr: the same pixels as a.exr"), std::string::npos)
        << again.errors;
    EXPECT_EQ(read_text(folder_ / "a.exr"), read_text(folder_ / "a-again.exr"));
    ASSERT_EQ(run({"again", "a.exr", "-o", "b.png"}).status, 0);
    EXPECT_EQ(read_png(folder_ / "b.png").width, 64);
}

TEST_F(LightFiles, AJpegAndAWebpAreMadeAgainToTheByte) {
    for (const std::vector<std::string>& how : std::vector<std::vector<std::string>>{
             {"a.jpg"}, {"b.JPEG", "--quality", "60"}, {"c.webp"}, {"d.webp", "--lossless"}}) {
        const fs::path file = how.front();
        std::vector<std::string> still{"still", "scene.toml", "--threads", "1", "-o"};
        still.insert(still.end(), how.begin(), how.end());
        ASSERT_EQ(run(still).status, 0) << file;
        const std::string made = file.stem().string() + "-again" +
                                 (file == "b.JPEG" ? ".jpg" : file.extension().string());
        const Ended again = run({"again", file.string(), "--threads", "3"});
        EXPECT_NE(again.errors.find(made + ": the same pixels as " + file.string()),
                  std::string::npos)
            << again.errors;
        EXPECT_EQ(read_text(folder_ / file.string()), read_text(folder_ / made));
    }
    EXPECT_LT(fs::file_size(folder_ / "b.JPEG"), fs::file_size(folder_ / "a.jpg"));
    ASSERT_EQ(run({"again", "d.webp", "-o", "e.png"}).status, 0);
    EXPECT_EQ(run({"compare", "d.webp", "e.png", "--level", "identical"}).status, 0);
    EXPECT_EQ(run({"compare", "a.jpg", "e.png"}).status, 1);  // noise of a small picture
    const Ended deep =
        run({"still", "scene.toml", "-o", "f.jpg", "--set", "image.deep_colour=true"});
    EXPECT_EQ(deep.status, 2);
    EXPECT_NE(deep.errors.find("JPEG holds 8 bits a channel"), std::string::npos) << deep.errors;
    EXPECT_EQ(run({"still", "scene.toml", "-o", "f.png", "--quality", "50"}).errors,
              "--quality belongs to JPEG and WebP; name the picture FILE.jpg or FILE.webp\n");
    EXPECT_FALSE(fs::exists(folder_ / "f.jpg"));
}

TEST_F(LightFiles, FramesHaveThemBesideThem) {
    const std::vector<std::string> settings{"--set", "output.exr_frames=true",
                                            "--set", "image.deep_colour=true",
                                            "--set", "output.exr_layers=colour"};
    std::vector<std::string> arguments{"run", "scene.toml", "-o", "out", "-q"};
    arguments.insert(arguments.end(), settings.begin(), settings.end());
    ASSERT_EQ(run(arguments).status, 0);
    const fs::path frame = folder_ / "out/frames/frame_000001";
    ASSERT_TRUE(fs::exists(fs::path(frame).replace_extension(".exr")));
    EXPECT_EQ(read_text(fs::path(frame).replace_extension(".png")).at(24), 16);  // bits
    for (const char* ending : {".exr", ".png"}) {
        const std::string file = fs::path(frame).replace_extension(ending).string();
        const std::string made = std::string("again") + ending;
        EXPECT_EQ(run({"again", file, "-o", made}).status, 0);
        EXPECT_EQ(read_text(folder_ / made), read_text(file));
    }
    // A new run in its place takes them away.
    ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "-q", "--force"}).status, 0);
    EXPECT_FALSE(fs::exists(fs::path(frame).replace_extension(".exr")));
}

TEST_F(LightFiles, WhatCannotBeIsRefusedInOneLine) {
    const Ended nowhere = run({"still", "scene.toml", "-o", "no/where.exr"});
    EXPECT_EQ(nowhere.status, 3);
    EXPECT_NE(nowhere.errors.find("no/where.exr"), std::string::npos) << nowhere.errors;
    const Ended large = run({"still", "scene.toml", "-o", "large.exr", "--set", "image.width=16384",
                             "--set", "image.height=16384"});
    EXPECT_EQ(large.status, 2);
    EXPECT_NE(large.errors.find("16384 x 16384 pixels as OpenEXR take 24.0 GiB of memory, more "
                                "than 16; output.exr_layers = \"colour\" takes 8.0"),
              std::string::npos)
        << large.errors;
    EXPECT_FALSE(fs::exists(folder_ / "large.exr"));
    write_text(folder_ / "cut.exr", "\x76\x2f\x31\x01");
    const Ended cut = run({"again", "cut.exr"});
    EXPECT_EQ(cut.status, 2);
    EXPECT_NE(cut.errors.find("cut.exr: is a damaged OpenEXR file"), std::string::npos)
        << cut.errors;
}

}  // namespace
}  // namespace fumon::test
