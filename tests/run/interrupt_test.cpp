#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

#include "base/cancellation.h"
#include "base/stopwatch.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// Waits until something holds, at most a minute.
bool comes_true(const std::function<bool()>& holds) {
    for (const Stopwatch watch; watch.seconds() < 60.0;) {
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

/// A pile whose first step lasts for hours: a thousand million grains.
std::string endless_step() {
    return "[grid]\nnx = 300\nny = 300\n[model]\nname = \"sandpile\"\ngrains_per_step = "
           "1000000000\n[run]\nsteps = 2\n[frames]\nevery = 1\n[image]\nwidth = 64\nheight = 48\n";
}

TEST(Interrupt, EndsAStepThatLastsForHoursWithinTwoSeconds) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml", endless_step());
    Program program({"run", "scene.toml", "-o", "out"}, folder.path());
    ASSERT_TRUE(comes_true([&] { return fs::exists(folder / "out/frames/frame_000000.png"); }));
    const Stopwatch watch;
    program.send(SIGTERM);
    const Ended ended = program.wait();
    EXPECT_EQ(ended.status, 143) << ended.errors;
    EXPECT_GT(watch.seconds(), 0.5 * cancellation_grace_s)
        << "it waits for the step's end at first";
    EXPECT_LT(watch.seconds(), 60.0) << "of hours";
    const auto manifest = read_manifest(folder / "out");
    EXPECT_EQ(manifest["status"], "interrupted");
    EXPECT_EQ(manifest["steps_done"], 0);
    EXPECT_FALSE(manifest.contains("state_sha256")) << "of a step half done";
    EXPECT_EQ(manifest["frames"].size(), 1U);
    EXPECT_FALSE(fs::exists(folder / "out/frames/frame_000001.png"));
    EXPECT_FALSE(fs::exists(folder / "out/checkpoint.fumon"));
}

TEST(Interrupt, EndsPreparationsAtOnce) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml",  // half a minute for the pressure's dense inverse
               "[grid]\nnx = 6000\n[model]\nname = \"airflow\"\nnz = 40\n[run]\nsteps = 1\n");
    Program program({"still", "scene.toml", "-o", "a.png"}, folder.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));
    const Stopwatch watch;
    program.send(SIGINT);
    EXPECT_EQ(program.wait().status, 130);
    EXPECT_LT(watch.seconds(), 15.0) << "of half a minute";
    EXPECT_FALSE(fs::exists(folder / "a.png"));
}

}  // namespace
}  // namespace fumon::test
