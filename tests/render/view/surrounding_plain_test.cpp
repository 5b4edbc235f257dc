#include "render/view/surrounding_plain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/worker_pool.h"
#include "render/land/drained_land.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

constexpr int bed_nx = 60;
constexpr int bed_ny = 40;

/// The maps of a bed in its plain, with what is known of where it lies.
struct Maps {
    explicit Maps(const Snapshot& bed, int workers = 1)
        : pool(workers), plain(bed, pool), maps(plain.around(bed, pool)) {
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

/// A valley that descends southward between ridges, with a step of relief across.
Snapshot valley() {
    Snapshot land;
    land.landform = Landform::terrain;
    land.bed = Grid(bed_nx, bed_ny);
    land.scale.dx = land.scale.dy = 10.0;
    land.scale.in_metres = true;
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 0; x < bed_nx; ++x)
            land.bed(x, y) = 1.5 * y + 3.0 * std::abs(x - 30.0 - 4.0 * std::sin(0.3 * y)) +
                             5.0 * std::sin(0.5 * x) * std::sin(0.4 * y + 0.2 * x);
    return land;
}

bool is_bed(const Maps& in, int x, int y) {
    return x >= in.west && x < in.west + bed_nx && y >= in.south && y < in.south + bed_ny;
}

TEST(SurroundingLand, HasNoClosedHollows) {
    const Maps in(valley());
    ASSERT_TRUE(in.plain.is_drained());
    int hollows = 0;
    for (int y = 1; y + 1 < in.ny; ++y) {
        for (int x = 1; x + 1 < in.nx; ++x) {
            if (is_bed(in, x, y) || x < 8 || y < 8 || x >= in.nx - 8 || y >= in.ny - 8) continue;
            bool lower = false;
            for (int v = y - 1; v <= y + 1; ++v)
                for (int u = x - 1; u <= x + 1; ++u) lower |= in.maps.bed(u, v) < in.maps.bed(x, y);
            if (!lower) ++hollows;
        }
    }
    EXPECT_EQ(hollows, 0);
}

TEST(SurroundingLand, MeetsTheEdgeInHeightAndSlope) {
    const Snapshot bed = valley();
    const Maps in(bed);
    std::vector<double> across;  // what slopes change by from cell to cell at the edge
    const auto bend = [&](int x, int y, int east, int north) {
        const Grid& z = in.maps.bed;
        return std::abs(z(x + east, y + north) - 2.0 * z(x, y) + z(x - east, y - north)) / 10.0;
    };
    for (int y = in.south + 1; y + 1 < in.south + bed_ny; ++y) {
        across.push_back(bend(in.west, y, 1, 0));
        across.push_back(bend(in.west + bed_nx - 1, y, 1, 0));
    }
    for (int x = in.west + 1; x + 1 < in.west + bed_nx; ++x) {
        across.push_back(bend(x, in.south, 0, 1));
        across.push_back(bend(x, in.south + bed_ny - 1, 0, 1));
    }
    const auto median = [](std::vector<double> values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    // Sides of a valley that rise to the edge come down beyond it: as a ridge does, whose crest
    // bends by twice the slope of its sides.
    EXPECT_LE(median(across), 2.0 * 0.5 * mean_gradient(bed.bed, {}, 10.0, 10.0));
    const double step = largest_step(bed.bed, 0, bed_nx - 1, 0, bed_ny);
    const int east = in.west + bed_nx;
    const int north = in.south + bed_ny;
    EXPECT_LT(largest_step(in.maps.bed, in.west - 1, in.west, in.south, north), 1.5 * step);
    EXPECT_LT(largest_step(in.maps.bed, east - 1, east, in.south, north), 1.5 * step);
}

TEST(SurroundingLand, IsAsSteepAsTheBedAndTheSameForAnyNumberOfThreads) {
    const Snapshot bed = valley();
    const Maps in(bed, 1);
    Grid far(in.nx, in.ny);
    for (int y = 0; y < in.ny; ++y)
        for (int x = 0; x < in.nx; ++x) far(x, y) = in.maps.bed(in.nx + x, y);
    const double own = mean_gradient(bed.bed, {}, 10.0, 10.0);
    EXPECT_NEAR(mean_gradient(far, {}, 10.0, 10.0), own, 0.25 * own);
    EXPECT_EQ(in.maps.bed, Maps(bed, 2).maps.bed);
}

/// The sharpest bend of rows and columns, from cell to cell.
double sharpest_bend(const Grid& land, const Mask& without) {
    double most = 0.0;
    for (int y = 1; y + 1 < land.ny(); ++y) {
        for (int x = 1; x + 1 < land.nx(); ++x) {
            if (!without.empty() && without(x, y) != 0) continue;
            const double twice = 2.0 * land(x, y);
            most = std::max({most, std::abs(land(x + 1, y) + land(x - 1, y) - twice),
                             std::abs(land(x, y + 1) + land(x, y - 1) - twice)});
        }
    }
    return most;
}

/// The bed's tile or, `first` a tile's width, the plain's.
Grid tile_from(const Maps& in, int first) {
    Grid tile(in.nx, in.ny);
    for (int y = 0; y < in.ny; ++y)
        for (int x = 0; x < in.nx; ++x) tile(x, y) = in.maps.bed(first + x, y);
    return tile;
}

Mask surveyed(const Maps& in) {
    Mask cells(in.nx, in.ny);
    for (int y = 0; y < in.ny; ++y)
        for (int x = 0; x < in.nx; ++x) cells(x, y) = is_bed(in, x, y) ? 1 : 0;
    return cells;
}

TEST(SurroundingLand, MeetsThePlainWithoutATrench) {
    const Maps in(valley());
    EXPECT_LT(sharpest_bend(tile_from(in, 0), surveyed(in)),
              1.5 * sharpest_bend(tile_from(in, in.nx), {}));
}

TEST(SurroundingLand, FallsFromHighRimsNoMoreSteeplyThanTheBed) {
    Snapshot bed = valley();
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 0; x < bed_nx; ++x) bed.bed(x, y) += 4.0 * y;
    const Maps in(bed);
    EXPECT_LT(mean_gradient(tile_from(in, 0), surveyed(in), 10.0, 10.0),
              1.25 * mean_gradient(bed.bed, {}, 10.0, 10.0));
}

TEST(SurroundingLand, HasNoCliffWhereASmoothSlopeComesDownToThePlain) {
    Snapshot bed = valley();
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 0; x < bed_nx; ++x)
            bed.bed(x, y) = x < 45 ? 60.0 : 60.0 - 4.0 * (x - 45) + 0.5 * std::sin(0.9 * y);
    const Maps in(bed);
    EXPECT_LT(sharpest_bend(tile_from(in, 0), surveyed(in)), 30.0);
}

