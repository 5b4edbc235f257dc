#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "picture/png.h"
#include "support/missing_library.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// A scratch folder with the small scene in it.
class RunTest : public ::testing::Test {
  protected:
    void SetUp() override { write_text(folder_ / "scene.toml", small_scene()); }

    Ended run(std::vector<std::string> more, const std::string& output = "out",
              const std::vector<std::string>& environment = {}) {
        std::vector<std::string> arguments{"run", "scene.toml", "-o", output, "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return fumon(arguments, folder_.path(), environment);
    }

    ScratchFolder folder_;
};

std::vector<std::string> pixel_hashes(const nlohmann::json& manifest) {
    std::vector<std::string> hashes;
    for (const auto& frame : manifest["frames"]) hashes.push_back(frame["pixels_sha256"]);
    return hashes;
}

TEST_F(RunTest, MakesFramesMovieMeasurementsBedsAndManifest) {
    const Ended ended = run({"--set", "output.bed_at=[10, 20]"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const auto manifest = read_manifest(folder_ / "out");
    EXPECT_EQ(manifest["status"], "complete");
    EXPECT_EQ(manifest["steps_done"], 20);
    ASSERT_EQ(manifest["frames"].size(), 5U);
    for (const auto& frame : manifest["frames"]) {
        EXPECT_EQ(frame["step"], 5 * frame["number"].get<int>());
        const Image image = read_png(folder_ / "out" / frame["file"].get<std::string>());
        EXPECT_EQ(image.width, 64);
        EXPECT_EQ(image.height, 48);
    }
    EXPECT_EQ(manifest["movie"]["frames"], 5);
    EXPECT_TRUE(fs::exists(folder_ / "out" / "movie.mp4"));
    EXPECT_EQ(manifest["beds"].size(), 2U);
    EXPECT_TRUE(fs::exists(folder_ / "out" / "beds/bed_00000010.asc"));
    EXPECT_EQ(manifest["scene"]["run"]["steps"], 20);
    EXPECT_GT(manifest["performance"]["cell_steps_per_second"].get<double>(), 0.0);
    EXPECT_GT(manifest["performance"]["peak_memory_bytes"].get<double>(), 1e6);
    for (const char* stage : {"simulation", "rendering", "encoding"}) {
        EXPECT_GT(manifest["performance"][std::string(stage) + "_seconds"].get<double>(), 0.0)
            << stage;
        EXPECT_GT(manifest["performance"][std::string(stage) + "_cpu_seconds"].get<double>(), 0.0)
            << stage;
    }

    const std::string csv = read_text(folder_ / "out" / "measurements.csv");
    EXPECT_TRUE(csv.starts_with("step,time,mean_height,standard_deviation,")) << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out")) {
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
    }
}

TEST_F(RunTest, TheSameForAnyNumberOfThreadsAndTwiceInARow) {
    ASSERT_EQ(run({"--threads", "1"}, "reference").status, 0);
    const auto reference = read_manifest(folder_ / "reference");
    const std::string frame = read_text(folder_ / "reference/frames/frame_000004.png");
    const std::string movie = read_text(folder_ / "reference/movie.mp4");
    for (const std::string threads : {"1", "2", "3", "8"}) {
        const std::string output = "threads" + threads;
        ASSERT_EQ(run({"--threads", threads}, output, {"LP_NUM_THREADS=" + threads}).status, 0);
        const auto manifest = read_manifest(folder_ / output);
        EXPECT_EQ(manifest["state_sha256"], reference["state_sha256"]) << threads << " threads";
        EXPECT_EQ(pixel_hashes(manifest), pixel_hashes(reference)) << threads << " threads";
        EXPECT_EQ(read_text(folder_ / output / "frames/frame_000004.png"), frame)
            << "the same bytes";
        EXPECT_EQ(read_text(folder_ / output / "movie.mp4"), movie) << "the same bytes";
    }
}

TEST_F(RunTest, AnotherSeedIsAnotherRun) {
    ASSERT_EQ(run({}, "a").status, 0);
    ASSERT_EQ(run({"--set", "seed=6"}, "b").status, 0);
    EXPECT_NE(read_manifest(folder_ / "a")["state_sha256"],
              read_manifest(folder_ / "b")["state_sha256"]);
}

TEST_F(RunTest, OSMesaAndEglDrawTheSamePixels) {
    const Ended osmesa = run({"--gl", "osmesa"}, "osmesa");
    const Ended egl = run({"--gl", "egl"}, "egl");
    if (library_is_missing(osmesa.errors + egl.errors)) {
        GTEST_SKIP() << osmesa.errors << egl.errors;
    }
    ASSERT_EQ(osmesa.status, 0) << osmesa.errors;
    ASSERT_EQ(egl.status, 0) << egl.errors;
    EXPECT_EQ(pixel_hashes(read_manifest(folder_ / "osmesa")),
              pixel_hashes(read_manifest(folder_ / "egl")));
}

TEST_F(RunTest, AFolderThatHoldsARunIsKept) {
    ASSERT_EQ(run({}).status, 0);
    const std::string before = read_text(folder_ / "out/run.json");
    const Ended refused = run({});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.errors,
              "out already holds a run; name another folder, or replace it with --force\n");
    EXPECT_EQ(read_text(folder_ / "out/run.json"), before);

    ASSERT_EQ(run({"--force", "--set", "frames.every=10"}).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/frames/frame_000003.png"))
        << "the former run's frames are gone";
}

TEST_F(RunTest, BadInputWritesNothing) {
    for (const char* setting : {"sun.elevation=100", "look.palette=virids", "model.nam=x",
                                "bed.kind=file", "look.colour_by=water-depth"}) {
        const Ended ended = run({"--set", setting});
        EXPECT_EQ(ended.status, 2) << setting;
        EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "out")) << setting;
    }
}

