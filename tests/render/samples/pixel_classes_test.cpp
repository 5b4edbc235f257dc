#include "render/samples/pixel_classes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "render/view/ground_tiles.h"
#include "vectors/target.h"

namespace fumon {
namespace {

constexpr int columns = 37;
constexpr int rows = 24;

/// Ground that lies as a plane: z = `level` + `rise` · y, seen from the origin.
struct Plane {
    double level = -1.0;
    double rise = 0.0;
    std::uint32_t kind = GroundRasteriser::near_kind;
};

/// Samples of a camera that looks along y and 0.5 down, of planes by the row of pixels, `factor`
/// samples a pixel. As GroundRasteriser leaves them.
struct Picture {
    explicit Picture(int samples_a_pixel) : factor(samples_a_pixel) {
        samples.picture = factor * glm::ivec2(columns, rows);
        samples.first = glm::ivec2(-2);
        samples.size = samples.picture + 3;
        const glm::dvec2 step = glm::dvec2(1.2, 0.8) / glm::dvec2(samples.picture);
        rays.first = {0.5 * step.x - 0.6, 1.0, 0.5 * step.y - 0.9};
        rays.right = {step.x, 0.0, 0.0};
        rays.up = {0.0, 0.0, step.y};
        numbers.resize(samples.count());
    }

    void rasterise(int column, int row, const Plane& plane) {
        const glm::dvec3 ray = rays.first + static_cast<double>(column) * rays.right +
                               static_cast<double>(row) * rays.up;
        // ray / reversed_z lies on the plane.
        const double reversed_z = (ray.z - plane.rise * ray.y) / plane.level;
        const std::size_t at =
            samples.index(static_cast<std::size_t>(column + 2), static_cast<std::size_t>(row + 2));
        const std::size_t length_at = samples.numbers() + at;
        numbers[at] = 0;
        numbers[length_at] = 0;
        if (plane.kind == 0 || reversed_z <= 0.0) return;
        numbers[at] = (std::bit_cast<std::uint32_t>(static_cast<float>(reversed_z)) &
                       ~rasteriser_vectors::kind_bits) |
                      plane.kind;
        const double further = reversed_z - rays.up.z / plane.level;
        const double length = std::abs(ray.y / reversed_z - ray.y / further);
        numbers[length_at] = std::bit_cast<std::uint32_t>(static_cast<float>(length));
    }
    template <class PlaneAt>
    void see_all(const PlaneAt& plane_at) {
        for (int row = -1; row <= samples.picture.y; ++row)
            for (int column = -1; column <= samples.picture.x; ++column)
                rasterise(column, row, plane_at(column, row));
    }
    [[nodiscard]] std::vector<std::uint32_t> kinds(const pixel_class_vectors::ClassBounds& bounds,
                                                   int ground_rows = rows, int threads = 2) const {
        WorkerPool pool(threads);
        PixelClasses told;
        told.classify(numbers.data(), samples, rays,
                      {glm::ivec2(2), factor, columns, ground_rows, rows}, bounds, pool);
        return told.numbers();
    }

    int factor;
    SampleRectangle samples;
    SampleRays rays{};
    std::vector<std::uint32_t> numbers;
};

const pixel_class_vectors::ClassBounds all_near{1e6F, 0.3F, 1.0F, 1.0F, 1.0F, false, 0.0F, 0.0F};

long count(const std::vector<std::uint32_t>& kinds, std::uint32_t kind) {
    return std::ranges::count(kinds, kind);
}

TEST(PixelClasses, LevelAndSteepGroundAreToldApart) {
    for (const int factor : {2, 4}) {
        Picture picture(factor);
        picture.see_all([](int, int) { return Plane{-1.0, 0.25}; });
        EXPECT_EQ(count(picture.kinds(all_near), pixel_class_vectors::smooth), columns * rows);
        picture.see_all([](int, int) { return Plane{-1.0, 0.35}; });
        EXPECT_EQ(count(picture.kinds(all_near), pixel_class_vectors::slid), columns * rows);
    }
}

TEST(PixelClasses, SteepGroundHasTonguesWhereItsCellMaySlide) {
    constexpr int cells = 40;
    constexpr float extent_x = 3.0F;
    constexpr float extent_y = 2.0F;
    std::vector<std::uint32_t> words(std::size_t{2} * cells);
    const auto may_slide = [](int x, int y) { return (x / 4 + y / 4) % 3 == 0; };
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            if (may_slide(x, y))
                words[static_cast<std::size_t>(2 * y + x / 32)] |= 1U
                                                                   << static_cast<unsigned>(x % 32);
    Picture picture(2);
    picture.see_all([](int, int) { return Plane{-1.0, 0.35}; });
    pixel_class_vectors::ClassBounds bounds = all_near;
    bounds.extent_x = extent_x;
    bounds.extent_y = extent_y;
    for (const bool plain : {false, true}) {
        bounds.slid = {words.data(), 2, cells, cells, plain, 0.4F, -0.3F};
        const auto kinds = picture.kinds(bounds);
        int slid = 0;
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < columns; ++x) {
                const glm::dvec3 ray = picture.rays.first + (2.0 * x + 0.5) * picture.rays.right +
                                       (2.0 * y + 0.5) * picture.rays.up;
                const glm::dvec3 at = ray / (0.35 * ray.y - ray.z);
                const GroundTiles tiles{plain};
                glm::dvec2 position =
                    tiles.in_maps({(at.x + 0.4) / 3.0 + 0.5, (at.y - 0.3) / 2.0 + 0.5});
                position = static_cast<double>(cells) * (position - glm::floor(position));
                const glm::dvec2 within = position - glm::floor(position);
                // The mean of the corners is a little beside the middle's place.
                if (glm::any(glm::lessThan(glm::min(within, 1.0 - within), glm::dvec2(0.05))))
                    continue;
                const bool may =
                    may_slide(static_cast<int>(position.x), static_cast<int>(position.y));
                EXPECT_EQ(kinds[static_cast<std::size_t>(y * columns + x)],
                          may ? pixel_class_vectors::slid : pixel_class_vectors::smooth)
                    << plain << " " << x << " " << y;
                slid += may ? 1 : 0;
            }
        }
        EXPECT_GT(slid, 50);
    }
}