TEST(SurroundingLand, StaysInAFilmOfABedThatChanges) {
    const Snapshot first = valley();
    const Maps in(first);
    Snapshot later = first;
    later.bed(30, 20) -= 2.0;  // amid: nothing changes at the edge
    WorkerPool pool(1);
    const Grid changed = in.plain.around(later, pool).bed;
    for (int y = 0; y < in.ny; ++y)
        for (int x = 0; x < in.nx; ++x)
            if (!is_bed(in, x, y)) {
                ASSERT_NEAR(changed(x, y), in.maps.bed(x, y), 0.1);
            }
}

TEST(SurroundingLand, LetsTheStreamRunOnFromTheRimAndKeepsOtherGroundAsDamp) {
    Snapshot bed = valley();
    bed.landform = Landform::water;
    Grid depth(bed_nx, bed_ny, 0.002);
    for (int y = 0; y < bed_ny; ++y) depth(30, y) = 0.5;
    bed.fields = {{"water_depth", "", "m", depth},
                  {"velocity_x", "", "m/s", Grid(bed_nx, bed_ny)},
                  {"velocity_y", "", "m/s", Grid(bed_nx, bed_ny, -1.0)}};
    const Maps in(bed);
    const Grid& water = in.maps.fields.front().values;
    EXPECT_EQ(water(in.west + 30, in.south + 5), 0.5);
    int streams = 0;
    for (int x = 1; x < in.nx; ++x)
        if (water(x, in.south - 8) == 0.5 && water(x - 1, in.south - 8) != 0.5) ++streams;
    EXPECT_EQ(streams, 1) << "which may run aside for some cells";
    EXPECT_NEAR(water(in.west - 8, in.south + 20), 0.002, 1e-9) << "as the edge's films";
    for (int y = 0; y < in.ny; ++y) ASSERT_NEAR(water(in.nx + 5, y), 0.002, 1e-9);

    // Early in a run the water has not reached the rim, so that nothing runs beyond it.
    for (int y = 0; y < 5; ++y) bed.fields.front().values(30, y) = 0.002;
    const Maps early(bed);
    for (int x = 0; x < in.nx; ++x)
        ASSERT_LT(early.maps.fields.front().values(x, in.south - 8), 0.5);
}

TEST(SurroundingPlain, TellsInventedGroundFromTheBedAndItsMaskedCells) {
    Snapshot bed = valley();
    bed.nodata = Mask(bed_nx, bed_ny, 0);
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 40; x < bed_nx; ++x) bed.nodata(x, y) = 1;
    const Maps in(bed);
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
