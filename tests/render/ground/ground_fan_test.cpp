#include "render/ground/ground_fan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/worker_pool.h"
#include "render/view/tile_warp_vectors.h"

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
    const std::size_t rings = mesh.positions.size() / static_cast<std::size_t>(rays);
    double highest = -1e9;
    for (std::size_t i = 0; i < rings; ++i) {
        const glm::dvec3 at(mesh.positions[static_cast<std::size_t>(ray) * rings + i]);
        const double distance = std::hypot(at.x, at.y);
        if (distance > from && distance < to) highest = std::max(highest, at.z / distance);
    }
    return highest;
}

double height_at(const GroundFan& fan, const HeightPyramid& bed, const glm::dvec2& offset) {
    WarpedGround copy;
    if (fan.strength > 0.0) copy = tile_warp::warp_at(fan.eye_from_middle + offset, fan.strength);
    const glm::dvec2 position = glm::dvec2(fan.eye) + 0.5 + offset + copy.offset;
    const auto z = static_cast<double>(bed.at(0, position.x, position.y));
    return fan.mean + copy.height * (z - fan.mean);
}

/// The same by a walk in small steps.
double highest_seen(const GroundFan& fan, const HeightPyramid& bed, int ray, double from,
                    double to) {
    const double angle = fan.half_angle * (2.0 * ray / (fan.rays - 1) - 1.0);
    double highest = -1e9;
    for (double r = from; r < to; r += 0.1 * fan.cell) {
        const double z = height_at(fan, bed, r * glm::dvec2(std::cos(angle), std::sin(angle)));
        highest = std::max(highest, (z - fan.eye.z) / r);
    }
    return highest;
}

TEST(GroundFan, FarCrestsStandAsHighAsTheyLook) {
    const HeightPyramid bed(ridges());
    GroundFan fan = eastward();
    // A pixel is a third of the angle between rays; a ridge there is two or three wide.
    const double pixel = 2.0 * fan.half_angle / (3.0 * fan.rays);
    WorkerPool pool(1);
    for (const double strength : {0.0, 0.9}) {  // of copies unlike each other
        fan.strength = strength;
        fan.eye_from_middle = {0.3, -0.1};
        fan.mean = 0.01;
        const GroundMesh mesh = ground_mesh(fan, bed, pool);
        for (const double from : {2.0, 4.0}) {
            for (int ray = 1; ray < fan.rays; ray += 7) {
                EXPECT_NEAR(highest_in_mesh(mesh, fan.rays, ray, from, 1.3 * from),
                            highest_seen(fan, bed, ray, from, 1.3 * from), 1.2 * pixel)
                    << ray << " at " << from;
            }
        }
    }
}

TEST(GroundFan, StandsEverywhereAsItsCopiesDo) {
    const HeightPyramid bed(ridges());
    GroundFan fan = eastward();
    fan.strength = 1.0;
    fan.eye_from_middle = {0.2, 0.4};
    fan.nearest = 0.01;
    fan.rays = 2000;  // so close that single cells are looked at
    WorkerPool pool(2);
    const GroundMesh mesh = ground_mesh(fan, bed, pool);
    int far = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); i += 97) {
        const glm::dvec3 at(mesh.positions[i]);
        const double range = std::hypot(at.x, at.y);
        if (range > 3.0) continue;
        far += range > 1.5 ? 1 : 0;
        ASSERT_NEAR(at.z + fan.eye.z, height_at(fan, bed, glm::dvec2(at)), 1e-4)
            << "straight lines over a ring";
    }
    EXPECT_GT(far, 500);
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
    std::vector<bool> drawn(mesh.positions.size(), false);
    for (const std::uint32_t corner : mesh.triangles) drawn[corner] = true;
    const std::size_t rings = mesh.positions.size() / static_cast<std::size_t>(fan.rays);
    for (int ray = 0; ray < fan.rays; ++ray) {
        const auto tangent = [&](std::size_t i) {
            const glm::dvec3 at(mesh.positions[i]);
            return at.z / std::hypot(at.x, at.y);
        };
        const std::size_t first = static_cast<std::size_t>(ray) * rings;
        std::size_t highest = first;
        for (std::size_t i = first; i < first + rings; ++i)
            if (tangent(i) > tangent(highest)) highest = i;
        EXPECT_TRUE(drawn[highest]) << ray;
    }
}

/// Corners that are left out, and to which nothing stands in the way from an eye aside and above.
int missed_from(const glm::dvec3& aside, const GroundFan& fan, const HeightPyramid& bed,
                const GroundMesh& mesh) {
    std::vector<bool> drawn(mesh.positions.size(), false);
    for (const std::uint32_t corner : mesh.triangles) drawn[corner] = true;
    int missed = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); i += 7) {
        const glm::dvec3 at(mesh.positions[i]);
        if (drawn[i] || std::hypot(at.x, at.y) > 1.5) continue;
        double clear = 1e9;
        for (double share = 0.02; share < 0.98; share += 0.004) {
            const glm::dvec3 on_way = aside + share * (at - aside);
            const double ground = height_at(fan, bed, glm::dvec2(on_way)) - fan.eye.z;
            clear = std::min(clear, on_way.z - ground);
        }
        if (clear > 5e-4) ++missed;
    }
    return missed;
}

TEST(GroundFan, AllPointsOfALensSeeTheGround) {
    Field<float> hills(cells, cells);
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x)
            hills(x, y) = static_cast<float>(
                0.03 + 0.03 * std::sin(2.0 * 3.14159265358979 * (3.0 * x + 2.0 * y) / cells) *
                           std::sin(2.0 * 3.14159265358979 * 5.0 * y / cells));
    }
    const HeightPyramid bed(std::move(hills));
    GroundFan fan = eastward();
    fan.nearest = 0.02;
    fan.eye.z = 0.05;
    WorkerPool pool(1);
    constexpr double radius = 0.012;
    const GroundMesh of_pinhole = ground_mesh(fan, bed, pool);
    fan.lens = radius;
    const GroundMesh of_lens = ground_mesh(fan, bed, pool);
    EXPECT_LT(of_lens.triangles.size(), of_lens.positions.size() * 5);
    for (const glm::dvec3 aside : {glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, -1.0, 0.0),
                                   glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 0.6, 0.8)}) {
        EXPECT_GT(missed_from(radius * aside, fan, bed, of_pinhole), 0) << aside.y;
        EXPECT_EQ(missed_from(radius * aside, fan, bed, of_lens), 0) << aside.y;
    }
}

TEST(GroundFan, IsTheSameForAnyNumberOfThreads) {
    const HeightPyramid bed(ridges());
    WorkerPool one(1);
    WorkerPool three(3);
    const GroundMesh expected = ground_mesh(eastward(), bed, one);
    const GroundMesh mesh = ground_mesh(eastward(), bed, three);
    EXPECT_EQ(mesh.positions, expected.positions);
    EXPECT_EQ(mesh.triangles, expected.triangles);
}

}  // namespace
}  // namespace fumon
