#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "base/snapshot_lookup.h"
#include "render/land/sea_water.h"
#include "support/plain_maps.h"

namespace fumon {
namespace {

constexpr int coast_nx = 120;
constexpr int coast_ny = 80;

/// Uneven land 60 m high at most, on cells of 20 m, by the height of what is broad in it.
template <class Height>
Snapshot land_of(const Height& broad) {
    Snapshot land = valley();
    land.scale.dx = land.scale.dy = 20.0;
    land.bed = Grid(coast_nx, coast_ny);
    for (int y = 0; y < coast_ny; ++y)
        for (int x = 0; x < coast_nx; ++x)
            land.bed(x, y) = std::min(broad(x, y), 60.0) +
                             4.0 * std::sin(0.7 * x + 0.3 * y) * std::sin(0.5 * y - 0.2 * x) +
                             2.0 * std::sin(1.9 * x) * std::sin(1.7 * y);
    return land;
}

/// Falls eastward into the sea of level 0.
Snapshot coast_in_the_east() {
    Snapshot land = land_of([](int x, int /*y*/) { return 2.0 * (70.0 - x); });
    add_sea(land, 0.0);
    return land;
}

constexpr int inlet_from = 50;  // cells
constexpr int inlet_until = 58;

/// An inlet of the sea enters from the south, along 2 % of the edge.
Snapshot inlet() {
    Snapshot land = land_of([](int x, int y) {
        const double aside = std::max({inlet_from - x, x - inlet_until + 1, y - 40, 0});
        return aside > 0.0 ? 12.0 * aside : -12.0;
    });
    add_sea(land, 0.0);
    return land;
}

Grid own_tile(const PlainMaps& in) {
    Grid tile(in.nx, in.ny);
    for (int y = 0; y < in.ny; ++y)
        for (int x = 0; x < in.nx; ++x) tile(x, y) = in.maps.bed(x, y);
    return tile;
}

bool is_surveyed(const PlainMaps& in, int x, int y) {
    return x >= in.west && x < in.west + coast_nx && y >= in.south && y < in.south + coast_ny;
}

/// Invented land with the sea of level 0 on one side at least.
std::vector<std::pair<int, int>> invented_shore(const PlainMaps& in) {
    std::vector<std::pair<int, int>> shore;
    for (int y = 1; y + 1 < in.ny; ++y) {
        for (int x = 1; x + 1 < in.nx; ++x) {
            const Grid& z = in.maps.bed;
            if (is_surveyed(in, x, y) || z(x, y) <= 0.0) continue;
            if (std::min({z(x - 1, y), z(x + 1, y), z(x, y - 1), z(x, y + 1)}) <= 0.0)
                shore.emplace_back(x, y);
        }
    }
    return shore;
}

/// The length of the longest straight band of two cells' width with cells in it, and no gap of
/// more.
double longest_straight(const std::vector<std::pair<int, int>>& cells) {
    constexpr double band = 2.0;  // cells
    constexpr int directions = 60;
    double longest = 0.0;
    for (int n = 0; n < directions; ++n) {
        const double angle = std::numbers::pi * n / directions;
        std::vector<std::pair<double, double>> turned;  // along, aside
        turned.reserve(cells.size());
        for (const auto& [x, y] : cells)
            turned.emplace_back(x * std::cos(angle) + y * std::sin(angle),
                                y * std::cos(angle) - x * std::sin(angle));
        std::ranges::sort(turned);
        for (const auto& line : turned) {
            double begin = -1e9;
            double last = -1e9;
            for (const auto& [along, aside] : turned) {
                if (std::abs(aside - line.second) > 0.5 * band) continue;
                if (along > last + band) begin = along;
                last = along;
                longest = std::max(longest, last - begin);
            }
        }
    }
    return longest;
}

TEST(SurroundingCoast, HasShoresThatWander) {
    for (const Snapshot& bed : {coast_in_the_east(), inlet()}) {
        const auto shore = invented_shore(PlainMaps(bed, 1, 0.0));
        ASSERT_GT(shore.size(), 200U);
        EXPECT_LT(longest_straight(shore), coast_nx / 3.0);
    }
}

TEST(SurroundingCoast, IsTheSameForAnyNumberOfThreads) {
    const Snapshot bed = coast_in_the_east();
    EXPECT_EQ(PlainMaps(bed, 1, 0.0).maps.bed, PlainMaps(bed, 2, 0.0).maps.bed);
}

TEST(SurroundingCoast, MeetsTheEdgeOnLandAndUnderWater) {
    const Snapshot bed = coast_in_the_east();
    const PlainMaps in(bed, 1, 0.0);
    const Grid z = own_tile(in);
    double own = largest_step(bed.bed, 0, coast_nx - 1, 0, coast_ny);
    for (int y = 0; y + 1 < coast_ny; ++y)
        for (int x = 0; x < coast_nx; ++x)
            own = std::max(own, std::abs(bed.bed(x, y + 1) - bed.bed(x, y)));
    const int east = in.west + coast_nx;
    const int north = in.south + coast_ny;
    for (int x = in.west; x < east; ++x) {
        EXPECT_LT(std::abs(z(x, in.south) - z(x, in.south - 1)), own) << x;
        EXPECT_LT(std::abs(z(x, north) - z(x, north - 1)), own) << x;
    }
    for (int y = in.south; y < north; ++y) {
        EXPECT_LT(std::abs(z(in.west, y) - z(in.west - 1, y)), own) << y;
        EXPECT_LT(std::abs(z(east, y) - z(east - 1, y)), own) << y;
    }
}

/// How many cells of a row of the tile lie in the part of the sea with a cell.
int width_of_sea(const Grid& tile, int x, int y) {
    int width = 0;
    for (int u = x; u < tile.nx() && tile(u, y) < 0.0; ++u) ++width;
    for (int u = x - 1; u >= 0 && tile(u, y) < 0.0; --u) ++width;
    return width;
}

TEST(SurroundingCoast, OpensANarrowInletToASeaThatIsKnown) {
    const PlainMaps in(inlet(), 1, 0.0);
    const Grid tile = own_tile(in);
    const int middle = in.west + (inlet_from + inlet_until) / 2;
    for (int y = 0; y < in.south + 20; ++y) ASSERT_LT(tile(middle, y), 0.0) << y;
    EXPECT_GT(width_of_sea(tile, middle, in.south - 8), (inlet_until - inlet_from) / 2);
    EXPECT_GT(width_of_sea(tile, middle, in.south - 20), 20);
    EXPECT_EQ(width_of_sea(tile, middle, 1), in.nx) << "all around";
    const Grid& depth = *field_of(in.maps.fields, "water_depth");
    for (int y = 0; y < in.ny; ++y) {
        ASSERT_GT(depth(in.nx + 5, y), 5.0) << "to the horizon";
        ASSERT_NEAR(depth(middle, y) + in.maps.bed(middle, y), 0.0,
                    tile(middle, y) < 0.0 ? 1e-9 : 99.0);
    }
}

TEST(SurroundingCoast, EndsStillWaterAlongALittleOfTheEdgeAsALake) {
    const PlainMaps in(inlet());
    const Grid& depth = *field_of(in.maps.fields, "water_depth");
    int wet = 0;
    for (int y = 0; y < in.ny; ++y) {
        for (int x = 0; x < in.nx; ++x) {
            EXPECT_LT(depth(in.nx + x, y), 0.1) << "no sea";
            if (is_surveyed(in, x, y) || depth(x, y) < 0.1) continue;
            ++wet;
            EXPECT_NEAR(depth(x, y) + in.maps.bed(x, y), 0.0, 1e-9) << x << ' ' << y;
            EXPECT_GT(y, in.south - 20) << "a canal";
            for (const int u : {x - 1, x + 1}) {
                EXPECT_TRUE(depth(u, y) > 0.0 || in.maps.bed(u, y) >= 0.0) << "no bank holds it";
            }
        }
    }
    EXPECT_GT(wet, 10);
}

TEST(SurroundingCoast, IsNotMadeWhereNoEdgeLiesInTheSea) {
    const Snapshot bed = valley();
    const auto [low, high] = std::ranges::minmax(bed.bed.values());
    EXPECT_EQ(PlainMaps(bed, 1, low - 1.0).maps.bed, PlainMaps(bed).maps.bed);
}

TEST(SurroundingCoast, LeavesAnIslandAlone) {
    Snapshot island = land_of([](int x, int y) {
        return 50.0 - 2.5 * std::hypot(x - 0.5 * coast_nx, y - 0.5 * coast_ny);
    });
    add_sea(island, 0.0);
    EXPECT_TRUE(invented_shore(PlainMaps(island, 1, 0.0)).empty());
}

}  // namespace
}  // namespace fumon
