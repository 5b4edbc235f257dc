#include "render/samples/ground_rasteriser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "vectors/target.h"

namespace fumon {
namespace {

constexpr int wide = 90;
constexpr int high = 70;

/// At the offsets' origin, turned aside and down by so much of its axis.
Camera looking_along(double aside, double down) {
    Camera camera;
    camera.forward = glm::normalize(glm::dvec3(aside, 1.0, -down));
    camera.right = glm::normalize(glm::cross(camera.forward, glm::dvec3(0.0, 0.0, 1.0)));
    camera.up = glm::cross(camera.right, camera.forward);
    camera.eye = glm::dvec3(0.0);
    camera.half = {0.5 * wide / high, 0.5};
    camera.near_depth = 0.01;
    return camera;
}

/// Squares of level ground below the eye, the farther ones on `far`; four corners each.
struct Plain {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> near;
    std::vector<std::uint32_t> far;

    void add(glm::vec2 from, glm::vec2 to, float z, std::vector<std::uint32_t>& into) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        for (const glm::vec2 at : {from, glm::vec2(to.x, from.y), to, glm::vec2(from.x, to.y)})
            positions.emplace_back(at, z);
        into.insert(into.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
    [[nodiscard]] GroundTriangles triangles() const { return {positions, near, far}; }
};

/// The eye stands on it: most of what is seen is on two triangles that reach far behind it.
Plain wide_plain() {
    Plain plain;
    plain.add({-300.0F, -300.0F}, {300.0F, 300.0F}, -1.0F, plain.near);
    plain.add({-2.0F, 5.0F}, {1.0F, 9.0F}, -0.6F, plain.far);
    return plain;
}

std::vector<std::uint32_t> numbers_of(const Plain& plain, const Camera& camera,
                                      const SampleRectangle& samples, int threads) {
    WorkerPool pool(threads);
    GroundRasteriser ground;
    std::vector<std::uint32_t> numbers(samples.count());
    ground.rasterise(plain.triangles(), camera, samples, pool, numbers.data());
    return numbers;
}

struct SampleFound {
    std::uint32_t kind;
    glm::dvec3 offset;
    double length;
};

SampleFound sample_at(const std::vector<std::uint32_t>& numbers, const SampleRectangle& samples,
                      const Camera& camera, int column, int row) {
    const std::size_t at =
        samples.index(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
    const double reversed_z = std::bit_cast<float>(numbers[at] & ~rasteriser_vectors::kind_bits);
    const SampleRays rays = sample_rays(camera, samples.picture);
    const glm::dvec2 in_picture = glm::dvec2(samples.first + glm::ivec2(column, row));
    const glm::dvec3 ray = rays.first + in_picture.x * rays.right + in_picture.y * rays.up;
    return {numbers[at] & rasteriser_vectors::kind_bits,
            reversed_z > 0.0 ? ray / reversed_z : glm::dvec3(0.0),
            std::bit_cast<float>(numbers[samples.numbers() + at])};
}

const SampleRectangle whole{{wide, high}, {0, 0}, {wide, high}};

/// Where the ray through a place of the picture meets a level plane; z 0: nowhere.
glm::dvec3 met(const Camera& camera, double column, double row, double z) {
    const glm::dvec2 at((2.0 * column + 1.0) / wide - 1.0, (2.0 * row + 1.0) / high - 1.0);
    const glm::dvec3 ray =
        camera.forward + at.x * camera.half.x * camera.right + at.y * camera.half.y * camera.up;
    if (ray.z > -1e-4) return glm::dvec3(0.0);
    return ray * (z / ray.z);
}

TEST(GroundRasteriser, AreWhereTheirRaysMeetTheGround) {
    const Plain plain = wide_plain();
    for (const double aside : {0.0, 0.7}) {
        for (const double down : {0.02, 0.4, 3.0}) {
            const Camera camera = looking_along(aside, down);
            const auto numbers = numbers_of(plain, camera, whole, 2);
            int near = 0;
            int far = 0;
            for (int row = 0; row < high; ++row) {
                for (int column = 0; column < wide; ++column) {
                    const SampleFound found = sample_at(numbers, whole, camera, column, row);
                    const glm::dvec3 low = met(camera, column, row, -1.0);
                    if (found.kind == 0) {
                        EXPECT_TRUE(low.z == 0.0 || glm::length(low) > 290.0);
                        continue;
                    }
                    const bool is_far = found.kind == GroundRasteriser::far_kind;
                    ++(is_far ? far : near);
                    const double z = is_far ? -0.6 : -1.0;
                    const glm::dvec3 expected = met(camera, column, row, z);
                    const double distance = glm::length(expected);
                    // Far aslant, corners that stand on 1/256 of a sample count for more.
                    ASSERT_LT(glm::distance(found.offset, expected),
                              2e-6 * distance + 2e-4 * distance * distance)
                        << aside << " " << down << " " << column << " " << row;
                    if (distance > 20.0) continue;
                    const glm::dvec2 view = glm::normalize(glm::dvec2(expected));
                    const auto by = [&](double right, double up) {
                        const double step = 1e-3;
                        const glm::dvec3 next =
                            met(camera, column + step * right, row + step * up, z);
                        return std::abs(glm::dot(glm::dvec2(next - expected), view)) / step;
                    };
                    const double length = by(1.0, 0.0) + by(0.0, 1.0);
                    EXPECT_NEAR(found.length, length, 0.02 * length) << column << " " << row;
                }
            }
            EXPECT_GT(near, 2000);
            if (aside == 0.0 && down < 1.0) {
                EXPECT_GT(far, 30);
            }
        }
    }
}

TEST(GroundRasteriser, AreTheSameInRectanglesOnThreadsAndTargets) {
    Plain plain = wide_plain();
    for (int i = 0; i < 400; ++i) {  // hills, of which some overlap
        const auto x = static_cast<float>(i % 20) - 10.0F;
        const auto y = static_cast<float>(i / 20) * 0.7F + 0.5F;
        const float z = -1.0F + 0.4F * static_cast<float>(i * 7919 % 101) / 101.0F;
        plain.add({x, y}, {x + 1.3F, y + 0.9F}, z, i % 3 == 0 ? plain.far : plain.near);
    }
    const Camera camera = looking_along(0.2, 0.3);
    const auto expected = numbers_of(plain, camera, whole, 1);
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        EXPECT_TRUE(numbers_of(plain, camera, whole, 3) == expected) << target;
    }
    vectors::use_target(vectors::targets().front());
    const SampleRectangle part{{wide, high}, {-1, 19}, {45, 33}};
    const auto numbers = numbers_of(plain, camera, part, 2);
    for (int row = 0; row < part.size.y; ++row) {
        for (int column = 0; column < 44; ++column) {
            const SampleFound there = sample_at(expected, whole, camera, column, 19 + row);
            const SampleFound here = sample_at(numbers, part, camera, column + 1, row);
            ASSERT_EQ(here.kind, there.kind) << row;
            ASSERT_EQ(here.offset, there.offset) << row;
            ASSERT_EQ(here.length, there.length) << row;
        }
    }
}

TEST(GroundRasteriser, GroundBehindTheEyeIsLeftOut) {
    Plain plain;
    plain.add({-5.0F, -9.0F}, {5.0F, -1.0F}, -1.0F, plain.near);
    const auto numbers = numbers_of(plain, looking_along(0.0, 0.3), whole, 1);
    EXPECT_TRUE(std::ranges::all_of(numbers, [](std::uint32_t number) { return number == 0; }));
}

}  // namespace
}  // namespace fumon
