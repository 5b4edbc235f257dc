#include "view/subject/followed_subject.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "support/program.h"
#include "support/viewed_run.h"

namespace fumon {
namespace {

namespace fs = std::filesystem;
using test::read_text;
using test::ScratchFolder;
using test::write_text;

/// A run that stored beds, made to look as while it went on, without the bed of its last step.
fs::path unfinished_run(const fs::path& folder) {
    write_text(folder / "viewed.toml", viewed_scene);
    EXPECT_EQ(test::fumon({"run", "viewed.toml", "-o", "run", "-q", "--set",
                           "output.fields_every=0", "--set", "output.bed_every=4"},
                          folder)
                  .status,
              0);
    const fs::path run = folder / "run";
    std::string manifest = read_text(run / "run.json");
    const std::string whole = "\"status\": \"complete\"";
    manifest.replace(manifest.find(whole), whole.size(), "\"status\": \"running\"");
    write_text(run / "run.json", manifest);
    fs::rename(run / "beds" / "bed_00000012.asc", folder / "last.asc");
    const std::string rows = read_text(run / "measurements.csv");
    fs::remove(run / "measurements.csv");
    write_text(run / "measurements.csv.part", rows.substr(0, rows.size() - 5));
    return run;
}

TEST(FollowedRun, ShowsWhatItsFolderHoldsSoFar) {
    const ScratchFolder folder;
    const fs::path run = unfinished_run(folder.path());
    ASSERT_TRUE(is_unfinished_run(run));
    const auto subject = followed_subject(run, 1, {});
    ASSERT_EQ(subject->moments().size(), 3U);
    EXPECT_EQ(subject->moments().back().step, 8);
    EXPECT_EQ(subject->snapshot(2)->step, 8);
    EXPECT_EQ(subject->work().state, "running");
    EXPECT_EQ(subject->work().target, 12);
    const std::size_t rows = subject->measurements().front().values.size();
    EXPECT_GT(rows, 1U);

    fs::rename(folder / "last.asc", run / "beds" / "bed_00000012.asc");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    ASSERT_EQ(subject->moments().size(), 4U);
    EXPECT_EQ(subject->snapshot(3)->step, 12);
    EXPECT_EQ(subject->work().step, 12);
}

TEST(FollowedRun, AFinishedRunIsNone) {
    const ScratchFolder folder;
    EXPECT_FALSE(is_unfinished_run(viewed_run(folder.path())));
}

}  // namespace
}  // namespace fumon
