#include "render/view/lens.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"

namespace fumon {
namespace {

TEST(Lens, ItsRadiusIsThatOfItsFNumberInMetresOrOfItsAperture) {
    Block block;
    block.side = 200.0;
    Camera camera;
    camera.focal_length = 85.0;
    CameraSettings settings;
    EXPECT_EQ(lens_radius(settings, block, camera), 0.0);
    settings.f_number = 2.8;
    EXPECT_NEAR(lens_radius(settings, block, camera), 0.5 * 0.085 / 2.8 / 200.0, 1e-15);
    settings.f_number = {"pinhole", 0.0};
    settings.aperture = 5.0;
    EXPECT_NEAR(lens_radius(settings, block, camera), 0.5 * 5.0 / 200.0, 1e-15);
    camera.perspective = false;
    EXPECT_EQ(lens_radius(settings, block, camera), 0.0);
}

TEST(Lens, AnFNumberNeedsMetres) {
    Snapshot bed;
    bed.bed = Grid(4, 4);
    View view;
    view.camera.aperture = 1.0;
    EXPECT_NO_THROW(check_lens(view, bed));
    view.camera.aperture = 0.0;
    view.camera.f_number = 2.8;
    EXPECT_THROW(check_lens(view, bed), KeyError);
    bed.scale.in_metres = true;
    EXPECT_NO_THROW(check_lens(view, bed));
}

/// The camera's matrix against thin rays: what lies at the focus stays where it is, and what lies
/// elsewhere moves by the point's part of the circle of confusion.
TEST(Lens, ItsPointsMoveWhatIsOutOfFocus) {
    Camera camera;
    camera.eye = {0.2, -0.3, 0.5};
    camera.half = {0.4, 0.3};
    const auto position = [&](const Camera& through, const glm::dvec3& along_axes) {
        const glm::dvec3 point = camera.eye + along_axes.x * camera.right +
                                 along_axes.y * camera.up + along_axes.z * camera.forward;
        const glm::dvec4 clip = clip_matrix(through) * glm::dvec4(point, 1.0);
        return glm::dvec2(clip) / clip.w;
    };
    Camera through = camera;
    through.lens = {0.05, 2.0, {0.03, -0.04}, {0.001, 0.002}};
    for (const double depth : {0.5, 2.0, 7.0}) {
        const glm::dvec3 point(0.1 * depth, -0.05 * depth, depth);
        const glm::dvec2 moved = position(through, point) - position(camera, point);
        const glm::dvec2 expected =
            -through.lens.point * (1.0 / depth - 1.0 / 2.0) / camera.half + through.lens.aside;
        EXPECT_NEAR(moved.x, expected.x, 1e-12) << depth;
        EXPECT_NEAR(moved.y, expected.y, 1e-12) << depth;
        // The ray of the picture's place, from the lens's point, meets the point.
        const glm::dvec2 seen = position(through, point) * camera.half;
        const glm::dvec3 met =
            through.seen_from() +
            depth * (through.ahead() + seen.x * camera.right + seen.y * camera.up);
        const glm::dvec3 there =
            camera.eye + point.x * camera.right + point.y * camera.up + point.z * camera.forward;
        EXPECT_NEAR(glm::length(met - there), 0.0, 1e-12) << depth;
    }
}

/// Each annulus and each sector of the disc has its share of the points.
TEST(Lens, ItsPointsCoverTheDiscEvenly) {
    for (const int count : {4, 16, 33, 128, 256}) {
        const std::vector<LensPoint> points = lens_points(count);
        ASSERT_EQ(points.size(), static_cast<std::size_t>(count));
        glm::dvec2 sum(0.0);
        glm::dvec2 squares(0.0);
        double least = std::numeric_limits<double>::max();
        for (const LensPoint& point : points) {
            ASSERT_LT(glm::length(point.on_disc), 1.0);
            ASSERT_LT(std::max(std::abs(point.in_pixel.x), std::abs(point.in_pixel.y)), 0.5);
            sum += point.on_disc;
            squares += point.on_disc * point.on_disc;
            for (const LensPoint& other : points) {
                if (&other != &point)
                    least = std::min(least, glm::distance(point.on_disc, other.on_disc));
            }
        }
        EXPECT_LT(glm::length(sum / static_cast<double>(count)), 0.5 / std::sqrt(count)) << count;
        EXPECT_NEAR(squares.x / count, 0.25, 0.3 / std::sqrt(count)) << count;
        EXPECT_NEAR(squares.y / count, 0.25, 0.3 / std::sqrt(count)) << count;
        // Squares of that side would cover the disc.
        EXPECT_GT(least, 0.75 * std::sqrt(std::numbers::pi / count)) << count;
    }
}

/// Sixteen in a row that begin at a multiple of 16 lie in sixteen squares.
TEST(Lens, ItsPlacesInAPixelAreStratified) {
    const std::vector<LensPoint> points = lens_points(32);
    std::array<int, 16> found{};
    for (std::size_t i = 15; i < 31; ++i) {
        const glm::ivec2 square(glm::floor(4.0 * (points[i].in_pixel + 0.5)));
        ++found.at(static_cast<std::size_t>(4 * square.y + square.x));
    }
    EXPECT_EQ(*std::ranges::min_element(found), 1);
}

TEST(Lens, AsManyPointsAsTheWidestBlurNeeds) {
    EXPECT_EQ(enough_lens_points(0.0), 16);
    EXPECT_EQ(enough_lens_points(10.0), 35);
    EXPECT_EQ(enough_lens_points(std::numeric_limits<double>::infinity()), 128);
}

TEST(Lens, RaysMeetTheGround) {
    Camera camera;
    camera.eye = {0.0, 0.0, 2.0};
    camera.forward = glm::normalize(glm::dvec3(1.0, 0.0, -1.0));
    camera.right = {0.0, -1.0, 0.0};
    camera.up = glm::cross(camera.right, camera.forward);
    RayGround ground;
    ground.height = [](const glm::dvec2& position) { return position.x > 1.5 ? 1.0 : 0.0; };
    ground.highest = 1.0;
    EXPECT_NEAR(depth_of_ground(camera, {0.0, 0.0}, ground), 1.5 * std::numbers::sqrt2, 1e-9);
    ground.height = [](const glm::dvec2&) { return 0.0; };
    EXPECT_NEAR(depth_of_ground(camera, {0.0, 0.0}, ground), 2.0 * std::numbers::sqrt2, 1e-9);
    EXPECT_TRUE(std::isinf(depth_of_ground(camera, {0.0, 1.5}, ground)));
    // Of the nearest ground, which the lowest ray of the picture meets; and of the sky.
    camera.half = {1.5, 1.5};
    camera.lens = {0.01, 3.0, {}, {}};
    const double nearest = 2.0 * std::numbers::sqrt2 / 2.5;
    EXPECT_NEAR(widest_circle_of_confusion(camera, ground, 300.0),
                0.02 * std::max(1.0 / nearest - 1.0 / 3.0, 1.0 / 3.0) * 100.0, 1e-6);
}

}  // namespace
}  // namespace fumon
