#include "film/frame_pace.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

TEST(FramePace, CountsWhatIsDrawnAlone) {
    FramePace pace;
    for (int frame = 0; frame < 40; ++frame) pace.count(false, 0.01 * frame);
    pace.count(true, 2.39);
    pace.count(true, 4.39);
    EXPECT_EQ(pace.text(60), "frame 42/60 at 0.5 frames/s, 0:36 left");
}

TEST(FramePace, OfFramesThatAreAllKept) {
    FramePace pace;
    for (int frame = 1; frame <= 20; ++frame) pace.count(false, 0.1 * frame);
    EXPECT_EQ(pace.text(60), "frame 20/60 at 10 frames/s, 0:04 left");
}

}  // namespace
}  // namespace fumon
