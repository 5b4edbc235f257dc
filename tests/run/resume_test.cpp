#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <thread>

#include "files/checkpoint.h"
#include "files/hash.h"
#include "run/build_identity.h"
#include "run/run_checkpoint.h"
#include "support/full_disk.h"
#include "support/program.h"
#include "support/resumed_run.h"
#include "support/same_run.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

TEST_F(ResumeTest, AKilledRunWithPicturesEndsAsAnUninterruptedOne) {
    scene(resumed_scene("name = \"sand\"\n", 40, 30, 900,
                        "[frames]\nevery = 10\n[output]\nfields_every = 30\nbed_every = 100\n"));
    uninterrupted();
    EXPECT_EQ(stop({"run", "scene.toml", "-o", "out"}, SIGKILL).status, 128 + SIGKILL);
    EXPECT_EQ(read_manifest(out())["status"], "running");
    EXPECT_EQ(stop({"run", "--resume", "out"}, SIGKILL).status, 128 + SIGKILL);
    const Ended last = run({"run", "--resume", "out"});
    EXPECT_EQ(last.status, 0);
    EXPECT_EQ(last.errors.rfind("resumes at step ", 0), 0U) << last.errors;
    expect_same_run(out("whole"), out());
    EXPECT_EQ(read_manifest(out())["resumed_at_steps"].size(), 2U);
}

TEST_F(ResumeTest, AMovieWithoutFramesIsMadeFromFramesThatAreKeptUntilThen) {
    scene(resumed_scene("name = \"sandpile\"\ngrains_per_step = 30\n", 20, 20, 400,
                        "[frames]\nevery = 4\n[output]\nframes = false\n"));
    uninterrupted();
    EXPECT_EQ(stop({"run", "scene.toml", "-o", "out"}, SIGINT).status, 130);
    EXPECT_TRUE(fs::exists(out() / "movie_frames/frame_000000.png"));
    EXPECT_TRUE(fs::exists(out() / "movie.mp4")) << "what was made";
    EXPECT_EQ(run({"run", "--resume", "out", "-q"}).status, 0);
    expect_same_run(out("whole"), out());
    EXPECT_FALSE(fs::exists(out() / "movie_frames"));

    EXPECT_EQ(run({"run", "scene.toml", "-o", "none", "-q", "--checkpoint-every", "0"}).status, 0);
    expect_same_run(out("whole"), out("none"));
}

class ResumedModel : public ResumeTest, public ::testing::WithParamInterface<int> {};

TEST_P(ResumedModel, KilledAndStoppedItEndsAsIfItHadNotBeen) {
    const std::string output =
        std::string(output_without_pictures) + "fields_every = 30\nbed_every = 90\n";
    const std::string scenes[] = {
        sand_scene(4000),
        resumed_scene("name = \"sand\"\norder = \"random-sequential\"\ncreep = \"profile\"\n", 9000,
                      1, 1500, output),
        resumed_scene("name = \"sandpile\"\norder = \"first-in-first-out\"\ndrop_direction = "
                      "\"cycling\"\ngrains_per_step = 25\n",
                      30, 30, 5000, output),
        resumed_scene("name = \"gully\"\ntransport = \"as-printed\"\n", 40, 40, 600,
                      output + "[bed]\nhigh = 0.01\n"),
        resumed_scene(
            "name = \"airflow\"\nnz = 20\nflights = true\nshown_paths = 3\nbed_amplitude = "
            "0.1\nlid_speed = 0.2\nlaunch_angles = [10.0]\n",
            50, 1, 3000, output),
    };
    scene(scenes[GetParam()]);
    uninterrupted();
    EXPECT_EQ(stop({"run", "scene.toml", "-o", "out"}, SIGKILL).status, 128 + SIGKILL);
    EXPECT_EQ(stop({"run", "--resume", "out"}, SIGTERM).status, 143);
    const auto stopped = read_manifest(out());
    EXPECT_EQ(stopped["status"], "interrupted");
    EXPECT_EQ(stopped["checkpoint"]["step"], stopped["steps_done"]);
    EXPECT_EQ(run({"run", "scene.toml", "--resume", "out", "-q", "--threads", "3"}).status, 0);
    expect_same_run(out("whole"), out());
    EXPECT_EQ(read_manifest(out())["resumed_at_steps"].back(), stopped["steps_done"]);
}

