#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/snapshot_lookup.h"
#include "base/worker_pool.h"
#include "render/land/drained_land.h"
#include "support/plain_maps.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

bool is_bed(const PlainMaps& in, int x, int y) {
    return x >= in.west && x < in.west + bed_nx && y >= in.south && y < in.south + bed_ny;
}

TEST(SurroundingLand, HasNoClosedHollows) {
    const PlainMaps in(valley());
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
    const PlainMaps in(bed);
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
    const PlainMaps in(bed, 1);
    Grid far(in.nx, in.ny);
    for (int y = 0; y < in.ny; ++y)
        for (int x = 0; x < in.nx; ++x) far(x, y) = in.maps.bed(in.nx + x, y);
    const double own = mean_gradient(bed.bed, {}, 10.0, 10.0);
    EXPECT_NEAR(mean_gradient(far, {}, 10.0, 10.0), own, 0.25 * own);
    EXPECT_EQ(in.maps.bed, PlainMaps(bed, 2).maps.bed);
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
Grid tile_from(const PlainMaps& in, int first) {
    Grid tile(in.nx, in.ny);
    for (int y = 0; y < in.ny; ++y)
        for (int x = 0; x < in.nx; ++x) tile(x, y) = in.maps.bed(first + x, y);
    return tile;
}

Mask surveyed(const PlainMaps& in) {
    Mask cells(in.nx, in.ny);
    for (int y = 0; y < in.ny; ++y)
        for (int x = 0; x < in.nx; ++x) cells(x, y) = is_bed(in, x, y) ? 1 : 0;
    return cells;
}

TEST(SurroundingLand, MeetsThePlainWithoutATrench) {
    const PlainMaps in(valley());
    EXPECT_LT(sharpest_bend(tile_from(in, 0), surveyed(in)),
              1.5 * sharpest_bend(tile_from(in, in.nx), {}));
}

TEST(SurroundingLand, FallsFromHighRimsNoMoreSteeplyThanTheBed) {
    Snapshot bed = valley();
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 0; x < bed_nx; ++x) bed.bed(x, y) += 4.0 * y;
    const PlainMaps in(bed);
    EXPECT_LT(mean_gradient(tile_from(in, 0), surveyed(in), 10.0, 10.0),
              1.25 * mean_gradient(bed.bed, {}, 10.0, 10.0));
}

TEST(SurroundingLand, HasNoCliffWhereASmoothSlopeComesDownToThePlain) {
    Snapshot bed = valley();
    for (int y = 0; y < bed_ny; ++y)
        for (int x = 0; x < bed_nx; ++x)
            bed.bed(x, y) = x < 45 ? 60.0 : 60.0 - 4.0 * (x - 45) + 0.5 * std::sin(0.9 * y);
    const PlainMaps in(bed);
    EXPECT_LT(sharpest_bend(tile_from(in, 0), surveyed(in)), 30.0);
}

TEST(SurroundingLand, StaysInAFilmOfABedThatChanges) {
    const Snapshot first = valley();
    const PlainMaps in(first);
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
    const PlainMaps in(bed);
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
    const PlainMaps early(bed);
    for (int x = 0; x < in.nx; ++x)
        ASSERT_LT(early.maps.fields.front().values(x, in.south - 8), 0.5);
}

/// Land that falls eastward to the sea, whose floor goes on falling under water of `deepest`.
Snapshot coast(double deepest) {
    Snapshot land = valley();
    Grid depth(bed_nx, bed_ny);
    for (int y = 0; y < bed_ny; ++y) {
        for (int x = 0; x < bed_nx; ++x) {
            const double ground =
                4.0 * (35.0 - x) + 6.0 * std::sin(0.5 * y) + 3.0 * std::sin(0.7 * x);
            land.bed(x, y) = std::max(ground, -deepest);
            depth(x, y) = std::max(-land.bed(x, y), 0.0);
        }
    }
    if (deepest == 0.0) return land;
    land.landform = Landform::water;
    land.fields = {{"water_depth", "", "m", depth},
                   {"velocity_x", "", "m s-1", Grid(bed_nx, bed_ny)},
                   {"velocity_y", "", "m s-1", Grid(bed_nx, bed_ny)}};
    return land;
}

