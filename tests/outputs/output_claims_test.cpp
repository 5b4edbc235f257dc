#include "outputs/output_claims.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "figure/canvas/figure_metadata.h"
#include "outputs/own_file.h"
#include "picture/junit.h"
#include "picture/movie.h"
#include "picture/png.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

std::string png(const PictureText& texts) {
    const auto bytes = encode_png(Image(2, 2), screen_dots_per_inch, texts);
    return {bytes.begin(), bytes.end()};
}

class Claims : public ::testing::Test {
  protected:
    [[nodiscard]] std::string refusal(const fs::path& file, bool force = false,
                                      bool listed = false) const {
        OutputClaims claims(force);
        claims.reads(input_);
        return message_of<InputError>([&] { claims.writes(file, listed); });
    }

    TemporaryFolder folder_;
    fs::path input_ = folder_.file("bed.asc", "1 2 3");
};

TEST_F(Claims, AnInputIsNeverReplacedHoweverItIsNamed) {
    fs::create_symlink(input_, folder_ / "link.asc");
    fs::create_hard_link(input_, folder_ / "other.asc");
    fs::create_directory(folder_ / "sub");
    fs::create_directory_symlink(folder_.path(), folder_ / "around");
    for (const char* name :
         {"bed.asc", "./bed.asc", "sub/../bed.asc", "link.asc", "other.asc", "around/bed.asc"}) {
        const fs::path file = folder_ / name;
        for (const bool force : {false, true})
            EXPECT_EQ(refusal(file, force, true),
                      file.string() + " is an input and would be replaced; write to another file");
    }
}

TEST_F(Claims, AnInputUnderTheTemporaryNameOfAnOutputIsKept) {
    input_ = folder_.file("a.png.part", "1 2 3");
    EXPECT_EQ(refusal(folder_ / "a.png", true),
              input_.string() + " is an input and would be replaced; write to another file");
}

TEST_F(Claims, FilesOfOthersNeedForce) {
    const std::string what =
        ": already exists and was not made by fumon; name another output, or replace it with "
        "--force";
    for (const std::string& bytes : {std::string("mine"), std::string(), png({}),
                                     png({{"Software", "another"}}), std::string("\x89PNG\r\n")}) {
        const fs::path file = folder_.file("a.png", bytes);
        EXPECT_EQ(refusal(file), file.string() + what);
        EXPECT_EQ(refusal(file, true), "");
        EXPECT_EQ(refusal(file, false, true), "") << "what stands beside it lists it";
        EXPECT_EQ(bytes_of(file), bytes);
    }
    fs::create_symlink("nowhere", folder_ / "link.png");
    EXPECT_EQ(refusal(folder_ / "link.png"), (folder_ / "link.png").string() + what);
    const fs::path part = folder_.file("b.png.part", "mine");
    EXPECT_EQ(refusal(folder_ / "b.png"), part.string() + what);
    EXPECT_EQ(bytes_of(part), "mine");
    EXPECT_NE(refusal(folder_.path(), true), "") << "a folder";
}

TEST_F(Claims, FumonsOwnFilesAreReplaced) {
    FigureMetadata by_fumon{{"Software", "fumon 9.9"}};
    const std::string svg = with_svg_metadata("<svg width=\"1\"></svg>", by_fumon);
    Movie movie(folder_ / "a.mp4", 16, 16, 30.0, 18);
    movie.add(Image(16, 16));
    movie.finish(own_text());
    folder_.file("a.png", png(own_text()));
    folder_.file("a.svg", svg);
    folder_.file("a.xml", junit_xml({}, ""));
    folder_.file("a.html", "<!DOCTYPE html>\n<meta " + std::string(own_page_mark) + ">");
    folder_.file("a.toml", "# A law\n" + std::string(own_scene_mark) + "9.9\nseed = 1\n");
    folder_.file("a.caption.txt", "Dunes.\n\nMade from dunes.toml by fumon 9.9.\n");
    for (const char* name :
         {"a.png", "a.svg", "a.mp4", "a.xml", "a.html", "a.toml", "a.caption.txt"})
        EXPECT_EQ(refusal(folder_ / name), "") << name;
    folder_.file("a.toml", "seed = 1\n" + std::string(own_scene_mark) + "9.9\n");
    EXPECT_NE(refusal(folder_ / "a.toml"), "") << "not a comment at its head";
    EXPECT_NE(refusal(folder_.file("b.svg", "<svg width=\"1\"></svg>")), "");
}

TEST_F(Claims, WhatCannotBeWrittenIsFoundAndLeavesNoTrace) {
    const long before = folder_.entries();
    OutputClaims claims(false);
    EXPECT_EQ(message_of<Error>([&] { claims.writes(folder_ / "no/a.png"); }),
              "cannot write " + (folder_ / "no/a.png").string() + ": No such file or directory");
    EXPECT_EQ(message_of<Error>([&] { claims.writes(input_ / "a.png"); }),
              "cannot write " + (input_ / "a.png").string() + ": Not a directory");
    claims.writes(folder_ / "a.png");
    EXPECT_NE(message_of<InputError>([&] { claims.writes(folder_ / "./a.png"); }), "")
        << "claimed twice";
    EXPECT_EQ(folder_.entries(), before);
}

TEST_F(Claims, PipesAndDevicesAreWrittenInto) {
    ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(refusal(folder_ / "pipe"), "");
    EXPECT_EQ(refusal("/dev/null"), "");
    EXPECT_NO_THROW(check_ending("/dev/null", "a picture", png_ending));
}

TEST(OutputEnding, UnknownOnesAreRefused) {
    for (const char* name : {"a.png", "a.PNG", "x/b.c.png"})
        EXPECT_NO_THROW(check_ending(name, "a picture", png_ending)) << name;
    for (const char* name : {"a.gif", "a.jpg", "a", "png", "a.png.asc", ".png", "a.png "}) {
        EXPECT_EQ(message_of<InputError>([&] { check_ending(name, "a picture", png_ending); }),
                  std::string(name) + ": the name of a picture must end in .png");
    }
}

TEST_F(Claims, AFolderForOutputsIsNoRootAndNoFileAndCanBeWritten) {
    const long before = folder_.entries();
    const auto refused = [](const fs::path& folder) {
        return message_of<Error>([&] { check_output_folder(folder, "the run"); });
    };
    fs::create_directory_symlink("/", folder_ / "root");
    for (const fs::path& root : {fs::path("/"), fs::path("//tmp/.."), folder_ / "root"})
        EXPECT_NE(refused(root).find("is the root of the file system"), std::string::npos) << root;
    fs::remove(folder_ / "root");
    EXPECT_EQ(refused(input_), input_.string() + " is a file; name a folder for the run with -o");
    EXPECT_NE(refused(input_ / "a/b").find("cannot make the folder"), std::string::npos);
    EXPECT_EQ(refused(""), "name a folder for the run with -o");
    EXPECT_NE(refused("/proc/no/such").find("cannot make the folder"), std::string::npos);
    EXPECT_EQ(refused(folder_ / "new/and/newer/"), "");
    EXPECT_EQ(refused(folder_.path()), "");
    EXPECT_EQ(folder_.entries(), before);
}

}  // namespace
}  // namespace fumon::test
