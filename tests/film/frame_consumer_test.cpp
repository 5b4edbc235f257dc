#include "film/frame_consumer.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace fumon {
namespace {

Image numbered(int number) {
    return {number + 1, 1};
}

TEST(FrameConsumerThreads, FramesAreUsedInTheirOrder) {
    std::vector<int> used;
    FrameConsumer consumer([&](const Image& image) { used.push_back(image.width - 1); });
    std::vector<int> given;
    for (int i = 0; i < 200; ++i) {
        consumer.add(numbered(i));
        given.push_back(i);
    }
    consumer.finish();
    EXPECT_EQ(used, given);
}

TEST(FrameConsumerThreads, WhatUsingOneThrowsReachesTheOneWhoDraws) {
    int used = 0;
    FrameConsumer consumer([&](const Image& image) {
        if (image.width == 4) throw std::runtime_error("disk full");
        ++used;
    });
    const auto draw_on = [&] {
        for (int i = 0; i < 100; ++i) consumer.add(numbered(i));
        consumer.finish();
    };
    EXPECT_THROW(draw_on(), std::runtime_error);
    EXPECT_EQ(used, 3);
    EXPECT_THROW(consumer.finish(), std::runtime_error);
}

TEST(FrameConsumerThreads, WhatWaitsIsUsedWhenDrawingEndsEarly) {
    int used = 0;
    {
        FrameConsumer consumer([&](const Image& /*image*/) { ++used; });
        for (int i = 0; i < 5; ++i) consumer.add(numbered(i));
    }
    EXPECT_EQ(used, 5);
}

}  // namespace
}  // namespace fumon