INSTANTIATE_TEST_SUITE_P(Every, ResumedModel, ::testing::Range(0, 5));

TEST_F(ResumeTest, WhatIsSaidOfARunThatCannotOrNeedNotGoOn) {
    scene(sand_scene(30));
    expect_refusal({"run", "--resume", "out"}, "out holds no run to resume");
    ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "-q"}).status, 0);
    const Ended complete = run({"run", "--resume", "out"});
    EXPECT_EQ(complete.status, 0);
    EXPECT_EQ(complete.errors, "out: the run is complete, nothing is left to do\n");
    auto manifest = read_manifest(out());
    manifest["status"] = "running";
    write_text(out() / "run.json", manifest.dump());
    fs::remove(out() / "checkpoint.fumon");
    expect_refusal({"run", "--resume", "out"}, "stopped before its first checkpoint");
    expect_refusal({"run", "--resume", "scene.toml"}, "scene.toml is a file");
    expect_refusal({"run", "--resume", "out", "-o", "other"}, "do not go together");
    expect_refusal({"run", "-o", "other"}, "name a scene");
    expect_refusal({"run", "scene.toml"}, "name a folder");
}

TEST_F(ResumeTest, ADamagedOrForeignCheckpointIsRefusedWithTheReason) {
    stopped_sand();
    const fs::path file = out() / "checkpoint.fumon";
    const std::string whole = read_text(file);
    const std::string manifest = read_text(out() / "run.json");
    for (const std::size_t at : {std::size_t{0}, std::size_t{8}, std::size_t{14}, std::size_t{60},
                                 whole.size() / 2, whole.size() - 36, whole.size() - 1}) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        write_text(file, damaged);
        expect_refusal({"run", "--resume", "out"}, "out/checkpoint.fumon: ");
    }
    write_text(file, whole.substr(0, whole.size() / 3));
    expect_refusal({"run", "--resume", "out"}, "is cut short or damaged");
    write_text(file, "");
    expect_refusal({"run", "--resume", "out"}, "is not a checkpoint of fumon");
    RunCheckpoint other;
    other.version = "0.0.9";
    {
        CheckpointWriter writer(file);
        other.serialise(writer);
        writer.commit();
    }
    expect_refusal({"run", "--resume", "out"},
                   "was written by fumon 0.0.9, this is " FUMON_VERSION ";");
    other.version = FUMON_VERSION;
    other.build.sources = "0123456789abcdef";
    {
        CheckpointWriter writer(file);
        other.serialise(writer);
        writer.commit();
    }
    expect_refusal({"run", "--resume", "out"}, "was written by fumon " FUMON_VERSION
                                               " from sources 0123456789ab, this is from sources " +
                                                   short_sources(this_build()) + ";");
    EXPECT_EQ(read_text(out() / "run.json"), manifest) << "nothing has changed";
    EXPECT_TRUE(fs::exists(out() / "measurements.csv"));
}

