// Pictures and baselines may come from anyone.

#include <gtest/gtest.h>

#include <string>

#include "files/atomic_file.h"
#include "files/hash.h"
#include "files/terrain/grid_hash.h"
#include "picture/png.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

class Trust : public ::testing::Test {
  protected:
    /// A picture with a scene of someone's making.
    void forge(const std::string& scene, const std::string& inputs = "[]",
               const std::string& step = "0") const {
        const PictureText texts{
            {"fumon:scene", scene}, {"fumon:step", step}, {"fumon:inputs", inputs}};
        write_file(folder_ / "picture.png", encode_png(Image(16, 16), 96, texts));
    }

    /// What `fumon again` says of it, if it refuses it and writes nothing.
    [[nodiscard]] std::string refusal(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"again", "picture.png", "-o", "made.png", "-q"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ended ended = fumon(arguments, folder_.path());
        EXPECT_FALSE(fs::exists(folder_ / "made.png"));
        EXPECT_EQ(ended.status, 2) << ended.errors;
        return ended.errors;
    }

    static std::string of_bed(const std::string& file) {
        return "[model]\nname = \"static\"\n[bed]\nfile = \"" + file + "\"\n";
    }

    ScratchFolder folder_;
};

TEST_F(Trust, AnInputThatIsNotListedIsAnError) {
    write_text(folder_ / "secret.asc", "the first line\n");
    forge(of_bed("secret.asc"));
    EXPECT_EQ(
        refusal(),
        "picture.png: its scene starts from secret.asc, which its metadata does not list with "
        "its SHA-256; to start from a file of your own, give it with --set bed.file=FILE\n");
    forge(of_bed("secret.asc"), R"([{"path": "other.asc", "sha256": "00"}])");
    EXPECT_NE(refusal().find("does not list"), std::string::npos) << "another one is listed";
    EXPECT_NE(refusal({"--trust"}).find("does not list"), std::string::npos);
    EXPECT_NE(refusal({"--set", "bed.file=secret.asc"}).find("secret.asc:1: "), std::string::npos)
        << "a file that the user names is told of";
}

TEST_F(Trust, NothingTellsWhatIsThere) {
    write_text(folder_ / "secret.asc", "the first line\n");
    const auto message = [&](const std::string& path) {
        forge(of_bed(path), R"([{"path": ")" + path + R"(", "sha256": "0123456789abcdef"}])");
        std::string text = refusal();
        return text.replace(text.find(": " + path + " ") + 2, path.size(), "FILE");
    };
    const std::string changed = message("secret.asc");
    EXPECT_EQ(changed, message("none.asc")) << "not there";
    EXPECT_EQ(changed, message(".")) << "a folder";
    EXPECT_EQ(changed, message("/proc/self/mem")) << "it cannot be read";
    EXPECT_EQ(changed,
              "picture.png: FILE as it was when the picture was made (SHA-256 0123456789ab…) is "
              "missing; restore it, copy it beside the picture, or work in the folder to which the "
              "path is relative; to start from another file, give it with --set bed.file=FILE\n");
}

TEST_F(Trust, NothingOfAFileIsPrinted) {
    write_text(folder_ / "secret.asc", "the first line\n");
    const std::string hash = hex(file_hash(folder_ / "secret.asc"));
    forge(of_bed("secret.asc"), R"([{"path": "secret.asc", "sha256": ")" + hash + R"("}])");
    EXPECT_EQ(refusal(),
              "picture.png:4:8: secret.asc does not exist or is not a readable bed; --trust gives "
              "details\n");
    EXPECT_NE(refusal({"--trust"}).find("secret.asc:1: "), std::string::npos);
}