TEST_F(RunTest, AWrittenBedIsATerrainToStartFrom) {
    ASSERT_EQ(run({"--set", "grid.cell_size=0.5", "--set", "grid.height_unit=0.25", "--set",
                   "output.bed_at=[20]"})
                  .status,
              0);
    const Ended again = run({"--set", "grid.height_unit=0.25", "--set", "bed.kind=file", "--set",
                             "bed.file=out/beds/bed_00000020.asc", "--set", "output.bed_at=[0]"},
                            "again");
    ASSERT_EQ(again.status, 0) << again.errors;
    EXPECT_EQ(read_text(folder_ / "again/beds/bed_00000000.asc"),
              read_text(folder_ / "out/beds/bed_00000020.asc"));
    EXPECT_EQ(read_manifest(folder_ / "again")["grid"]["dx"], 0.5);
}

TEST_F(RunTest, AnOddSizeIsPaddedInTheMovieAndSaid) {
    const Ended ended = fumon(
        {"run", "scene.toml", "-o", "out", "--set", "image.width=65", "--set", "image.height=49"},
        folder_.path());
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(ended.errors.find("movie.mp4 is 66 x 50"), std::string::npos) << ended.errors;
    EXPECT_EQ(read_manifest(folder_ / "out")["movie"]["width"], 66);
    EXPECT_EQ(read_png(folder_ / "out/frames/frame_000000.png").width, 65);
}

TEST_F(RunTest, TheMovieHasTheQualityThatIsAsked) {
    const auto size = [&](const std::string& quality) {
        const std::string folder = "quality" + quality;
        const Ended ended = run({"--set", "run.steps=1", "--set", "frames.every=1", "--set",
                                 "output.movie_quality=" + quality},
                                folder);
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return fs::file_size(folder_ / folder / "movie.mp4");
    };
    EXPECT_GT(2 * size("0"), 3 * size("51"));
}