TEST_F(ResumeTest, TheSameSourcesHaveOneIdentityWhereverTheyLie) {
    std::set<std::string> written;
    const auto identity = [&](const std::string& root) {
        const Ended ended = fumon({"-D", "ROOT=" + (folder_ / root).string(), "-D", "TOOLS=a b",
                                   "-D", "TO=" + (folder_ / "identity.cpp").string(), "-P",
                                   FUMON_SOURCES_FOLDER "/build_identity.cmake"},
                                  folder_.path(), {}, FUMON_CMAKE);
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return read_text(folder_ / "identity.cpp");
    };
    for (const char* root : {"one", "two"}) {
        for (const char* folder : {"src/base", "shaders/sky", "assets/palettes"})
            fs::create_directories(folder_ / root / folder);
        for (const char* file : {"CMakeLists.txt", "src/CMakeLists.txt", "src/base/a.cpp",
                                 "src/base/a.h", "shaders/sky/a.glsl", "assets/palettes/a.txt"})
            write_text(folder_ / root / file, file);
    }
    const std::string one = identity("one");
    EXPECT_NE(one.find("R\"(a b)\""), std::string::npos) << one;
    write_text(folder_ / "two/src/base/a.cpp~", "an editor's");
    EXPECT_EQ(identity("two"), one);
    for (const char* file : {"src/base/a.h", "shaders/sky/a.glsl", "assets/palettes/a.txt"}) {
        write_text(folder_ / "two" / file, "changed");
        EXPECT_TRUE(written.insert(identity("two")).second) << file;
    }
    fs::rename(folder_ / "one/src/base/a.cpp", folder_ / "one/src/base/b.cpp");
    EXPECT_NE(identity("one"), one);
    EXPECT_FALSE(written.contains(one));
}

TEST_F(ResumeTest, AnotherBuildOfTheSameSourcesGoesOnAndSaysSo) {
    scene(sand_scene(3000));
    uninterrupted();
    ASSERT_EQ(stop({"run", "scene.toml", "-o", "out"}, SIGINT).status, 130);
    const fs::path file = out() / "checkpoint.fumon";
    std::string bytes = read_text(file);
    const std::string tools = this_build().tools;
    const std::size_t at = bytes.find(tools);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, 3, "XYZ");  // as long, and with the hash that belongs to it
    const std::string_view hashed(bytes.data(), bytes.size() - 32);
    const Sha256 hash = text_hash(hashed);
    std::copy(hash.begin(), hash.end(), bytes.end() - 32);
    write_text(file, bytes);
    const Ended ended = run({"run", "--resume", "out"});
    EXPECT_EQ(ended.status, 0);
    EXPECT_NE(ended.errors.find("from the same sources built otherwise: XYZ" + tools.substr(3) +
                                " then, " + tools + " now\n"),
              std::string::npos)
        << ended.errors;
    expect_same_run(out("whole"), out());
}

TEST_F(ResumeTest, AnotherSceneIsRefusedAndTheSameOneTaken) {
    stopped_sand();
    expect_refusal({"run", "scene.toml", "--resume", "out", "--set", "model.creep_rate=0.3"},
                   "its scene has model.creep_rate = 0.15, now 0.3");
    expect_refusal({"run", "--resume", "out", "--set", "run.steps=9"},
                   "its scene has run.steps = 20000, now 9");
    expect_refusal({"run", "scene.toml", "-o", "out"}, "continue it with --resume");
    Program again({"run", "scene.toml", "--resume", "out", "-q"}, folder_.path());
    wait_for([&] { return read_manifest(out())["status"] == "running"; });
    again.send(SIGKILL);
}

TEST_F(ResumeTest, TwoProgramsInOneFolderAreRefused) {
    scene(sand_scene(1'000'000));
    Program first({"run", "scene.toml", "-o", "out", "-q"}, folder_.path());
    wait_for([&] { return fs::exists(out() / "run.json"); });
    const std::string said = "another fumon is working in out; wait for it or name another folder";
    expect_refusal({"run", "--resume", "out"}, said);
    expect_refusal({"run", "scene.toml", "-o", "out", "--force"}, said);
    first.send(SIGKILL);
    EXPECT_EQ(first.wait().status, 128 + SIGKILL);
    expect_refusal({"run", "--resume", "out"}, "before its first checkpoint");
}