TEST(PixelClasses, FarGroundAndWhatNeedsMoreLooksAreToldApart) {
    Picture picture(2);
    picture.see_all([](int, int) { return Plane{}; });
    pixel_class_vectors::ClassBounds bounds = all_near;
    bounds.near_limit = 3.0F;
    const auto by_distance = picture.kinds(bounds);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const glm::dvec3 ray = picture.rays.first + (2.0 * x + 0.5) * picture.rays.right +
                                   (2.0 * y + 0.5) * picture.rays.up;
            const double range = glm::length(ray / ray.z);
            if (std::abs(range - 3.0) < 0.1) continue;
            const std::uint32_t expected =
                range > 3.0 ? pixel_class_vectors::far : pixel_class_vectors::smooth;
            EXPECT_EQ(by_distance[static_cast<std::size_t>(y * columns + x)], expected) << range;
        }
    }
    bounds = all_near;
    bounds.texels = 1e4F;  // far more than one of them to a pixel
    EXPECT_EQ(count(picture.kinds(bounds), pixel_class_vectors::near), columns * rows);
    bounds = all_near;
    bounds.varied = true;
    bounds.extent_x = bounds.extent_y = 3.0F;
    const auto copies = picture.kinds(bounds);
    EXPECT_GT(count(copies, pixel_class_vectors::near), 50);
    EXPECT_GT(count(copies, pixel_class_vectors::smooth), 50);
    bounds.east = 1.0F;
    EXPECT_EQ(count(picture.kinds(bounds), pixel_class_vectors::near), columns * rows);
}

TEST(PixelClasses, PixelsOfTwoGroundsTellWhichSamplesThereAre) {
    for (const int factor : {2, 4}) {
        Picture picture(factor);
        const Plane near{};
        const Plane far{-9.0, 0.0, GroundRasteriser::far_kind};
        const Plane none{-1.0, 0.0, 0};
        picture.see_all([&](int, int) { return near; });
        const auto at = [&](int x, int y, int i, int j, const Plane& plane) {
            picture.rasterise(factor * x + i, factor * y + j, plane);
        };
        at(3, 2, factor - 1, 0, far);
        at(5, 2, 0, factor - 1, none);
        for (int j = 0; j < factor; ++j)
            for (int i = 0; i < factor; ++i) at(7, 2, i, j, none);
        for (int i = 0; i < factor; ++i) at(9, 2, i, 0, far), at(9, 2, i, factor - 1, none);
        const auto kinds = picture.kinds(all_near);
        const auto kind = [&](int x) { return kinds[static_cast<std::size_t>(2 * columns + x)]; };
        EXPECT_EQ(kind(2), pixel_class_vectors::smooth);
        EXPECT_EQ(kind(3), pixel_class_vectors::near_samples + pixel_class_vectors::far_samples);
        EXPECT_EQ(kind(5), pixel_class_vectors::near_samples);
        EXPECT_EQ(kind(7), 0U);
        EXPECT_EQ(kind(9) & pixel_class_vectors::far_samples, pixel_class_vectors::far_samples);
        EXPECT_EQ((kind(9) & pixel_class_vectors::near_samples) != 0, factor == 4);
    }
}

TEST(PixelClasses, RowsThatSeeNoGroundAreNone) {
    Picture picture(2);
    picture.see_all([](int, int) { return Plane{}; });
    const auto kinds = picture.kinds(all_near, 5);
    ASSERT_EQ(kinds.size(), static_cast<std::size_t>(columns * rows));
    EXPECT_EQ(count(kinds, pixel_class_vectors::smooth), 5 * columns);
    EXPECT_EQ(count(kinds, 0), (rows - 5) * columns);
}

TEST(PixelClasses, AreTheSameOnThreadsAndTargets) {
    Picture picture(2);
    picture.see_all([](int column, int row) {
        const int hash = (column * 7919 + row * 104729) % 23;
        return Plane{hash < 3 ? -4.0 : -1.0, 0.02 * hash - 0.2,
                     hash == 0 ? GroundRasteriser::far_kind : GroundRasteriser::near_kind};
    });
    pixel_class_vectors::ClassBounds bounds = all_near;
    bounds.near_limit = 2.0F;
    bounds.texels = 30.0F;
    const auto expected = picture.kinds(bounds, rows, 1);
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        EXPECT_EQ(picture.kinds(bounds, rows, 3), expected) << target;
    }
    vectors::use_target(vectors::targets().front());
}

}  // namespace
}  // namespace fumon
