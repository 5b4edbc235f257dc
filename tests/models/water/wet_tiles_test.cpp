// Dry ground is passed over, and nothing shows it.

#include "models/water/wet_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "models/water/finite_volume_scheme.h"
#include "models/water/water_setup.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

std::string marks(const WetTiles& tiles) {
    std::string text;
    for (int y = 0; y < tiles.rows(); ++y) {
        for (int x = 0; x < tiles.columns(); ++x) text += tiles.is_wet(x, y) ? 'w' : '.';
        text += '|';
    }
    return text;
}

TEST(WetTiles, AreThoseThatWaterCanReach) {
    WorkerPool pool(2);
    Grid depth(64 * 3 + 20, 8 * 4 + 5);
    WetTiles walled(depth.nx(), depth.ny(), false, false);
    walled.find(depth, pool);
    EXPECT_EQ(marks(walled), "....|....|....|....|....|");
    depth(100, 3) = 1e-300;
    walled.find(depth, pool);
    EXPECT_EQ(marks(walled), ".w..|....|....|....|....|");
    depth(100, 7) = 1.0;
    depth(66, 20) = 1.0;
    walled.find(depth, pool);
    EXPECT_EQ(marks(walled), ".w..|.w..|ww..|ww..|....|");
    int dried = 0;
    depth(100, 3) = depth(100, 7) = depth(66, 20) = 0.0;
    walled.find(depth, pool);
    walled.for_each_dried([&](int first_x, int first_y, int end_x, int end_y) {
        ++dried;
        EXPECT_EQ(end_x - first_x, 64);
        EXPECT_EQ(end_y - first_y, 8);
    });
    EXPECT_EQ(dried, 6);
    walled.keep_wet(211, 36);
    walled.find(depth, pool);
    EXPECT_EQ(marks(walled), "....|....|....|....|...w|");
    WetTiles periodic(depth.nx(), depth.ny(), true, true);
    periodic.keep_wet(0, 0);
    periodic.find(depth, pool);
    EXPECT_EQ(marks(periodic), "w..w|....|....|....|w..w|");
    periodic.find_all();
    EXPECT_EQ(marks(periodic), "wwww|wwww|wwww|wwww|wwww|");
}

TEST(WetTiles, AreReachedAcrossALastSquareOfOneCell) {
    WorkerPool pool(1);
    Grid depth(64 * 2 + 1, 8 * 2 + 1);
    WetTiles tiles(depth.nx(), depth.ny(), true, true);
    depth(127, 8) = 1.0;  // two faces from the first cell of the row
    tiles.find(depth, pool);
    EXPECT_EQ(marks(tiles), "www|www|...|");
    depth(127, 8) = 0.0;
    depth(40, 15) = 1.0;
    tiles.find(depth, pool);
    EXPECT_EQ(marks(tiles), "w..|w..|w..|");
}

TEST(WetTiles, AreSharedOutEqually) {
    WorkerPool pool(1);
    Grid depth(70, 64);
    WetTiles tiles(depth.nx(), depth.ny(), false, false);
    tiles.find(depth, pool);
    EXPECT_EQ(tiles.equal_shares(3).back(), 64);
    for (int y = 48; y < 64; ++y) depth(5, y) = 1.0;  // near the tiles from row 40 on
    tiles.find(depth, pool);
    EXPECT_EQ(tiles.equal_shares(2), (std::vector<int>{0, 52, 64}));
    tiles.find_all();
    EXPECT_EQ(tiles.equal_shares(4), (std::vector<int>{0, 16, 32, 48, 64}));
}

/// Two schemes over the same water, of which one must advance all cells.
class PassedOver : public ::testing::TestWithParam<EdgeKind> {};

TEST_P(PassedOver, GivesTheBitsOfAllCells) {
    constexpr int nx = 64 * 4 + 9;
    constexpr int ny = 32 * 4 + 3;
    GullyParameters parameters;
    parameters.friction = FrictionLaw::manning;
    parameters.edges_x = parameters.edges_y = GetParam();
    if (GetParam() == EdgeKind::wall) {
        EdgeSettings in = edge(GridSide::north, EdgeFlow::discharge);
        in.from = 180.0;
        in.to = 186.0;
        in.times = {0.0, 2.0, 12.0};
        in.values = {0.0, 0.0, 9.0};
        parameters.edges = {in};
    }
    WaterDomain domain;
    domain.edges_x = domain.edges_y = GetParam();
    domain.segments = edge_segments_of(parameters, domain, nx, ny);
    domain.nodata = Mask(nx, ny);
    if (GetParam() != EdgeKind::periodic) domain.nodata(70, 40) = 1;
    const Grid bed = noise(nx, ny, 0.1);
    Water water{Grid(nx, ny), Grid(nx, ny), Grid(nx, ny)};
    for (int y = 2; y < 20; ++y) {
        for (int x = 30; x < 61; ++x) water.depth(x, y) = 2.0;
    }
    Water all = water;
    WorkerPool pool(2);
    FiniteVolumeScheme scheme(parameters, domain, pool);
    FiniteVolumeScheme whole(parameters, domain, pool);
    FaceFlows flows(nx, ny);
    FaceFlows all_flows(nx, ny);
    scheme.record(flows);
    whole.record(all_flows);
    const Grid no_rain(nx, ny);
    whole.set_rain(&no_rain);
    const auto same = [](const Grid& a, const Grid& b) {
        return std::ranges::equal(a.values(), b.values());
    };
    for (int step = 0; step < 60; ++step) {
        const double dt = std::min(0.1, 0.4 * scheme.step_at_courant_one(water));
        scheme.set_time(0.2 * step);
        whole.set_time(0.2 * step);
        EXPECT_EQ(scheme.advance(water, bed, dt, 0.0), whole.advance(all, bed, dt, 0.0));
        if (step == 30) {  // it is gone
            for (Grid* grid : {&water.depth, &water.velocity_x, &water.velocity_y, &all.depth,
                               &all.velocity_x, &all.velocity_y}) {
                for (int y = 0; y < ny; ++y)
                    std::fill(grid->row(y).begin(), grid->row(y).begin() + 128, 0.0);
            }
        }
        ASSERT_TRUE(same(water.depth, all.depth)) << step;
        ASSERT_TRUE(same(water.velocity_x, all.velocity_x)) << step;
        ASSERT_TRUE(same(water.velocity_y, all.velocity_y)) << step;
        for (std::size_t k = 0; k < 2; ++k) {
            ASSERT_TRUE(same(flows.stages[k].east, all_flows.stages[k].east)) << step;
            ASSERT_TRUE(same(flows.stages[k].north, all_flows.stages[k].north)) << step;
        }
        ASSERT_TRUE(same(*flows.between, *all_flows.between)) << step;
        ASSERT_EQ(scheme.left(), whole.left());
        ASSERT_EQ(scheme.entered(), whole.entered());
    }
    if (GetParam() == EdgeKind::wall) {
        EXPECT_GT(scheme.entered(), 1.0);
    }
    if (GetParam() == EdgeKind::open) {
        EXPECT_GT(scheme.left(), 1.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Edges, PassedOver,
                         ::testing::Values(EdgeKind::wall, EdgeKind::open, EdgeKind::periodic));

}  // namespace
}  // namespace fumon::test
