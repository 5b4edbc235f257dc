#include "run/terminal/progress.h"

#include <gtest/gtest.h>

namespace fumon::test {
namespace {

TEST(Progress, CountsSimulationAndDrawingApart) {
    Progress progress(Verbosity::quiet, 2'000'000);
    progress.steps_done = 1000;  // of a former run
    progress.frames_done = 10;
    progress.expect(2000, 40);
    progress.steps_done = 1500;
    progress.seconds_of_steps = 10.0;
    progress.frames_done = 16;
    progress.seconds_of_frames = 4.0;
    EXPECT_EQ(progress.line().substr(0, progress.line().rfind(", ")),
              "step 1,500/2,000 at 100 million cell-steps/s, frame 16/40 at 1.5 frames/s");
    progress.steps_done = 2000;
    progress.seconds_of_steps = 20.0;
    progress.frames_done = 40;
    progress.seconds_of_frames = 60.0;
    EXPECT_EQ(progress.line(),
              "step 2,000/2,000 at 100 million cell-steps/s, frame 40/40 at 0.5 frames/s")
        << "drawing goes on after the last step and does not slow the simulation's pace";
}

TEST(Progress, TimesAreInMinutesAndHours) {
    EXPECT_EQ(clock_text(0.4), "0:00");
    EXPECT_EQ(clock_text(59.6), "1:00");
    EXPECT_EQ(clock_text(605.0), "10:05");
    EXPECT_EQ(clock_text(3599.0), "59:59");
    EXPECT_EQ(clock_text(3600.0 + 61.0), "1:01:01");
    EXPECT_EQ(clock_text(100.0 * 3600.0), "100:00:00");
}

TEST(Progress, WithoutFramesShowsStepsAlone) {
    Progress progress(Verbosity::quiet, 0);
    progress.expect(10, 0);
    EXPECT_EQ(progress.line(), "step 0/10");
}

}  // namespace
}  // namespace fumon::test