TEST(SurroundingLand, EndsInTheSeaThatTheSurveyEndsIn) {
    const Snapshot bed = coast(0.0);
    const PlainMaps in(bed);
    const double step = largest_step(bed.bed, 0, bed_nx - 1, 0, bed_ny);
    EXPECT_LT(largest_step(in.maps.bed, in.west - 1, in.west, in.south, in.south + bed_ny),
              2.0 * step);
    for (int y = 0; y < in.ny; ++y) {
        for (int x = 0; x < in.nx; ++x) {
            ASSERT_GE(in.maps.bed(x, y), 0.0);
            ASSERT_EQ(in.maps.bed(in.nx + x, y), 0.0);
        }
        ASSERT_EQ(in.maps.bed(0, y), 0.0) << "the tiles meet";
    }
    for (int y = in.south + 5; y < in.south + bed_ny - 5; ++y) {
        EXPECT_EQ(in.maps.bed(in.west + bed_nx + 4, y), 0.0);
        EXPECT_GT(in.maps.bed(in.west - 4, y), 50.0);
    }
}

/// Upland 40 m high that falls eastward to a flat sea, uneven from cell to cell, on cells of 20 m.
Snapshot rough_upland_by_the_sea() {
    Snapshot land = valley();
    land.scale.dx = land.scale.dy = 20.0;
    land.bed = Grid(120, 80);
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 120; ++x) {
            const double uneven = std::sin(12.9898 * x + 78.233 * y) * 43758.5453;
            const double by_chance = 2.0 * (uneven - std::floor(uneven)) - 1.0;
            const double ground = std::min(4.0 * (70.0 - x), 40.0) + 5.0 * by_chance;
            land.bed(x, y) = std::max(ground, 0.0);
        }
    }
    return land;
}

TEST(SurroundingLand, GoesOnInlandOfACoastAsHighAsItsEdge) {
    const PlainMaps in(rough_upland_by_the_sea());
    const auto mean_west = [&](int away) {
        double mean = 0.0;
        for (int y = in.south; y < in.south + 80; ++y)
            mean += in.maps.bed(in.west - away, y) / 80.0;
        return mean;
    };
    const double edge = mean_west(0);
    for (int away = 1; away <= 8; ++away) EXPECT_NEAR(mean_west(away), edge, 0.15 * edge) << away;
    EXPECT_GT(mean_west(in.west / 3), 0.6 * edge) << "before the bays begin";
    for (int y = 0; y < in.ny; ++y) ASSERT_EQ(in.maps.bed(0, y), 0.0) << "the sea behind it";
}

TEST(SurroundingLand, HasWaterOfOneLevelInTheSea) {
    const PlainMaps in(coast(8.0));
    const Grid* depth = field_of(in.maps.fields, "water_depth");
    ASSERT_NE(depth, nullptr);
    for (int y = 0; y < in.ny; ++y) {
        for (int x = 0; x < in.nx; ++x) {
            if (in.maps.bed(x, y) < -0.1) {
                ASSERT_NEAR(in.maps.bed(x, y) + (*depth)(x, y), 0.0, 1e-9);
            }
            ASSERT_NEAR((*depth)(in.nx + x, y), 8.0, 4.0);
        }
    }
}

TEST(SurroundingLand, CountsDepthsInMetresAndHeightsInTheirUnit) {
    const Snapshot bed = coast(8.0);
    Snapshot in_quarters = bed;
    in_quarters.scale.height_unit = 0.25;
    for (SnapshotField& field : in_quarters.fields)
        if (field.name == "water_depth")
            for (double& depth : field.values.values()) depth *= 0.25;
    const PlainMaps metres(bed);
    const PlainMaps quarters(in_quarters);
    const Grid& deep = *field_of(metres.maps.fields, "water_depth");
    const Grid& quarter = *field_of(quarters.maps.fields, "water_depth");
    int wet = 0;
    for (int y = 0; y < metres.ny; ++y) {
        for (int x = 0; x < 2 * metres.nx; ++x) {
            if (deep(x, y) < 1.0) continue;
            ++wet;
            ASSERT_NEAR(quarter(x, y), 0.25 * deep(x, y), 1e-9) << x << ' ' << y;
        }
    }
    EXPECT_GT(wet, metres.nx * metres.ny);
}

