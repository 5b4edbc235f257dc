#include "film/camera/camera_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fumon {
namespace {

CameraPose film_pose(double x, double y, double z) {
    CameraPose pose;
    pose.eye = {x, y, z};
    pose.look_at = {0.0, 0.0, 0.0};
    return pose;
}

/// Places far apart and close together, with a sharp turn.
std::vector<CameraPose> uneven_poses() {
    return {film_pose(-1.0, -0.5, 0.2), film_pose(-0.9, -0.4, 0.2), film_pose(0.5, -0.6, 0.3),
            film_pose(0.6, 0.8, 0.25), film_pose(0.5, 0.85, 0.4)};
}

/// The eye's steps over a film of so many frames: shortest and longest, over the mean.
std::pair<double, double> spread_of_steps(const CameraPath& path, int frames) {
    double least = 1e9;
    double most = 0.0;
    for (int i = 0; i + 1 < frames; ++i) {
        const double step = glm::length(path.at((i + 1.0) / (frames - 1)).eye -
                                        path.at(static_cast<double>(i) / (frames - 1)).eye);
        least = std::min(least, step);
        most = std::max(most, step);
    }
    const double mean = path.length() / (frames - 1);
    return {least / mean, most / mean};
}

TEST(CameraPath, GoesAtOneSpeedWithinAHundredth) {
    const CameraPath path(uneven_poses());
    const auto [least, most] = spread_of_steps(path, 900);
    EXPECT_GT(least, 0.99);
    EXPECT_LT(most, 1.01);
}

TEST(CameraPath, GoesThroughItsPosesWithoutLoops) {
    const std::vector<CameraPose> poses = uneven_poses();
    const CameraPath path(poses);
    double straight = 0.0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        double nearest = 1e9;
        for (int k = 0; k <= 4000; ++k)
            nearest = std::min(nearest, glm::length(path.at(k / 4000.0).eye - poses[i].eye));
        EXPECT_LT(nearest, 2e-3) << i;
        if (i > 0) straight += glm::length(poses[i].eye - poses[i - 1].eye);
    }
    EXPECT_EQ(path.at(0.0).eye, poses.front().eye);
    EXPECT_LT(glm::length(path.at(1.0).eye - poses.back().eye), 1e-12);
    EXPECT_LT(path.length(), 1.1 * straight);
}

TEST(CameraPath, ACircleOfPosesIsNearlyACircle) {
    std::vector<CameraPose> poses;
    for (int i = 0; i <= 60; ++i)
        poses.push_back(film_pose(std::sin(i * M_PI / 30.0), std::cos(i * M_PI / 30.0), 0.5));
    const CameraPath path(poses);
    for (int k = 0; k <= 500; ++k)
        EXPECT_NEAR(std::hypot(path.at(k / 500.0).eye.x, path.at(k / 500.0).eye.y), 1.0, 1e-3);
}

TEST(CameraPath, WhatItLooksAtSetsThePaceWhereTheEyeStands) {
    std::vector<CameraPose> poses(3, film_pose(1.0, 0.0, 0.5));
    poses[1].look_at = {0.0, 0.2, 0.0};
    poses[2].look_at = {0.0, 1.0, 0.0};
    const CameraPath path(poses);
    EXPECT_NEAR(path.length(), 0.0, 1e-12);
    EXPECT_NEAR(path.at(0.5).look_at.y, 0.5, 0.01);
}

TEST(CameraPath, IsLiftedOverTheGroundWithoutKinks) {
    const std::vector<CameraPose> poses{film_pose(-1.0, 0.0, 0.1), film_pose(1.0, 0.0, 0.1)};
    const auto floor = [](double x, double /*y*/) { return x > -0.1 && x < 0.1 ? 0.4 : 0.02; };
    const CameraPath path(poses, floor);
    double steepest = 0.0;
    for (int i = 0; i < 900; ++i) {
        const glm::dvec3 eye = path.at(i / 900.0).eye;
        const glm::dvec3 next = path.at((i + 1) / 900.0).eye;
        EXPECT_GE(eye.z, floor(eye.x, eye.y) - 1e-9) << i;
        steepest = std::max(steepest, std::abs(next.z - eye.z) / glm::length(next - eye));
    }
    EXPECT_LT(steepest, 0.9);
    const auto [least, most] = spread_of_steps(path, 900);
    EXPECT_GT(least, 0.99);
    EXPECT_LT(most, 1.01);
    EXPECT_DOUBLE_EQ(CameraPath(poses, [](double, double) { return 0.05; }).at(0.5).eye.z, 0.1);
}

}  // namespace
}  // namespace fumon