TEST_F(RunTest, StillsAndAgainGiveTheFrameOfTheRun) {
    ASSERT_EQ(run({"--set", "camera.turn=90"}).status, 0);
    ASSERT_EQ(fumon({"still", "scene.toml", "--step", "15", "-o", "still.png", "-q", "--set",
                     "camera.turn=90"},
                    folder_.path())
                  .status,
              0);
    const std::string frame = read_text(folder_ / "out/frames/frame_000003.png");
    EXPECT_EQ(read_text(folder_ / "still.png"), frame)
        << "a still of step 15 is the run's frame of step 15";

    const Ended again = fumon({"again", "out/frames/frame_000003.png"}, folder_.path());
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_NE(again.errors.find("the same pixels"), std::string::npos) << again.errors;
    EXPECT_EQ(read_text(folder_ / "frame_000003-again.png"), frame);
    EXPECT_EQ(fumon({"still", "scene.toml", "--time", "15", "-o", "time.png", "-q", "--set",
                     "camera.turn=90"},
                    folder_.path())
                  .status,
              0);
    EXPECT_EQ(read_text(folder_ / "time.png"), frame);
}

TEST_F(RunTest, ASunThatWandersIsFoundAgain) {
    const std::vector<std::string> sun{
        "--set", "sun.place=[23, 5]", "--set", "sun.time=2026-03-20T06:30Z",
        "--set", "sun.hours=5",       "--set", "look.preset=golden-hour"};
    ASSERT_EQ(run(sun).status, 0);
    std::vector<std::string> still{"still", "scene.toml", "--step", "15", "-o", "still.png", "-q"};
    still.insert(still.end(), sun.begin(), sun.end());
    ASSERT_EQ(fumon(still, folder_.path()).status, 0);
    const std::string frame = read_text(folder_ / "out/frames/frame_000003.png");
    EXPECT_EQ(read_text(folder_ / "still.png"), frame);
    const Ended again = fumon({"again", "out/frames/frame_000003.png"}, folder_.path());
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_EQ(read_text(folder_ / "frame_000003-again.png"), frame);
}

TEST_F(RunTest, APictureOfATerrainFindsItsFileAgainAndNoticesAChange) {
    const std::string terrain =
        "ncols 3\nnrows 4\ncellsize 10\nxllcorner 0\nyllcorner 0\n1 2 3\n4 5 6\n7 8 9\n1 2 3\n";
    fs::create_directories(folder_ / "data");
    write_text(folder_ / "data/bed.asc", terrain);
    const std::vector<std::string> small{"--set", "image.width=64", "--set", "image.height=48",
                                         "-q"};
    std::vector<std::string> arguments{"still", "data/bed.asc", "-o", "picture.png"};
    arguments.insert(arguments.end(), small.begin(), small.end());
    ASSERT_EQ(fumon(arguments, folder_.path()).status, 0);
    const std::string picture = read_text(folder_ / "picture.png");

    ASSERT_EQ(fumon({"again", "picture.png"}, folder_.path()).status, 0);
    EXPECT_EQ(read_text(folder_ / "picture-again.png"), picture) << "the same bytes";
    const Ended elsewhere =
        fumon({"again", "../picture.png", "-o", "../again.png"}, folder_ / "data");
    EXPECT_EQ(elsewhere.status, 0) << "found beside the picture: " << elsewhere.errors;

    write_text(folder_ / "data/bed.asc", terrain + "\n");
    const Ended changed = fumon({"again", "picture.png", "-o", "changed.png"}, folder_.path());
    EXPECT_EQ(changed.status, 2);
    EXPECT_NE(changed.errors.find("picture.png: data/bed.asc as it was when the picture was made"),
              std::string::npos)
        << changed.errors;
    fs::remove(folder_ / "data/bed.asc");
    EXPECT_EQ(fumon({"again", "picture.png", "-o", "gone.png"}, folder_.path()).status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "changed.png"));
}

