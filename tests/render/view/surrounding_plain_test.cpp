#include "render/view/surrounding_plain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/worker_pool.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

constexpr int bed_nx = 60;
constexpr int bed_ny = 40;

/// The maps of a bed in its plain, with what is known of where it lies.
struct Maps {
    explicit Maps(const Snapshot& bed, int workers = 1)
        : pool(workers), plain(bed, pool), maps(plain.around(bed)) {
        nx = maps.bed.nx() / 2;
        ny = maps.bed.ny();
        west = (nx - bed.bed.nx()) / 2;
        south = (ny - bed.bed.ny()) / 2;
    }

    WorkerPool pool;
    SurroundingPlain plain;
    Snapshot maps;
    int nx = 0;
    int ny = 0;
    int west = 0;
    int south = 0;
};

TEST(SurroundingPlain, LeavesTheBedAsItIs) {
    const Snapshot bed = wavy_bed(bed_nx, bed_ny);
    const Maps in(bed);
    EXPECT_TRUE(in.maps.periodic);
    EXPECT_TRUE(in.maps.nodata.empty());
    EXPECT_GE(in.west, 24);
    EXPECT_GE(in.south, 24);
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 0; x < bed_nx; ++x)
            ASSERT_EQ(in.maps.bed(x + in.west, y + in.south), bed.bed(x, y));
}

double largest_step(const Grid& field, int x0, int x1, int y0, int y1) {
    double most = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            most = std::max(most, std::abs(field(x + 1, y) - field(x, y)));
    return most;
}

TEST(SurroundingPlain, GoesOnWithoutAStepAndAsUneven) {
    const Snapshot bed = wavy_bed(bed_nx, bed_ny);
    const Maps in(bed);
    const double own = largest_step(bed.bed, 0, bed_nx - 1, 0, bed_ny);
    const int east = in.west + bed_nx;
    const int north = in.south + bed_ny;
    EXPECT_LT(largest_step(in.maps.bed, in.west - 1, in.west, in.south, north), 1.3 * own);
    EXPECT_LT(largest_step(in.maps.bed, east - 1, east, in.south, north), 1.3 * own);
    // The two tiles meet, and the second one repeats.
    EXPECT_LT(largest_step(in.maps.bed, in.nx - 1, in.nx, 0, in.ny), 1.3 * own);
    for (int y = 0; y < in.ny; ++y) {
        ASSERT_EQ(in.maps.bed(0, y), in.maps.bed(in.nx, y));
        ASSERT_EQ(in.maps.bed(in.nx - 1, y), in.maps.bed(2 * in.nx - 1, y));
    }
    // The plain has relief, not more than the bed.
    const double plain = largest_step(in.maps.bed, in.nx, 2 * in.nx - 1, 0, in.ny);
    EXPECT_GT(plain, 0.1 * own);
    EXPECT_LT(plain, 2.0 * own);
}

TEST(SurroundingPlain, AFlatBedLiesInAFlatPlain) {
    Snapshot bed;
    bed.bed = Grid(30, 30, 7.5);
    const Maps in(bed);
    for (const double height : in.maps.bed.values()) ASSERT_NEAR(height, 7.5, 1e-9);
}

TEST(SurroundingPlain, LiesAtTheEdgesLevel) {
    Snapshot bed;
    bed.bed = Grid(40, 40, 2.0);
    for (int y = 15; y < 25; ++y)
        for (int x = 15; x < 25; ++x) bed.bed(x, y) = 9.0;  // amid
    const Maps in(bed);
    double sum = 0.0;
    for (int y = 0; y < in.ny; ++y) sum += in.maps.bed(in.nx + 3, y);
    EXPECT_NEAR(sum / in.ny, 2.0, 0.5);
}

TEST(SurroundingPlain, CoversCellsOutsideTheBed) {
    const Snapshot bed = masked_bed(bed_nx, bed_ny);
    EXPECT_TRUE(is_bounded(bed));
    const Maps in(bed);
    const auto [low, high] = std::ranges::minmax(in.maps.bed.values());
    EXPECT_GT(low, -10.0) << "of -9999 nothing is left";
    EXPECT_LT(high, 15.0);
    EXPECT_EQ(in.maps.bed(in.west + bed_nx / 2, in.south + bed_ny / 2),
              bed.bed(bed_nx / 2, bed_ny / 2));
}

TEST(SurroundingPlain, IsTheSameForAnyNumberOfThreads) {
    const Snapshot bed = masked_bed(bed_nx, bed_ny);
    EXPECT_EQ(Maps(bed, 1).maps.bed, Maps(bed, 3).maps.bed);
}

TEST(GroundTiles, TellsTheBedsTileFromThePlains) {
    const GroundTiles both{true};
    EXPECT_EQ(both.in_maps({0.25, 0.5}), glm::dvec2(0.125, 0.5));
    EXPECT_EQ(both.in_maps({1.25, 0.5}), glm::dvec2(0.625, 0.5));
    EXPECT_EQ(both.in_maps({0.25, -0.25}), glm::dvec2(0.625, 0.75));
    EXPECT_EQ(GroundTiles{}.in_maps({7.25, -1.5}), glm::dvec2(7.25, -1.5));
}

}  // namespace
}  // namespace fumon
