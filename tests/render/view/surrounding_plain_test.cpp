#include "render/view/surrounding_plain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/snapshot_lookup.h"
#include "base/worker_pool.h"
#include "support/plain_maps.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

TEST(SurroundingPlain, LeavesTheBedAsItIs) {
    const Snapshot bed = wavy_bed(bed_nx, bed_ny);
    const PlainMaps in(bed);
    EXPECT_TRUE(in.maps.periodic);
    EXPECT_TRUE(in.maps.nodata.empty());
    EXPECT_GE(in.west, 24);
    EXPECT_GE(in.south, 24);
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 0; x < bed_nx; ++x)
            ASSERT_EQ(in.maps.bed(x + in.west, y + in.south), bed.bed(x, y));
}

TEST(SurroundingPlain, GoesOnWithoutAStepAndAsUneven) {
    const Snapshot bed = wavy_bed(bed_nx, bed_ny);
    const PlainMaps in(bed);
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
    const PlainMaps in(bed);
    for (const double height : in.maps.bed.values()) ASSERT_NEAR(height, 7.5, 1e-9);
}

TEST(SurroundingPlain, LiesAtTheEdgesLevel) {
    Snapshot bed;
    bed.bed = Grid(40, 40, 2.0);
    for (int y = 15; y < 25; ++y)
        for (int x = 15; x < 25; ++x) bed.bed(x, y) = 9.0;  // amid
    const PlainMaps in(bed);
    double sum = 0.0;
    for (int y = 0; y < in.ny; ++y) sum += in.maps.bed(in.nx + 3, y);
    EXPECT_NEAR(sum / in.ny, 2.0, 0.5);
}

TEST(SurroundingPlain, CoversCellsOutsideTheBed) {
    const Snapshot bed = masked_bed(bed_nx, bed_ny);
    EXPECT_TRUE(is_bounded(bed));
    const PlainMaps in(bed);
    const auto [low, high] = std::ranges::minmax(in.maps.bed.values());
    EXPECT_GT(low, -10.0) << "of -9999 nothing is left";
    EXPECT_LT(high, 15.0);
    EXPECT_EQ(in.maps.bed(in.west + bed_nx / 2, in.south + bed_ny / 2),
              bed.bed(bed_nx / 2, bed_ny / 2));
}

TEST(SurroundingPlain, IsTheSameForAnyNumberOfThreads) {
    const Snapshot bed = masked_bed(bed_nx, bed_ny);
    EXPECT_EQ(PlainMaps(bed, 1).maps.bed, PlainMaps(bed, 3).maps.bed);
}

TEST(SurroundingPlain, TellsInventedGroundFromTheBedAndItsMaskedCells) {
    Snapshot bed = valley();
    bed.nodata = Mask(bed_nx, bed_ny, 0);
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 40; x < bed_nx; ++x) bed.nodata(x, y) = 1;
    const PlainMaps in(bed);
    const Field<std::uint8_t> share = in.plain.invented_share(bed);
    ASSERT_EQ(share.nx(), 2 * in.nx);
    EXPECT_EQ(share(in.west + 39, in.south + 20), 0);
    EXPECT_EQ(share(in.west, in.south), 0);
    EXPECT_GT(share(in.west + 44, in.south + 20), share(in.west + 41, in.south + 20));
    EXPECT_EQ(share(in.west + 53, in.south + 20), 255) << "masked";
    EXPECT_EQ(share(in.west - 13, in.south + 20), 255) << "beside the bed";
    EXPECT_EQ(share(in.nx + in.west + 10, in.south + 20), 255) << "the tile of the plain";
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
