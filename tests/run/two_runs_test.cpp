#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "picture/png.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// A scratch folder with the small scene in it.
class TwoRunsTest : public ::testing::Test {
  protected:
    void SetUp() override { write_text(folder_ / "scene.toml", small_scene()); }

    void expect_refused(const Ended& ended, const std::string& what) {
        EXPECT_EQ(ended.status, 2) << ended.errors;
        EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
        EXPECT_NE(ended.errors.find(what), std::string::npos) << ended.errors;
    }

    ScratchFolder folder_;
};

TEST_F(TwoRunsTest, OneWinsAndTheOtherTouchesNothing) {
    const Words run{"run", "scene.toml", "-o", "out", "-q"};
    Program first(run, folder_.path());
    Program second(run, folder_.path());
    std::vector<Ended> both{first.wait(), second.wait()};
    std::ranges::sort(both, {}, &Ended::status);
    EXPECT_EQ(both[0].status, 0) << both[0].errors;
    expect_refused(both[1], "name another folder");
    const auto manifest = read_manifest(folder_ / "out");
    EXPECT_EQ(manifest["status"], "complete");
    EXPECT_EQ(manifest["frames"].size(), 5U);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out/frames"), {}), 5);
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out")) {
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
        if (entry.path().extension() != ".png") continue;
        EXPECT_NO_THROW(read_png(entry.path())) << entry.path();
    }
}

TEST_F(TwoRunsTest, ForceDoesNotReplaceARunThatIsAtWork) {
    const Words run{"run", "scene.toml", "-o", "out", "-q", "--force"};
    Words long_run = run;
    long_run.insert(long_run.end(), {"--set", "run.steps=100000000", "--set", "frames.every=1000"});
    Program first(long_run, folder_.path());
    for (int tries = 0; tries < 600 && !fs::exists(folder_ / "out/frames/frame_000001.png");
         ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    expect_refused(fumon(run, folder_.path()), "another fumon is working in out");
    EXPECT_NO_THROW(read_png(folder_ / "out/frames/frame_000001.png"));
    first.send(SIGINT);
    EXPECT_EQ(first.wait().status, 130);
    EXPECT_EQ(read_manifest(folder_ / "out")["status"], "interrupted");
}

}  // namespace
}  // namespace fumon::test
