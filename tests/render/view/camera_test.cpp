#include "render/view/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/view_beds.h"

namespace fumon {
namespace {

/// The farthest the block's corners reach towards the frame, as a share of the usable part.
double reach(const Camera& camera, const Block& block, double margin) {
    double most = 0.0;
    for (const glm::dvec3& corner : block_corners(block)) {
        const glm::dvec2 position = project(camera, corner) / (1.0 - 2.0 * margin);
        most = std::max({most, std::abs(position.x), std::abs(position.y)});
    }
    return most;
}

TEST(Camera, FitsTheBlockAndTouchesTheBorder) {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<>(low, high)(random);
    };
    for (int round = 0; round < 2000; ++round) {
        const int nx = static_cast<int>(between(1, 60));
        const int ny = static_cast<int>(between(1, 60));
        const Block block = frame_block(wavy_bed(nx, ny), between(0.5, 5.0));
        CameraSettings settings;
        settings.projection = static_cast<Projection>(round % 3);
        settings.azimuth = between(-360.0, 360.0);
        settings.elevation = between(2.0, 90.0);
        settings.field_of_view = between(5.0, 90.0);
        settings.margin = between(0.0, 0.3);
        settings.roll = between(-180.0, 180.0);
        const Camera camera = place_camera(settings, block, std::exp(between(-2.0, 2.0)), 0.0);
        EXPECT_NEAR(reach(camera, block, settings.margin), 1.0, 1e-9) << "round " << round;
        for (const glm::dvec3& corner : block_corners(block)) {
            const glm::dvec4 clip = clip_matrix(camera) * glm::dvec4(corner, 1.0);
            EXPECT_GT(clip.w, 0.0);
            EXPECT_LE(std::abs(clip.z), clip.w);
        }
    }
}

TEST(Camera, ClipMatrixAgreesWithProject) {
    const Block block = frame_block(wavy_bed(30, 20), 1.0);
    for (const Projection projection :
         {Projection::perspective, Projection::orthographic, Projection::map}) {
        CameraSettings settings;
        settings.projection = projection;
        const Camera camera = place_camera(settings, block, 1.6, 0.0);
        const glm::dvec3 point(0.1, -0.2, 0.05);
        const glm::dvec4 clip = clip_matrix(camera) * glm::dvec4(point, 1.0);
        const glm::dvec2 position = project(camera, point);
        EXPECT_NEAR(clip.x / clip.w, position.x, 1e-12);
        EXPECT_NEAR(clip.y / clip.w, position.y, 1e-12);
    }
}

TEST(Camera, ATurnKeepsTheBlockInsideAtOneDistance) {
    const Block block = frame_block(wavy_bed(60, 20), 1.0);
    CameraSettings settings;
    settings.turn = 180.0;
    double most = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const Camera camera = place_camera(settings, block, 16.0 / 9.0, i / 100.0);
        const double here = reach(camera, block, settings.margin);
        EXPECT_LE(here, 1.002);
        most = std::max(most, here);
    }
    EXPECT_GT(most, 0.995);
    const Camera begin = place_camera(settings, block, 1.0, 0.0);
    const Camera end = place_camera(settings, block, 1.0, 1.0);
    EXPECT_NEAR(begin.eye.z, end.eye.z, 1e-9);
    EXPECT_NEAR(begin.forward.x, -end.forward.x, 1e-9);
}

TEST(Camera, StandsWhereItsAzimuthSays) {
    const Block block = frame_block(wavy_bed(20, 20), 1.0);
    CameraSettings settings;
    settings.azimuth = 90.0;  // in the east, looking west: north lies to the right
    settings.elevation = 20.0;
    settings.distance = {"", 3.0};
    const Camera camera = place_camera(settings, block, 1.0, 0.0);
    EXPECT_GT(camera.eye.x, 2.5);
    EXPECT_NEAR(camera.eye.y, 0.0, 1e-9);
    EXPECT_GT(project(camera, {0.0, 0.3, 0.0}).x, 0.0);
    EXPECT_NEAR(glm::length(camera.eye - glm::dvec3(0, 0, 0.5 * (block.base + block.top))), 3.0,
                1e-9);
}

TEST(Camera, AMapHasNorthUpAndOneScale) {
    View view;
    view.camera.projection = Projection::map;
    view.camera.margin = 0.05;
    view.image.width = 1000;
    view.image.height = 400;
    Snapshot bed = wavy_bed(50, 20);
    bed.scale.dx = 2.0;
    const Block block = frame_block(bed, 1.0);
    const Camera camera = place_camera(view.camera, block, 2.5, 0.0);
    EXPECT_GT(project(camera, {0.0, 0.1, 0.0}).y, 0.0);
    EXPECT_GT(project(camera, {0.1, 0.0, 0.0}).x, 0.0);
    const auto [left, top, width, height] = map_rectangle(view, bed);
    EXPECT_NEAR(width / height, 5.0, 1e-9);
    EXPECT_NEAR(left, 50.0, 1e-9);
    EXPECT_NEAR(width, 900.0, 1e-9);
    EXPECT_NEAR(top + 0.5 * height, 200.0, 1e-9);
}

TEST(Camera, ALensHasItsFieldOfView) {
    const Block block = frame_block(wavy_bed(30, 20), 1.0);
    CameraSettings settings;
    settings.focal_length = 50.0;
    EXPECT_NEAR(place_camera(settings, block, 1.5, 0.0).half.y, 0.24, 1e-12);
    EXPECT_NEAR(place_camera(settings, block, 1.5, 0.0).half.x, 0.36, 1e-12);
}

TEST(Camera, RollsToTheRight) {
    Block block = frame_block(wavy_bed(30, 20), 1.0);
    CameraSettings settings;
    for (const bool stands : {false, true}) {
        if (stands) {
            block.eye = glm::dvec3(0.1, -0.2, 0.3);
            block.look_at = glm::dvec3(0.0, 0.1, 0.0);
        }
        settings.roll = 0.0;
        const Camera level = place_camera(settings, block, 1.5, 0.0);
        settings.roll = 30.0;
        const Camera rolled = place_camera(settings, block, 1.5, 0.0);
        EXPECT_NEAR(glm::dot(rolled.up, level.up), std::cos(M_PI / 6.0), 1e-12);
        EXPECT_NEAR(glm::dot(rolled.up, level.right), 0.5, 1e-12) << "its top goes to the right";
        EXPECT_NEAR(glm::dot(rolled.right, rolled.up), 0.0, 1e-12);
        EXPECT_EQ(rolled.forward, level.forward);
    }
}

}  // namespace
}  // namespace fumon
