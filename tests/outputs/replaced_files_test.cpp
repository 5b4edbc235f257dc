// What every command does with files of others, as a user meets it.

#include <gtest/gtest.h>

#include "files/folder_lock.h"
#include "picture/png.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* in_the_way =
    ": already exists and was not made by fumon; name another output, or replace it with --force\n";

class ReplacedFiles : public ::testing::Test {
  protected:
    void SetUp() override {
        write_text(folder_ / "scene.toml", small_scene());
        write_text(folder_ / "bed.asc",
                   "ncols 3\nnrows 3\ncellsize 1\nxllcorner 0\nyllcorner 0\n1 2 3\n4 5 6\n7 8 9\n");
    }

    [[nodiscard]] Ended run(const Words& words) const { return fumon(words, folder_.path()); }

    /// A run without pictures, which needs no OpenGL.
    [[nodiscard]] Ended plain_run(const std::string& folder, const Words& more = {}) const {
        Words words{
            "run",   "scene.toml",        "-q", "-o", folder, "--set", "output.frames=false",
            "--set", "output.movie=false"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }

    void foreign(const std::string& name) const {
        fs::create_directories((folder_ / name).parent_path());
        write_text(folder_ / name, "mine");
    }

    [[nodiscard]] bool is_mine(const std::string& name) const {
        return read_text(folder_ / name) == "mine";
    }

    void expect_refused(const Words& words, const std::string& errors) const {
        const Ended ended = run(words);
        EXPECT_EQ(ended.status, 2) << ended.errors;
        EXPECT_EQ(ended.errors, errors);
    }

    ScratchFolder folder_;
};

TEST_F(ReplacedFiles, ARunRefusesEachFileThatIsCalledAsOneOfItsOwn) {
    int count = 0;
    for (const char* name :
         {"movie.mp4", "measurements.csv", "avalanches.csv", "fields.nc", "fields.nc.part",
          "checkpoint.fumon", "frames.fumon", "frames/frame_000000.png", "frames/frame_000099.png",
          "frames/frame_1000000.png", "movie_frames/frame_000001.png", "beds/bed_00000010.asc",
          "beds/bed_00000010.tif", "beds/bed_00000010.prj", "run.json"}) {
        const std::string out = "out" + std::to_string(++count);
        foreign(out + "/" + name);
        const Ended ended = plain_run(out);
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.errors, out + "/" + name + in_the_way);
        EXPECT_TRUE(is_mine(out + "/" + name));
    }
}

TEST_F(ReplacedFiles, ARunLeavesFilesOfOtherNamesAlone) {
    const Words others{"out/frames/frame_best.png",
                       "out/frames/frame_1.png",
                       "out/frames/frame_-00001.png",
                       "out/frames/frame_0000001.png",
                       "out/beds/bed_old.asc",
                       "out/beds/bed_00000010.txt",
                       "out/notes.txt"};
    for (const std::string& name : others) foreign(name);
    EXPECT_EQ(plain_run("out").status, 0);
    EXPECT_EQ(plain_run("out", {"--force"}).status, 0);
    for (const std::string& name : others) EXPECT_TRUE(is_mine(name)) << name;
}