TEST_F(Trust, WhatNamesOtherFilesIsReadByItsUsersWord) {
    const auto refused = [&](const std::string& name) {
        forge(of_bed(name), R"([{"path": ")" + name + R"(", "sha256": ")" +
                                hex(grid_hash(folder_ / name)) + R"("}])");
        return refusal();
    };
    write_text(folder_ / "dem.vrt", "<VRTDataset></VRTDataset>");
    EXPECT_EQ(refused("dem.vrt"),
              "picture.png:4:8: dem.vrt is read only with --trust, since a VRT names other files: "
              "fumon again --trust picture.png\n");
    write_text(folder_ / "dem.img", "EHFA_HEADER_TAG");
    EXPECT_NE(refused("dem.img").find("since its format (.img) may name other files: fumon again "
                                      "--trust picture.png\n"),
              std::string::npos);
    fs::create_directory(folder_ / "dem.zarr");
    write_text(folder_ / "dem.zarr/.zgroup", "{}");
    EXPECT_NE(refused("dem.zarr")
                  .find("dem.zarr is read only with --trust, since a Zarr store is "
                        "a folder of files: fumon again --trust picture.png\n"),
              std::string::npos);
    write_text(folder_ / "b.toml", "[cases]\na = {scene = \"s.toml\"}\n");
    for (const char* name : {"dem.vrt", "none.vrt"}) {
        write_text(folder_ / "s.toml", of_bed(name));
        const Ended ended = fumon({"verify", "b.toml"}, folder_.path());
        EXPECT_EQ(ended.status, 2);
        EXPECT_NE(ended.output.find(std::string(name) +
                                    " is read only with --trust, since a VRT names other files"),
                  std::string::npos)
            << ended.output << ended.errors;
    }
}

TEST_F(Trust, AChangedReferenceSystemBesideAGridIsNoticed) {
    write_text(folder_ / "dem.asc",
               "ncols 2\nnrows 2\nxllcorner 5\nyllcorner 5\ncellsize 1\n1 2 3 4\n");
    const std::string feet = "PROJCS[\"a\",UNIT[\"Foot_US\",0.3048006]]";
    write_text(folder_ / "dem.prj", feet);
    ASSERT_EQ(fumon({"still", "dem.asc", "-o", "a.png", "-q", "--set", "image.width=64", "--set",
                     "image.height=48"},
                    folder_.path())
                  .status,
              0);
    const auto again = [&] { return fumon({"again", "a.png", "-o", "made.png"}, folder_.path()); };
    EXPECT_NE(again().errors.find("the same pixels"), std::string::npos);
    fs::remove(folder_ / "made.png");
    write_text(folder_ / "dem.prj", "PROJCS[\"a\",UNIT[\"Metre\",1]]");
    Ended changed = again();
    EXPECT_EQ(changed.status, 2);
    EXPECT_NE(changed.errors.find("dem.asc as it was when the picture was made"), std::string::npos)
        << changed.errors;
    fs::remove(folder_ / "dem.prj");
    EXPECT_EQ(again().status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "made.png"));
}

TEST_F(Trust, APictureMayAskForSoMuch) {
    const auto sand = [](const std::string& keys) {
        return "[model]\nname = \"sand\"\n[run]\nsteps = 10\n" + keys;
    };
    const std::string end = "; --trust lifts this limit\n";
    forge(sand("[grid]\nnx = 11000\nny = 11000\n"));
    EXPECT_EQ(refusal(),
              "picture.png:6:6: 121,000,000 cells are more than the 4,194,304 allowed to scenes of "
              "unknown origin" +
                  end);
    forge(sand(""), "[]", "1000000000000");
    EXPECT_EQ(refusal(),
              "picture.png: 1,000,000,000,000 steps are more than the 10,000,000 allowed to scenes "
              "of unknown origin" +
                  end);
    forge(sand("[grid]\nnx = 2000\nny = 2000\n"), "[]", "9000000");
    EXPECT_NE(refusal().find("cell-steps are more than"), std::string::npos);
    forge(sand("[image]\nwidth = 8192\nheight = 8192\nsupersampling = 4\n"));
    EXPECT_EQ(refusal(),
              "picture.png:6:9: pictures of 1,073,741,824 samples are larger than the 134,217,728 "
              "allowed to scenes of unknown origin" +
                  end);
    forge("[model]\nname = \"static\"\n[run]\nsteps = 200000\n[frames]\nevery = 1\n");
    EXPECT_NE(refusal().find("200,001 frames are more than the 100,000 allowed"),
              std::string::npos);
    forge("[model]\nname = \"airflow\"\nnz = 100\n[grid]\nnx = 4000\n[run]\nsteps = 1\n");
    EXPECT_NE(refusal().find("16,000,000 cells are more"), std::string::npos)
        << "an equation between any two columns";
    forge("[model]\nname = \"sandpile\"\ngrains_per_step = 1000000000\n[run]\nsteps = 10\n");
    EXPECT_NE(refusal().find("10,000,000,000 grains are more"), std::string::npos);
}

