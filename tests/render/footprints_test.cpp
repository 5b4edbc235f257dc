#include "render/life/footprints.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fumon {
namespace {

TrackSettings straight_track() {
    TrackSettings track;
    track.along = {10.0, 20.0, 16.0, 28.0};  // 10 m toward (0.6, 0.8)
    return track;
}

TEST(Footprints, LieLeftAndRightOfTheLineAStepApart) {
    const glm::dvec2 way(0.6, 0.8);
    const glm::dvec2 rightward(0.8, -0.6);
    const std::vector<Footprint> prints = footprints(straight_track(), 0);
    ASSERT_EQ(prints.size(), 14U);  // at 0, 0.75 … 9.75 m
    EXPECT_NEAR(track_length(straight_track()), 10.0, 1e-12);
    double apart = 0.0;
    for (std::size_t i = 0; i < prints.size(); ++i) {
        const glm::dvec2 from_start = prints[i].at - glm::dvec2(10.0, 20.0);
        const double side = i % 2 == 0 ? -1.0 : 1.0;  // the left foot first
        EXPECT_EQ(prints[i].right, side > 0.0);
        EXPECT_NEAR(glm::dot(from_start, way), 0.75 * static_cast<double>(i), 0.025);
        EXPECT_NEAR(glm::dot(from_start, rightward), 0.09 * side, 0.0125);
        EXPECT_NEAR(glm::length(prints[i].heading), 1.0, 1e-12);
        EXPECT_GT(glm::dot(prints[i].heading, way), 0.97) << "as the walker went";
        EXPECT_GT(side * glm::dot(prints[i].heading, rightward), 0.0) << "toes point outward";
        EXPECT_NEAR(prints[i].depth, 0.027, 0.007);
        if (i > 0) apart = std::max(apart, std::abs(prints[i].depth - prints[i - 1].depth));
    }
    EXPECT_GT(apart, 0.002) << "no two are the same";
}

TEST(Footprints, FollowTheLineAroundItsCorners) {
    TrackSettings track;
    track.along = {0.0, 0.0, 0.0, 0.0, 6.0, 0.0, 6.0, 6.0};
    const std::vector<Footprint> prints = footprints(track, 0);
    ASSERT_EQ(prints.size(), 17U);
    EXPECT_NEAR(prints.back().at.x, 6.0, 0.11);
    EXPECT_NEAR(prints.back().at.y, 6.0, 0.03);
    EXPECT_GT(prints[4].heading.x, 0.97);
    EXPECT_GT(prints[12].heading.y, 0.97);
    // At the corner, turned by half of it.
    EXPECT_GT(prints[8].heading.x, 0.5);
    EXPECT_GT(prints[8].heading.y, 0.5);
}

TEST(Footprints, DifferBySeedAndTrackAndNothingElse) {
    TrackSettings track = straight_track();
    const auto depths = [&](std::uint32_t number) {
        std::vector<double> all;
        for (const Footprint& print : footprints(track, number)) all.push_back(print.depth);
        return all;
    };
    const std::vector<double> first = depths(0);
    EXPECT_EQ(depths(0), first);
    EXPECT_NE(depths(1), first);
    track.seed = 2;
    EXPECT_NE(depths(0), first);
    track.seed = 1;
    track.along.insert(track.along.end(), {20.0, 28.0});
    const std::vector<double> longer = depths(0);
    EXPECT_EQ(std::vector<double>(longer.begin(), longer.begin() + 14), first);
}

}  // namespace
}  // namespace fumon