void wait_for(const fs::path& file) {
    for (int tries = 0; tries < 600 && !fs::exists(file); ++tries) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

TEST_F(RunTest, AnInterruptKeepsWhatWasMade) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string output = "out" + std::to_string(signal);
        Program program({"run", "scene.toml", "-o", output, "--set", "run.steps=100000000"},
                        folder_.path());
        wait_for(folder_ / output / "frames/frame_000002.png");
        program.send(signal);
        const Ended ended = program.wait();
        EXPECT_EQ(ended.status, 128 + signal) << ended.errors;
        const auto manifest = read_manifest(folder_ / output);
        EXPECT_EQ(manifest["status"], "interrupted");
        EXPECT_EQ(manifest["signal"], signal == SIGINT ? "SIGINT" : "SIGTERM");
        EXPECT_GE(manifest["frames"].size(), 3U);
        EXPECT_EQ(manifest["movie"]["frames"], manifest["frames"].size());
        std::size_t files = 0;
        for (const auto& entry : fs::directory_iterator(folder_ / output / "frames")) {
            EXPECT_EQ(entry.path().extension(), ".png");
            EXPECT_NO_THROW(read_png(entry.path()));
            ++files;
        }
        EXPECT_EQ(files, manifest["frames"].size()) << "the manifest lists what is there";
        EXPECT_TRUE(fs::exists(folder_ / output / "movie.mp4"));
        EXPECT_TRUE(fs::exists(folder_ / output / "measurements.csv"));
    }
}

TEST_F(RunTest, AMissingOutputDeviceIsReportedOnce) {
    write_text(folder_ / "file", "in the way");
    const Ended ended = run({}, "file/out");
    EXPECT_EQ(ended.status, 3);
    EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
    EXPECT_NE(ended.errors.find("cannot make the folder file/out"), std::string::npos)
        << ended.errors;
}

TEST_F(RunTest, AFullDiskKeepsEarlierFramesAndIsReportedOnce) {
    const fs::path disk = folder_ / "disk";
    fs::create_directory(disk);
    const std::string mount = "mount -t tmpfs -o size=256k tmpfs " + disk.string() + " 2>/dev/null";
    if (std::system(mount.c_str()) != 0)
        GTEST_SKIP() << "cannot mount a small tmpfs here (needs root)";
    const Ended ended = run({"--set", "run.steps=5000", "--set", "output.movie=false"}, "disk/out");
    EXPECT_EQ(ended.status, 3);
    EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
    EXPECT_NE(ended.errors.find("No space left on device"), std::string::npos) << ended.errors;
    std::size_t frames = 0;
    for (const auto& entry : fs::directory_iterator(disk / "out/frames")) {
        EXPECT_EQ(entry.path().extension(), ".png") << "no half-written file";
        EXPECT_NO_THROW(read_png(entry.path()));
        ++frames;
    }
    EXPECT_GT(frames, 0U);
    EXPECT_EQ(std::system(("umount " + disk.string()).c_str()), 0);
}

TEST_F(RunTest, MeasurementsAloneNeedNoPictures) {
    const Ended ended = run({"--set", "output.frames=false", "--set", "output.movie=false"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_FALSE(fs::exists(folder_ / "out/frames"));
    EXPECT_TRUE(fs::exists(folder_ / "out/measurements.csv"));
}

TEST_F(RunTest, ALongRunNeedsNoMoreMemoryThanAShortOne) {
#ifdef FUMON_SANITIZED
    GTEST_SKIP() << "sanitizers keep freed memory for a while, so peaks mean nothing";
#endif
    const auto peak = [&](const std::string& frames) {
        const std::string output = "frames" + frames;
        EXPECT_EQ(
            run({"--set", "run.steps=" + frames, "--set", "frames.every=1", "--set",
                 "image.width=16", "--set", "image.height=16", "--set", "image.supersampling=1"},
                output)
                .status,
            0);
        const auto manifest = read_manifest(folder_ / output);
        EXPECT_EQ(manifest["frames"].size(), std::stoul(frames) + 1);
        return manifest["performance"]["peak_memory_bytes"].get<double>();
    };
    const double short_run = peak("100");
    EXPECT_LE(peak("4000"), 1.05 * short_run);
}

}  // namespace
}  // namespace fumon::test