TEST(SurroundingLand, LeavesLandByTheSeaDry) {
    Snapshot bed = coast(8.0);
    bed.bed(10, 20) = -20.0;  // a dry hollow
    const PlainMaps in(bed);
    const Grid& depth = *field_of(in.maps.fields, "water_depth");
    EXPECT_NEAR(depth(in.nx + 5, 5), 8.0, 4.0) << "is no level of the sea";
    for (int y = in.south + 5; y < in.south + bed_ny - 5; ++y)
        for (int away = 1; away <= 6; ++away) ASSERT_LT(depth(in.west - away, y), 1e-3);
}

TEST(SurroundingLand, TakesNoRowOfEqualHeightsForTheSea) {
    Snapshot bed = valley();
    for (int x = 0; x < bed_nx; ++x) bed.bed(x, 0) = -2.0;
    const PlainMaps in(bed);
    const Grid far = tile_from(in, in.nx);
    const auto [low, high] = std::ranges::minmax(far.values());
    EXPECT_GT(high - low, 5.0);
}

constexpr int foot_cells = 100;

/// A cone with a crater, whose feet end at four sides and, lower, at the corners.
Snapshot volcano() {
    Snapshot land = valley();
    land.scale.dx = land.scale.dy = 80.0;
    land.bed = Grid(foot_cells, foot_cells);
    for (int y = 0; y < foot_cells; ++y) {
        for (int x = 0; x < foot_cells; ++x) {
            const double east = 80.0 * (x - 49.5);
            const double north = 80.0 * (y - 49.5);
            const double away = std::hypot(east, north);
            const double crater = away < 400.0 ? -160.0 * (1.0 - away * away / 160000.0) : 0.0;
            land.bed(x, y) = 1500.0 * std::exp(-away / 1500.0) + crater +
                             8.0 * std::sin(1.1 * x + 0.4 * y) * std::sin(1.3 * y);
        }
    }
    return land;
}

TEST(SurroundingLand, HasNoWallAroundALoneMountain) {
    const Snapshot bed = volcano();
    const PlainMaps in(bed);
    double worst = 0.0;
    const auto see = [&](int x, int y, int u, int v) {
        worst = std::max(worst, std::abs(in.maps.bed(x, y) - in.maps.bed(x + u, y + v)));
    };
    for (int i = 0; i < foot_cells; ++i) {
        see(in.west, in.south + i, -1, 0);
        see(in.west + foot_cells - 1, in.south + i, 1, 0);
        see(in.west + i, in.south, 0, -1);
        see(in.west + i, in.south + foot_cells - 1, 0, 1);
    }
    const double own = largest_step(bed.bed, 0, 10, 0, foot_cells);
    EXPECT_LT(worst, 3.0 * own) << "its summit does not lift the land beyond its feet";
}

TEST(SurroundingLand, IsAsGentleAsTheFootOfALoneMountain) {
    const Snapshot bed = volcano();
    const PlainMaps in(bed);
    Mask within(foot_cells, foot_cells);
    for (int y = 12; y + 12 < foot_cells; ++y)
        for (int x = 12; x + 12 < foot_cells; ++x) within(x, y) = 1;
    const double foot = mean_gradient(bed.bed, within, 80.0, 80.0);
    const double whole = mean_gradient(bed.bed, {}, 80.0, 80.0);
    ASSERT_LT(1.4 * foot, whole);
    EXPECT_NEAR(mean_gradient(tile_from(in, in.nx), {}, 80.0, 80.0), foot, 0.25 * foot);
}

}  // namespace
}  // namespace fumon