TEST_F(ResumeTest, FromAnotherFolderTheTerrainIsFoundAndAChangeNoticed) {
    fs::create_directories(folder_ / "data");
    fs::create_directories(folder_ / "elsewhere");
    std::string grid = "ncols 30\nnrows 30\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (int cell = 0; cell < 900; ++cell) grid += std::to_string(cell % 7) + " ";
    write_text(folder_ / "data/bed.asc", grid);
    scene(
        "[model]\nname = \"sand\"\n[bed]\nkind = \"file\"\nfile = \"data/bed.asc\"\n[run]\nsteps "
        "= 10000\n" +
        std::string(output_without_pictures));
    uninterrupted();
    ASSERT_EQ(stop({"run", "scene.toml", "-o", "out"}, SIGINT).status, 130);
    write_text(folder_ / "data/bed.asc", grid + "\n");
    expect_refusal({"run", "--resume", "out"}, "data/bed.asc as it was when the run was made");
    write_text(folder_ / "data/bed.asc", grid);
    write_text(folder_ / "data/bed.prj", "PROJCS[\"a\",UNIT[\"Foot_US\",0.3048006]]");
    expect_refusal({"run", "--resume", "out"}, "but files that belong to it");
    fs::remove(folder_ / "data/bed.prj");
    write_text(out() / "checkpoint.fumon.part", "what a failing disk left");
    const Ended ended = fumon({"run", "--resume", "../out", "-q"}, folder_ / "elsewhere");
    EXPECT_EQ(ended.status, 0) << ended.errors;
    expect_same_run(out("whole"), out());
}

TEST_F(ResumeTest, AFullDiskForACheckpointDoesNotEndTheRun) {
    fs::create_directories(out("small"));
    const SmallDisk disk(out("small"), 256);
    if (!disk.mounted()) GTEST_SKIP() << "cannot mount a small tmpfs here (needs root)";
    scene(resumed_scene("name = \"sand\"\n", 250, 200, 60));
    const Ended ended =
        run({"run", "scene.toml", "-o", "small/out", "--checkpoint-every", "0.00001"});
    EXPECT_EQ(ended.status, 0) << ended.errors;
    EXPECT_TRUE(ended.errors.starts_with("no checkpoint of step ")) << ended.errors;
    EXPECT_NE(
        ended.errors.find(": cannot write small/out/checkpoint.fumon: No space left on device; "
                          "the run continues\n"),
        std::string::npos)
        << ended.errors;
    EXPECT_EQ(read_manifest(out("small/out"))["status"], "complete");
    EXPECT_EQ(files_of_run(out("small/out")), std::set<std::string>{"measurements.csv"});
}

TEST_F(ResumeTest, AFrameThatIsGoneOrChangedIsNoticed) {
    scene(resumed_scene("name = \"static\"\n", 12, 12, 100000, "[frames]\nevery = 10\n"));
    ASSERT_EQ(stop({"run", "scene.toml", "-o", "out"}, SIGINT).status, 130);
    fs::remove(out() / "frames/frame_000000.png");
    expect_refusal({"run", "--resume", "out"}, "out/frames/frame_000000.png: does not exist");
    ASSERT_EQ(run({"still", "scene.toml", "--step", "0", "--set", "sun.elevation=9", "-o",
                   "out/frames/frame_000000.png"})
                  .status,
              0);
    const Ended changed = run({"run", "--resume", "out", "-q"});
    EXPECT_EQ(changed.status, 2);
    EXPECT_EQ(changed.errors,
              "out/frames/frame_000000.png: has changed since it was written; restore it as it "
              "was, or run the scene from its start with --force\n");
}