TEST_F(Trust, DamagedMetadataIsRefusedWithoutACrash) {
    std::string deep = "a";
    for (int n = 0; n < 31000; ++n) deep += ".a";
    forge(deep + " = 1\n");
    EXPECT_NE(refusal().find("nest deeper than"), std::string::npos);
    forge("[model]\nname = \"static\"\n", std::string(200000, '['));
    EXPECT_EQ(refusal(), "picture.png: its fumon:inputs text is damaged; take an untouched copy\n");
}

TEST_F(Trust, AFigureKeepsTheSameRules) {
    write_text(folder_ / "secret.asc", "the first line\n");
    const auto refused = [&](const std::string& scene) {
        const nlohmann::json origin{{"scene", "s.toml"},
                                    {"set", nlohmann::json::array()},
                                    {"texts", {{{"path", "s.toml"}, {"text", scene}}}},
                                    {"inputs", nlohmann::json::array()}};
        write_file(folder_ / "picture.png",
                   encode_png(Image(16, 16), 96, {{"fumon:figure", origin.dump()}}));
        return refusal();
    };
    const std::string map = "[figure]\nwidth = \"single\"\n[[figure.panel]]\nkind = \"map\"\n";
    const std::string plot =
        "[figure]\nwidth = \"single\"\n[[figure.panel]]\nkind = \"plot\"\n"
        "[[figure.panel.curve]]\ny = \"mean_height\"\n";
    const std::string sand = "[model]\nname = \"sand\"\n[run]\nsteps = 5\n";
    EXPECT_NE(refused(of_bed("secret.asc") + map).find("not among the files"), std::string::npos);
    EXPECT_NE(refused(sand + map + "set = [\"bed.file=secret.asc\"]\n").find("not among the files"),
              std::string::npos);
    EXPECT_NE(refused(sand + plot + "over = [\"bed.file=secret.asc,none.asc\"]\n")
                  .find("secret.asc is not one of the files whose SHA-256 the metadata lists"),
              std::string::npos);
    EXPECT_NE(refused(sand + plot + "table = \"file\"\nfile = \"secret.asc\"\n")
                  .find("not among the files"),
              std::string::npos);
    EXPECT_NE(refused(sand + "[grid]\nnx = 9000\nny = 9000\n" + map).find("cells are more than"),
              std::string::npos);
    EXPECT_NE(refused("[model]\nname = \"sand\"\n[grid]\nnx = 1000\nny = 1000\n[run]\nsteps = "
                      "900000\n" +
                      plot + "seeds = 5\n")
                  .find("its runs take 4.5e+12 cell-steps"),
              std::string::npos);
}

TEST_F(Trust, ABaselineTellsNothingOfTheFilesThatItNames) {
    write_text(folder_ / "secret", "the first line\n");
    write_text(folder_ / "b.toml", "[cases]\na = {scene = \"secret\"}\n");
    const Ended wrong = fumon({"verify", "b.toml"}, folder_.path());
    EXPECT_EQ(wrong.status, 2);
    EXPECT_TRUE(wrong.output.starts_with(
        "WRONG    b a: b.toml:2:1: cases.a: secret does not exist or is invalid; `fumon check` "
        "with its path, or --trust here, gives details\n"))
        << wrong.output;
    fs::remove(folder_ / "secret");
    EXPECT_EQ(fumon({"verify", "b.toml"}, folder_.path()).output, wrong.output);
    EXPECT_NE(fumon({"verify", "--trust", "b.toml"}, folder_.path()).output.find("cannot be read"),
              std::string::npos);
    write_text(folder_ / "scene.toml", small_scene());
    write_text(folder_ / "b.toml",
               "[cases]\na = {scene = \"scene.toml\", settings = [\"grid.nx=11000\", "
               "\"grid.ny=11000\"]}\n");
    const Ended large = fumon({"verify", "b.toml"}, folder_.path());
    EXPECT_EQ(large.status, 2);
    EXPECT_NE(large.output.find("cells are more than"), std::string::npos) << large.output;
}

TEST_F(Trust, ABaselineKeepsItsPicturesBesideItself) {
    fs::create_directory(folder_ / "in");
    write_text(folder_ / "in/...toml",
               "[cases]\na = {scene = \"../scene.toml\", picture = true}\n");
    write_text(folder_ / "scene.toml", small_scene());
    const Ended ended = fumon({"verify", "--update", "in/...toml"}, folder_.path());
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.output,
              "WRONG    .. baseline: in/...toml: expected pictures are stored in a folder of the "
              "same name without its ending, here \"..\"; rename the baseline\n");
    EXPECT_FALSE(fs::exists(folder_ / "a.png"));
}

}  // namespace
}  // namespace fumon::test
