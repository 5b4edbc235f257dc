#include "render/ground/ground_fan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/worker_pool.h"

namespace fumon {
namespace {

constexpr int cells = 128;
constexpr int between_ridges = 32;

/// Sharp ridges along y, 1/16 of the bed high and 8 cells wide.
Field<float> ridges() {
    Field<float> z(cells, cells);
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            const int off = std::abs(x % between_ridges - between_ridges / 2);
            z(x, y) = std::max(0.0F, 0.0625F - 0.0156F * static_cast<float>(off));
        }
    }
    return z;
}

GroundFan eastward() {
    GroundFan fan;
    fan.heading = glm::dvec2(1.0, 0.0);
    fan.half_angle = 0.3;
    fan.nearest = 0.05;
    fan.farthest = 400.0;
    fan.rays = 200;
    fan.eye = glm::dvec3(0.0, 0.013, 0.07);
    fan.cell = 1.0 / cells;
    return fan;
}

/// How high the highest place between two distances looks, by a mesh along a ray.
double highest_in_mesh(const GroundMesh& mesh, int rays, int ray, double from, double to) {
    const std::size_t rings = mesh.places.size() / static_cast<std::size_t>(rays);
    double highest = -1e9;
    for (std::size_t i = 0; i < rings; ++i) {
        const glm::dvec3 at(mesh.places[static_cast<std::size_t>(ray) * rings + i]);
        const double distance = std::hypot(at.x, at.y);
        if (distance > from && distance < to) highest = std::max(highest, at.z / distance);
    }
    return highest;
}

/// The same by a walk in small steps.
double highest_seen(const GroundFan& fan, const HeightPyramid& bed, int ray, double from,
                    double to) {
    const double angle = fan.half_angle * (2.0 * ray / (fan.rays - 1) - 1.0);
    double highest = -1e9;
    for (double r = from; r < to; r += 0.1 * fan.cell) {
        const double z = static_cast<double>(bed.at(0, fan.eye.x + r * std::cos(angle) + 0.5,
                                                    fan.eye.y + r * std::sin(angle) + 0.5));
        highest = std::max(highest, (z - fan.eye.z) / r);
    }
    return highest;
}

TEST(GroundFan, FarCrestsStandAsHighAsTheyLook) {
    const HeightPyramid bed(ridges());
    const GroundFan fan = eastward();
    WorkerPool pool(1);
    const GroundMesh mesh = ground_mesh(fan, bed, pool);
    // A pixel is a third of the angle between rays; a ridge there is two or three wide.
    const double pixel = 2.0 * fan.half_angle / (3.0 * fan.rays);
    for (const double from : {2.0, 4.0}) {
        for (int ray = 1; ray < fan.rays; ray += 7) {
            EXPECT_NEAR(highest_in_mesh(mesh, fan.rays, ray, from, 1.3 * from),
                        highest_seen(fan, bed, ray, from, 1.3 * from), 1.2 * pixel)
                << ray << " at " << from;
        }
    }
}

TEST(GroundFan, LeavesOutWhatIsHiddenAndNoMore) {
    const HeightPyramid bed(ridges());
    GroundFan fan = eastward();
    WorkerPool pool(1);
    const std::size_t all_seen = ground_mesh(fan, bed, pool).triangles.size();
    fan.eye.z = 0.05;  // below the crests
    const GroundMesh mesh = ground_mesh(fan, bed, pool);
    EXPECT_LT(mesh.triangles.size(), all_seen / 2);
    // Of each ray what looks highest is still drawn.
    std::vector<bool> drawn(mesh.places.size(), false);
    for (const std::uint32_t corner : mesh.triangles) drawn[corner] = true;
    const std::size_t rings = mesh.places.size() / static_cast<std::size_t>(fan.rays);
    for (int ray = 0; ray < fan.rays; ++ray) {
        const auto tangent = [&](std::size_t i) {
            const glm::dvec3 at(mesh.places[i]);
            return at.z / std::hypot(at.x, at.y);
        };
        const std::size_t first = static_cast<std::size_t>(ray) * rings;
        std::size_t highest = first;
        for (std::size_t i = first; i < first + rings; ++i)
            if (tangent(i) > tangent(highest)) highest = i;
        EXPECT_TRUE(drawn[highest]) << ray;
    }
}

TEST(GroundFan, IsTheSameForAnyNumberOfThreads) {
    const HeightPyramid bed(ridges());
    WorkerPool one(1);
    WorkerPool three(3);
    const GroundMesh expected = ground_mesh(eastward(), bed, one);
    const GroundMesh mesh = ground_mesh(eastward(), bed, three);
    EXPECT_EQ(mesh.places, expected.places);
    EXPECT_EQ(mesh.triangles, expected.triangles);
}

}  // namespace
}  // namespace fumon