TEST_F(ResumeTest, TheListOfFramesIsKeptAsLongAsItIsNeeded) {
    scene(resumed_scene("name = \"static\"\n", 12, 12, 100000, "[frames]\nevery = 10\n"));
    ASSERT_EQ(stop({"run", "scene.toml", "-o", "out"}, SIGINT).status, 130);
    const fs::path file = out() / "frames.fumon";
    const std::string bytes = read_text(file);
    EXPECT_EQ(bytes.size(), 80 * read_manifest(out())["frames"].size());
    std::string damaged = bytes;
    damaged[20] = static_cast<char>(damaged[20] ^ 4);
    write_text(file, damaged);
    expect_refusal({"run", "--resume", "out"}, "out/frames.fumon: has changed");
    write_text(file, bytes.substr(0, 40));
    expect_refusal({"run", "--resume", "out"}, "out/frames.fumon: has 40 bytes of ");
    fs::remove(file);
    expect_refusal({"run", "--resume", "out"}, "out/frames.fumon: does not exist");

    Program endless({"run", "scene.toml", "-o", "none", "-q", "--checkpoint-every", "0"},
                    folder_.path());
    wait_for([&] { return fs::exists(out("none") / "frames/frame_000002.png"); });
    endless.send(SIGINT);
    EXPECT_EQ(endless.wait().status, 130);
    EXPECT_FALSE(fs::exists(out("none") / "frames.fumon"))
        << "no checkpoint, nothing to go on from";
    EXPECT_GE(read_manifest(out("none"))["frames"].size(), 3U);
}

TEST(CheckpointClock, CheckpointsTakeAFiftiethAtMost) {
    CheckpointClock never(0.0);
    EXPECT_FALSE(never.on());
    EXPECT_FALSE(never.due());
    CheckpointClock clock(1e-6);
    wait_for([&] { return clock.due(); });
    clock.begin();
    std::this_thread::sleep_for(std::chrono::milliseconds(4));
    clock.end();
    const auto ended = std::chrono::steady_clock::now();
    wait_for([&] { return clock.due(); });
    EXPECT_GE(std::chrono::steady_clock::now() - ended, std::chrono::milliseconds(50 * 4));
}

TEST_F(ResumeTest, AMovieIsMadeAgainFromItself) {
    scene(small_scene());
    ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "-q"}).status, 0);
    const Ended again = run({"again", "out/movie.mp4", "-o", "again.mp4"});
    EXPECT_EQ(again.status, 0);
    EXPECT_EQ(again.errors, "again.mp4: the same bytes as out/movie.mp4\n");
    EXPECT_EQ(read_text(folder_ / "again.mp4"), read_text(out() / "movie.mp4"));
    EXPECT_EQ(fs::exists(folder_ / "again.mp4.part"), false);
    const Ended odd = run({"again", "out/movie.mp4", "-o", "odd.mp4", "--set", "image.width=63"});
    EXPECT_NE(odd.errors.find("odd.mp4 is 64 x 48: H.264 needs even sides"), std::string::npos)
        << odd.errors;

    std::string other = read_text(out() / "movie.mp4");
    const std::size_t encoder = other.find("libavcodec ");
    ASSERT_NE(encoder, std::string::npos);
    const std::string newer = other.substr(encoder, std::string("libavcodec 5").size());
    for (const auto& [then, now] :
         {std::pair<std::string, std::string>{newer, "libavcodec 4"}, {"llvmpipe", "softpipe"}}) {
        ASSERT_NE(other.find(then), std::string::npos);
        other.replace(other.find(then), then.size(), now);
    }
    write_text(folder_ / "other.mp4", other);
    const Ended differing = run({"again", "other.mp4"});
    EXPECT_EQ(differing.status, 0);
    EXPECT_EQ(differing.errors.rfind("other-again.mp4: the same frames as other.mp4, encoded "
                                     "otherwise; ",
                                     0),
              0U)
        << differing.errors;
    EXPECT_NE(differing.errors.find("softpipe"), std::string::npos) << differing.errors;
    EXPECT_NE(differing.errors.find("; encoder was libavcodec 4"), std::string::npos);
    EXPECT_EQ(run({"again", "out/movie.mp4", "-o", "low.mp4", "--set", "sun.elevation=9"}).errors,
              "low.mp4: made\n");
    write_text(folder_ / "cut.mp4", other.substr(0, 200));
    expect_refusal({"again", "cut.mp4"}, "cut.mp4: ");
}

}  // namespace
}  // namespace fumon::test
