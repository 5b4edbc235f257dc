#include "render/samples/triangle_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/worker_pool.h"

namespace fumon {
namespace {

constexpr int square = 64;
constexpr int lowest_row = 200;

/// Triangles strewn over a square of samples and beyond it, three corners each; every tenth has a
/// corner without a place.
rasteriser_vectors::ProjectedVertices strewn(std::size_t triangles) {
    rasteriser_vectors::ProjectedVertices vertices;
    vertices.resize(3 * triangles);
    std::uint32_t state = 4;
    const auto next = [&](std::uint32_t bound) {
        state = state * 1664525U + 1013904223U;
        return static_cast<std::int32_t>((state >> 8U) % bound);
    };
    for (std::size_t i = 0; i < 3 * triangles; ++i) {
        vertices.x[i] = next(256 * square) - 1000;
        vertices.y[i] = 256 * lowest_row + next(512 * square) - 128 * square;
        vertices.reversed_z[i] = i % 30 == 1 ? 0.0F : 0.5F + 0.01F * static_cast<float>(next(40));
    }
    return vertices;
}

struct Seen {
    std::vector<std::uint32_t> samples;
    std::vector<std::uint32_t> slopes;
    std::vector<std::uint32_t> needing_clipping;
};

Seen seen_of(const rasteriser_vectors::ProjectedVertices& vertices, int band_rows, int threads) {
    constexpr std::size_t stride = square + rasteriser_vectors::Band::beyond;
    std::vector<std::uint32_t> triangles(vertices.x.size());
    std::iota(triangles.begin(), triangles.end(), 0U);
    WorkerPool pool(threads);
    TriangleBins bands;
    bands.bin(vertices, {{triangles, 0, 2, true}}, lowest_row, square, band_rows, pool);
    Seen seen{std::vector<std::uint32_t>(stride * (square + 1)),
              std::vector<std::uint32_t>(stride * (square + 1)), bands.needing_clipping(0)};
    for (int band = 0; band * band_rows < square; ++band) {
        const int first = band * band_rows;
        const std::size_t at = static_cast<std::size_t>(first) * stride;
        const int end = std::min(first + band_rows, square);
        bands.rasterise(band, vertices,
                        {seen.samples.data() + at, stride, 0, square, lowest_row + first,
                         lowest_row + end, seen.slopes.data() + at});
    }
    return seen;
}

TEST(TriangleBins, AreDrawnTheSameHoweverManyRowsAndThreads) {
    const rasteriser_vectors::ProjectedVertices vertices = strewn(500);
    const Seen expected = seen_of(vertices, square, 1);
    EXPECT_GT(std::ranges::count_if(expected.samples, [](std::uint32_t s) { return s != 0; }),
              square * square * 9 / 10);
    for (const int band_rows : {7, 16, 64}) {
        for (const int threads : {1, 3}) {
            const Seen found = seen_of(vertices, band_rows, threads);
            EXPECT_EQ(found.samples, expected.samples) << band_rows << " " << threads;
            EXPECT_EQ(found.slopes, expected.slopes) << band_rows << " " << threads;
            EXPECT_EQ(found.needing_clipping, expected.needing_clipping);
        }
    }
}

TEST(TriangleBins, TellWhichTrianglesHaveNoPlace) {
    const Seen found = seen_of(strewn(500), 16, 2);
    ASSERT_EQ(found.needing_clipping.size(), 50U);
    for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(found.needing_clipping[i], 10 * i);
}

}  // namespace
}  // namespace fumon
