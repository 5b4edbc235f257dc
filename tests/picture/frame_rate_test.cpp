#include "picture/frame_rate.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

TEST(FrameRate, IsASensibleFraction) {
    EXPECT_EQ(frame_rate(30), (FrameRate{30, 1}));
    EXPECT_EQ(frame_rate(25), (FrameRate{25, 1}));
    EXPECT_EQ(frame_rate(29.97), (FrameRate{30000, 1001}));
    EXPECT_EQ(frame_rate(23.976), (FrameRate{24000, 1001}));
    EXPECT_EQ(frame_rate(23.98), (FrameRate{24000, 1001}));
    EXPECT_EQ(frame_rate(59.94), (FrameRate{60000, 1001}));
    EXPECT_EQ(frame_rate(12.5), (FrameRate{25, 2}));
    EXPECT_EQ(frame_rate(1.0 / 3.0), (FrameRate{1, 3}));
    EXPECT_EQ(frame_rate(0.1), (FrameRate{1, 10}));
    EXPECT_EQ(frame_rate(29.9), (FrameRate{299, 10}));
    EXPECT_EQ(frame_rate(240), (FrameRate{240, 1}));
    EXPECT_EQ(frame_rate(1e-9), (FrameRate{1, 1001}));
    EXPECT_EQ(frame_rate(1e300), (FrameRate{1000000, 1}));
}

}  // namespace
}  // namespace fumon
