#include "scene/schedule.h"

#include <gtest/gtest.h>

#include "scene/read.h"

namespace fumon {
namespace {

std::vector<std::int64_t> due_steps(const Schedule& schedule, std::int64_t last) {
    std::vector<std::int64_t> steps;
    for (std::int64_t step = 0; step <= last; ++step) {
        if (schedule.due(step)) steps.push_back(step);
    }
    EXPECT_EQ(schedule.count(), std::ssize(steps));
    return steps;
}

Scene scene_with(const std::string& more) {
    return parse_scene("[model]\nname = \"sand\"\n[run]\nsteps = 1000\n" + more, "scene.toml", "");
}

TEST(Schedule, EveryNSteps) {
    EXPECT_EQ(due_steps(frame_schedule(scene_with("[frames]\nevery = 300\n")), 1000),
              (std::vector<std::int64_t>{0, 300, 600, 900}));
}

TEST(Schedule, ListedStepsInAnyOrderAndOnce) {
    EXPECT_EQ(due_steps(frame_schedule(scene_with("[frames]\nat = [50, 0, 50, 1000]\n")), 1000),
              (std::vector<std::int64_t>{0, 50, 1000}));
}

TEST(Schedule, LogarithmicStepsFromOneToTheEnd) {
    EXPECT_EQ(due_steps(frame_schedule(scene_with("[frames]\nlogarithmic = 4\n")), 1000),
              (std::vector<std::int64_t>{0, 1, 10, 100, 1000}));
}

TEST(Schedule, LogarithmicStepsThatRoundTogetherCountOnce) {
    const auto steps =
        due_steps(frame_schedule(scene_with("[frames]\nlogarithmic = 5000\n")), 1000);
    EXPECT_EQ(steps.front(), 0);
    EXPECT_EQ(steps.back(), 1000);
    EXPECT_LE(steps.size(), 1001U);
}

TEST(Schedule, AHundredFramesWhenNothingIsSaid) {
    EXPECT_EQ(frame_schedule(scene_with("")).count(), 101);
}

TEST(Schedule, BedsBothWays) {
    EXPECT_EQ(
        due_steps(bed_schedule(scene_with("[output]\nbed_every = 500\nbed_at = [7, 500]\n")), 1000),
        (std::vector<std::int64_t>{0, 7, 500, 1000}));
}

TEST(Schedule, FieldsBothWays) {
    EXPECT_EQ(due_steps(fields_schedule(
                            scene_with("[output]\nfields_every = 400\nfields_at = [9, 400]\n")),
                        1000),
              (std::vector<std::int64_t>{0, 9, 400, 800}));
    EXPECT_EQ(fields_schedule(scene_with("")).count(), 0);
}

}  // namespace
}  // namespace fumon
