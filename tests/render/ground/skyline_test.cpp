#include "render/ground/skyline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "base/worker_pool.h"
#include "render/ground/ground_fan.h"

namespace fumon {
namespace {

/// Hills higher and lower than the eye.
HeightPyramid hills() {
    Field<float> heights(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            heights(x, y) = 0.04F * (std::sin(0.29452431F * static_cast<float>(x)) +
                                     std::cos(0.19634954F * static_cast<float>(y)));
    }
    return HeightPyramid(heights);
}

GroundFan northward(double eye_height) {
    GroundFan fan;
    fan.half_angle = 0.9;
    fan.nearest = 0.02;
    fan.farthest = 60.0;
    fan.rays = 90;
    fan.eye = {0.13, -0.21, eye_height};
    fan.cell = 1.0 / 64.0;
    return fan;
}

Camera looking(double elevation, double roll) {
    Camera camera;
    camera.half = {0.6, 0.35};
    camera.forward = {0.0, std::cos(elevation * degree), std::sin(elevation * degree)};
    const glm::dvec3 right(1.0, 0.0, 0.0);
    const glm::dvec3 up = glm::cross(right, camera.forward);
    camera.up = std::cos(roll * degree) * up + std::sin(roll * degree) * right;
    camera.right = std::cos(roll * degree) * right - std::sin(roll * degree) * up;
    return camera;
}

/// The row, from the lowest on, of the highest place that lies ahead.
double highest_row(const GroundMesh& mesh, const Camera& camera, int rows) {
    double highest = 0.0;
    for (const std::uint32_t corner : mesh.triangles) {
        const glm::dvec3 at(mesh.positions[corner]);
        const double ahead = glm::dot(camera.forward, at);
        if (ahead <= 0.0) continue;
        const double over = glm::dot(camera.up, at) / (camera.half.y * ahead);
        highest = std::max(highest, (0.5 + 0.5 * over) * rows);
    }
    return std::min(highest, static_cast<double>(rows));
}

TEST(Skyline, NoGroundIsSeenAboveItAndSomeJustBelow) {
    constexpr int rows = 200;
    const HeightPyramid bed = hills();
    WorkerPool pool(1);
    for (const double eye_height : {0.05, 0.2}) {  // below the crests, and above
        const GroundMesh mesh = ground_mesh(northward(eye_height), bed, pool);
        for (const double elevation : {-15.0, 0.0, 8.0}) {
            for (const double roll : {0.0, -12.0, 30.0}) {
                const Camera camera = looking(elevation, roll);
                const double highest = highest_row(mesh, camera, rows);
                const int found = rows_below_skyline(mesh.skyline, camera, rows);
                EXPECT_GE(found, highest) << elevation << ", " << roll;
                EXPECT_LE(found, highest + 4.0) << elevation << ", " << roll;
            }
        }
    }
}

TEST(Skyline, WhereItIsNoneAllRowsAreTaken) {
    constexpr int rows = 200;
    const HeightPyramid bed = hills();
    WorkerPool pool(1);
    const GroundMesh mesh = ground_mesh(northward(0.2), bed, pool);
    EXPECT_LT(rows_below_skyline(mesh.skyline, looking(0.0, 0.0), rows), rows);
    EXPECT_EQ(rows_below_skyline(mesh.skyline, looking(0.0, 180.0), rows), rows) << "upside down";
    EXPECT_EQ(rows_below_skyline(mesh.skyline, looking(-85.0, 0.0), rows), rows) << "straight down";
    Camera parallel = looking(0.0, 0.0);
    parallel.perspective = false;
    EXPECT_EQ(rows_below_skyline(mesh.skyline, parallel, rows), rows);
}

}  // namespace
}  // namespace fumon