TEST_F(ReplacedFiles, ForceReplacesAFormerRunAndWhatIsInTheWayAndNothingElse) {
    ASSERT_EQ(plain_run("out", {"--set", "output.bed_at=[10, 20]"}).status, 0);
    const Words others{"out/frames/frame_000001.png", "out/beds/bed_00000015.asc", "out/movie.mp4"};
    for (const std::string& name : others) foreign(name);
    foreign("out/beds/bed_00000005.asc");
    foreign("out/fields.nc");
    const Ended ended = plain_run(
        "out", {"--force", "--set", "output.bed_at=[5]", "--set", "output.fields_every=20"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    for (const std::string& name : others)
        EXPECT_TRUE(is_mine(name)) << name << ": no run.json lists it, and nothing takes its place";
    EXPECT_FALSE(fs::exists(folder_ / "out/beds/bed_00000010.asc")) << "the former run's";
    EXPECT_FALSE(is_mine("out/beds/bed_00000005.asc")) << "in the way";
    EXPECT_FALSE(is_mine("out/fields.nc")) << "in the way";
}

TEST_F(ReplacedFiles, AKilledRunIsReplacedAsWhole) {
    const Words beds{"--force", "--set", "output.bed_every=5"};
    ASSERT_EQ(plain_run("out", beds).status, 0);
    auto json = read_manifest(folder_ / "out");
    for (const char* key : {"measurements", "beds", "frames", "state_sha256"}) json.erase(key);
    json["status"] = "running";
    json["may_write"] = {{"files", {"measurements.csv", "fields.nc"}},
                         {"frames", 3},
                         {"movie_frames", 0},
                         {"beds",
                          {{"every", 5},
                           {"at", nlohmann::json::array()},
                           {"last_step", 20},
                           {"endings", {".asc"}}}}};
    write_text(folder_ / "out/run.json", json.dump());
    for (const char* name : {"out/frames/frame_000002.png", "out/frames/frame_000002.png.part",
                             "out/fields.nc.part", "out/frames/frame_000003.png"})
        foreign(name);
    ASSERT_EQ(plain_run("out", {"--force"}).status, 0);
    for (const char* gone : {"out/frames/frame_000002.png", "out/frames/frame_000002.png.part",
                             "out/fields.nc.part", "out/beds/bed_00000010.asc"})
        EXPECT_FALSE(fs::exists(folder_ / gone)) << gone;
    EXPECT_TRUE(is_mine("out/frames/frame_000003.png")) << "the run would not have written it";
}

TEST_F(ReplacedFiles, WhatARunLeavesUnfinishedSaysWhatItMayWrite) {
    Words beyond = settings_that_leave_the_range();
    beyond.insert(beyond.end(), {"--set", "bed.high=999999"});
    const Ended failed = plain_run("out", beyond);
    ASSERT_EQ(failed.status, 3) << failed.errors;
    const auto manifest = read_manifest(folder_ / "out");
    EXPECT_EQ(manifest["status"], "failed");
    ASSERT_TRUE(manifest.contains("may_write"));
    EXPECT_TRUE(manifest["may_write"]["files"].is_array());
    ASSERT_EQ(plain_run("out", {"--force"}).status, 0);
    EXPECT_FALSE(read_manifest(folder_ / "out").contains("may_write"));
}

TEST_F(ReplacedFiles, NothingIsRemovedThroughALinkToAFolder) {
    const Words beds{"--force", "--set", "output.bed_every=5"};
    fs::create_directory(folder_ / "elsewhere");
    fs::create_directory(folder_ / "out");
    fs::create_directory_symlink("../elsewhere", folder_ / "out/beds");
    ASSERT_EQ(plain_run("out", beds).status, 0);
    ASSERT_TRUE(fs::exists(folder_ / "elsewhere/bed_00000010.asc"));
    ASSERT_EQ(plain_run("out", {"--force"}).status, 0);
    EXPECT_TRUE(fs::exists(folder_ / "elsewhere/bed_00000010.asc"));
    fs::remove_all(folder_ / "out");
    fs::create_directory(folder_ / "out");
    fs::create_directory_symlink("../elsewhere", folder_ / "out/beds");
    EXPECT_EQ(plain_run("out").errors, "out/beds/bed_00000000.asc" + std::string(in_the_way));
}

TEST_F(ReplacedFiles, ARunDoesNotReplaceTheBedThatItStartsFrom) {
    ASSERT_EQ(plain_run("out", {"--set", "output.bed_at=[20]"}).status, 0);
    const std::string bed = read_text(folder_ / "out/beds/bed_00000020.asc");
    fs::create_hard_link(folder_ / "out/beds/bed_00000020.asc", folder_ / "start.asc");
    for (const char* file : {"out/beds/bed_00000020.asc", "start.asc"}) {
        const Ended ended = plain_run(
            "out", {"--force", "--set", "bed.kind=file", "--set", std::string("bed.file=") + file});
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(
            ended.errors,
            "out/beds/bed_00000020.asc is an input and would be replaced; write to another file\n");
        EXPECT_EQ(read_text(folder_ / "out/beds/bed_00000020.asc"), bed);
        EXPECT_EQ(read_manifest(folder_ / "out")["status"], "complete");
    }
}

TEST_F(ReplacedFiles, ResumingACompleteRunTouchesNothing) {
    ASSERT_EQ(plain_run("out").status, 0);
    foreign("out/movie_frames/frame_000001.png");
    EXPECT_EQ(run({"run", "--resume", "out", "-q"}).status, 0);
    EXPECT_TRUE(is_mine("out/movie_frames/frame_000001.png"));
}

TEST_F(ReplacedFiles, NoCommandReplacesWhatItReads) {
    fs::create_symlink("bed.asc", folder_ / "link.png");
    const std::string read = " is an input and would be replaced; write to another file\n";
    expect_refused({"still", "bed.asc", "-o", "link.png", "--force"}, "link.png" + read);
    ASSERT_EQ(run({"still", "bed.asc", "-q", "-o", "a.png", "--set", "image.width=64", "--set",
                   "image.height=48"})
                  .status,
              0);
    const std::string picture = read_text(folder_ / "a.png");
    expect_refused({"again", "a.png", "-o", "./a.png", "--force"}, "./a.png" + read);
    expect_refused({"compare", "a.png", "a.png", "--diff", "a.png"}, "a.png" + read);
    EXPECT_EQ(read_text(folder_ / "a.png"), picture);
    write_text(folder_ / "b.toml", "[cases]\na = {scene = \"scene.toml\"}\n");
    fs::create_hard_link(folder_ / "b.toml", folder_ / "b.xml");
    expect_refused({"verify", "b.toml", "--junit", "b.xml", "--force"}, "b.xml" + read);
    fs::create_directories(folder_ / "verify-out/b");
    fs::create_hard_link(folder_ / "scene.toml", folder_ / "verify-out/b/a-got.png");
    expect_refused({"verify", "b.toml", "--force"}, "verify-out/b/a-got.png" + read);
    fs::create_directories(folder_ / "sweep/runs");
    fs::create_hard_link(folder_ / "scene.toml", folder_ / "sweep/runs/0001.csv");
    expect_refused({"sweep", "scene.toml", "-o", "sweep", "--seeds", "1", "--force"},
                   "sweep/runs/0001.csv" + read);
    EXPECT_EQ(read_text(folder_ / "scene.toml"), small_scene());
}

TEST_F(ReplacedFiles, TheSameCommandTwiceNeedsNoForce) {
    const Words small{"-q", "--set", "image.width=64", "--set", "image.height=48"};
    const auto twice = [&](Words words) {
        for (int time = 0; time < 2; ++time) {
            const Ended ended = run(words);
            EXPECT_LE(ended.status, 1) << words.front() << ": " << ended.errors;
            EXPECT_EQ(ended.errors.find("--force"), std::string::npos) << ended.errors;
        }
    };
    Words still{"still", "scene.toml", "-o", "a.png", "--step", "1"};
    still.insert(still.end(), small.begin(), small.end());
    twice(still);
    twice({"again", "a.png", "-q"});
    fs::copy_file(folder_ / "a.png", folder_ / "c.png");
    twice({"compare", "a.png", "c.png", "--diff", "d.png"});
    write_text(folder_ / "b.toml",
               "[cases]\na = {scene = \"scene.toml\", step = 1, picture = true}\n");
    twice({"verify", "b.toml", "--junit", "j.xml"});
    EXPECT_TRUE(fs::exists(folder_ / "verify-out/b/a-got.png"));
    twice({"verify", "b.toml", "--update"});
    EXPECT_FALSE(fs::exists(folder_ / "verify-out/b")) << "its pictures are fumon's";
    twice({"sweep", "scene.toml", "-o", "sweep", "-q", "--seeds", "1"});
}

TEST_F(ReplacedFiles, OfOthersNeedForceInEveryCommand) {
    foreign("a.png");
    expect_refused({"still", "scene.toml", "-o", "a.png"}, std::string("a.png") + in_the_way);
    const auto bytes = encode_png(Image(2, 2), screen_dots_per_inch, {});
    const std::string blank(bytes.begin(), bytes.end());
    write_text(folder_ / "p.png", blank);
    write_text(folder_ / "d.png", blank);
    expect_refused({"compare", "p.png", "p.png", "--diff", "d.png"},
                   std::string("d.png") + in_the_way);
    EXPECT_EQ(read_text(folder_ / "d.png"), blank);
    EXPECT_EQ(run({"compare", "p.png", "p.png", "--diff", "d.png", "--force"}).status, 0);
    EXPECT_NE(read_text(folder_ / "d.png"), blank);
    write_text(folder_ / "b.toml", "[cases]\na = {scene = \"scene.toml\", picture = true}\n");
    foreign("b/a.png");
    expect_refused({"verify", "b.toml", "--update"}, std::string("b/a.png") + in_the_way);
    foreign("verify-out/b/a-got.png");
    expect_refused({"verify", "b.toml"}, std::string("verify-out/b/a-got.png") + in_the_way);
    foreign("j.xml");
    expect_refused({"verify", "b.toml", "-o", "v", "--junit", "j.xml"},
                   std::string("j.xml") + in_the_way);
    for (const char* name : {"sweep.csv", "runs.csv", "runs/0001.csv", "runs/0012-fields.nc"}) {
        foreign(std::string("s/") + name);
        expect_refused({"sweep", "scene.toml", "-o", "s", "--seeds", "1"},
                       "s/" + std::string(name) + in_the_way);
        EXPECT_TRUE(is_mine(std::string("s/") + name));
        fs::remove_all(folder_ / "s");
    }
    foreign("s/runs/0001.csv");
    foreign("s/runs/0012.csv");
    foreign("s/runs/12.csv");
    EXPECT_EQ(run({"sweep", "scene.toml", "-q", "-o", "s", "--seeds", "1", "--force"}).status, 0);
    EXPECT_FALSE(is_mine("s/runs/0001.csv"));
    EXPECT_TRUE(is_mine("s/runs/0012.csv") && is_mine("s/runs/12.csv"));
    for (const char* name : {"a.png", "b/a.png", "verify-out/b/a-got.png", "j.xml"})
        EXPECT_TRUE(is_mine(name)) << name;
}

TEST_F(ReplacedFiles, AnUnknownEndingIsRefusedBeforeAnythingIsRead) {
    const auto refused = [&](const Words& words, const std::string& what) {
        expect_refused(words, what + "\n");
    };
    refused({"still", "no.toml", "-o", "a.gif"},
            "a.gif: the name of a picture must end in .png, .jpg, .jpeg, .webp, .tif, .tiff, .exr");
    refused({"compare", "no.png", "no.png", "--diff", "d.jpg"},
            "d.jpg: the name of a picture must end in .png");
    refused({"verify", "no.toml", "--junit", "j.html"},
            "j.html: the name of a JUnit report must end in .xml");
    refused({"hop-law", "no.toml", "-o", "law.txt"},
            "law.txt: the name of a scene must end in .toml");
    refused({"hop-law", "no.toml", "-o", "law.toml", "--flights", "f.tsv"},
            "f.tsv: the name of a table must end in .csv");
    refused({"run", "scene.toml", "-o", "/"},
            "/ is the root of the file system; name a folder for the run with -o");
    for (const char* command : {"sweep", "figure", "verify"}) {
        write_text(folder_ / "b.toml", command == std::string("verify")
                                           ? "[cases]\na = {scene = \"scene.toml\"}\n"
                                           : small_scene() + "[[figure.panel]]\nkind = \"map\"\n");
        const Ended ended = run(
            {command, "b.toml", "-o", "/", command == std::string("sweep") ? "--seeds=1" : "-q"});
        EXPECT_EQ(ended.status, 2);
        EXPECT_NE(ended.errors.find("is the root of the file system"), std::string::npos)
            << ended.errors;
    }
}

/// Each would compute for hours.
TEST_F(ReplacedFiles, AnOutputThatCannotBeWrittenIsFoundBeforeTheComputation) {
    const Words endless{"--set", "run.steps=1000000000", "--set", "frames.every=1000000000"};
    const auto refused = [&](Words words, const std::string& what) {
        words.insert(words.end(), endless.begin(), endless.end());
        const Ended ended = run(words);
        EXPECT_EQ(ended.status, 3) << ended.errors;
        EXPECT_EQ(ended.errors, what + "\n");
    };
    refused({"still", "scene.toml", "-o", "no/a.png"},
            "cannot write no/a.png: No such file or directory");
    const std::string made = ": a file of this name exists";
    refused({"run", "scene.toml", "-o", "bed.asc/out"},
            "cannot make the folder bed.asc/out" + made);
    refused({"sweep", "scene.toml", "-o", "bed.asc/out", "--seeds", "1"},
            "cannot make the folder bed.asc/out" + made);
    write_text(folder_ / "page.toml", small_scene() + "[[figure.panel]]\nkind = \"map\"\n");
    refused({"figure", "page.toml", "-o", "bed.asc/out"},
            "cannot make the folder bed.asc/out" + made);
    refused({"figure", "page.toml", "-o", "out", "--runs", "bed.asc/out"},
            "cannot make the folder bed.asc/out" + made);
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    write_text(folder_ / "b.toml",
               "[cases]\na = {scene = \"scene.toml\", settings = [\"run.steps=400000\"]}\n");
    EXPECT_EQ(run({"verify", "b.toml", "-o", "bed.asc/out"}).errors,
              "cannot make the folder bed.asc/out" + made + "\n");
    EXPECT_EQ(run({"verify", "b.toml", "--junit", "no/j.xml"}).errors,
              "cannot write no/j.xml: No such file or directory\n");
    foreign("file/frames");
    expect_refused({"run", "scene.toml", "-o", "file", "--force"},
                   "file/frames is a file; name a folder for the run with -o\n");
    foreign("rows/beds");
    EXPECT_EQ(plain_run("rows", {"--set", "output.bed_every=5"}).errors,
              "rows/beds is a file; name a folder for the run with -o\n");
    EXPECT_EQ(plain_run("rows").status, 0) << "a run without beds has no use for that name";
    EXPECT_TRUE(is_mine("rows/beds"));
}

TEST_F(ReplacedFiles, VerifyStaysOutOfAFolderInWhichAnotherIsAtWork) {
    fs::create_directory(folder_ / "out");
    const FolderLock lock(folder_ / "out");
    write_text(folder_ / "b.toml", "[cases]\na = {scene = \"scene.toml\"}\n");
    expect_refused({"verify", "b.toml", "-o", "out"},
                   "another fumon is working in out; wait for it or name another folder\n");
    EXPECT_TRUE(fs::is_empty(folder_ / "out"));
}

}  // namespace
}  // namespace fumon::test
