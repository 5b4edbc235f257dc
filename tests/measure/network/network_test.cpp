// Flow routing and channel networks, on beds whose drainage is known: a plane, a V-shaped valley, a
// cone, a tree of streams drawn by hand, and real land.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "files/terrain/terrain_format.h"
#include "measure/network/channel_distance.h"
#include "measure/network/channel_network.h"
#include "measure/network/stream_path.h"
#include "measure/suite.h"

namespace fumon::test {
namespace {

template <class Height>
Grid bed_of(int nx, int ny, Height height) {
    Grid bed(nx, ny);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) bed(x, y) = height(x, y);
    return bed;
}

TEST(FlowRouting, ATiltedPlaneDrainsInParallel) {
    const Grid plane = bed_of(12, 30, [](int, int y) { return 0.1 * y; });
    const FlowRouting wrapped = route_flow(plane, {}, 2.0, 3.0, true);
    const Grid area = drainage_area(wrapped);
    for (int y = 0; y < 29; ++y) {
        // The northern edge is an outlet of its own.
        for (int x = 0; x < 12; ++x) EXPECT_EQ(area(x, y), 6.0 * (29 - y)) << x << " " << y;
    }
    const NetworkShape shape = network_shape(wrapped, 60.0, {}, true);
    EXPECT_EQ(shape.highest_order, 1.0);
    EXPECT_EQ(shape.sources, 12.0);
    EXPECT_TRUE(std::isnan(shape.bifurcation_ratio));
    EXPECT_NEAR(shape.concavity, 0.0, 1e-12) << "one slope everywhere";
    EXPECT_NEAR(shape.longest_path_length, 28 * 3.0, 1e-12);
    // Channels of 20 rows of 30, all 12 columns: y = 0 … 19, of which row 0 is the outlet.
    EXPECT_NEAR(shape.drainage_density, 12 * 19 * 3.0 / (12 * 30 * 6.0), 1e-12);
}

TEST(FlowRouting, AValleyGathersItsSides) {
    // Steep sides and a gentle floor along x = 10; water leaves at the south.
    const Grid valley =
        bed_of(21, 40, [](int x, int y) { return 1.0 * std::abs(x - 10) + 0.01 * y; });
    const FlowRouting routing = route_flow(valley, {}, 1.0, 1.0);
    const Grid area = drainage_area(routing);
    // Rows but the northern edge, without the two sides' edges, which are outlets.
    for (int y = 1; y < 39; ++y) EXPECT_EQ(area(10, y), 19.0 * (39 - y)) << y;
    const NetworkShape shape = network_shape(routing, 40.0, {});
    EXPECT_EQ(shape.highest_order, 1.0);
    EXPECT_EQ(shape.sources, 1.0);
    EXPECT_NEAR(shape.spacing, 4.0 * 110.0 / 21.0, 0.6) << "distances 0 … 10 on both sides";
}

TEST(FlowRouting, AConeDrainsAllItsCells) {
    const Grid cone = bed_of(41, 41, [](int x, int y) { return -std::hypot(x - 20, y - 20); });
    const FlowRouting routing = route_flow(cone, {}, 1.0, 1.0);
    const Grid area = drainage_area(routing);
    double drained = 0.0;
    for (std::size_t cell = 0; cell < area.size(); ++cell) {
        if (routing.receiver.values()[cell] == FlowRouting::outlet) drained += area.values()[cell];
    }
    EXPECT_EQ(drained, 41.0 * 41.0);
    EXPECT_EQ(area(20, 20), 1.0);
    // The four quarters are alike.
    EXPECT_EQ(routing.upward.size(), area.size());
}

TEST(FlowRouting, FilledGroundHasNoHollowAndNothingIsLost) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Grid ground(40, 30);
        for (int y = 0; y < 30; ++y) {
            RandomStream stream(seed, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
            for (double& height : ground.row(y)) height = std::floor(5.0 * stream.uniform());
        }
        Mask nodata(40, 30);
        for (int x = 5; x < 12; ++x) nodata(x, 14) = 1;
        const FlowRouting routing = route_flow(ground, nodata, 1.0, 2.0);
        const Grid area = drainage_area(routing);
        double drained = 0.0;
        for (const std::int32_t cell : routing.upward) {
            const auto here = static_cast<std::size_t>(cell);
            EXPECT_GE(routing.level.values()[here], ground.values()[here]);
            EXPECT_GE(routing.fall(cell), 0.0);
            if (routing.receiver.values()[here] == FlowRouting::outlet)
                drained += area.values()[here];
        }
        EXPECT_EQ(drained, 2.0 * (40 * 30 - 7)) << seed;
        EXPECT_EQ(area(7, 14), 0.0);
    }
}

/// A bed into which a tree of streams is cut: letters are ridges ('#') or streams; each stream cell
/// lies below the ridges by how near it is to the southern edge.
Grid carved(const std::vector<std::string>& drawing) {
    const int ny = static_cast<int>(drawing.size());
    const int nx = static_cast<int>(drawing.front().size());
    return bed_of(nx, ny, [&](int x, int y) {
        const char mark =
            drawing[static_cast<std::size_t>(ny - 1 - y)][static_cast<std::size_t>(x)];
        return mark == '#' ? 1000.0 + y : 1.0 * y;
    });
}

TEST(ChannelNetwork, OrdersOfATreeDrawnByHandAreStrahlers) {
    // Two pairs of sources make two streams of order 2, these one of order 3; a source from the
    // west joins it and leaves its order.
    const Grid bed = carved({"#################",  //
                             "##.###.###.###.##",  //
                             "###.#.#####.#.###",  //
                             "####.#######.####",  //
                             "#####.#####.#####",  //
                             "######.###.######",  //
                             "#######.#.#######",  //
                             "########.########",  //
                             "##.#####.########",  //
                             "###.####.########",  //
                             "####.###.########",  //
                             "#####.##.########",  //
                             "######.#.########",  //
                             "#######..########",  //
                             "########.########",  //
                             "########.########"});
    const FlowRouting routing = route_flow(bed, {}, 1.0, 1.0);
    // Areas that mark exactly the drawn streams: 1 for these, 0 for the ridges.
    Grid marks(bed.nx(), bed.ny());
    std::ranges::transform(bed.values(), marks.values().begin(),
                           [](double height) { return height < 1000.0 ? 1.0 : 0.0; });
    const ChannelNetwork network = channel_network(routing, marks, 0.5);
    EXPECT_EQ(network.streams, (std::vector<double>{5.0, 2.0, 1.0}));
    EXPECT_EQ(network.order(8, 0), 3);
    EXPECT_EQ(network.order(2, 14), 1);
    EXPECT_EQ(network.order(5, 11), 2);
    EXPECT_EQ(network.order(3, 6), 1) << "the source from the west";
    EXPECT_EQ(network.order(2, 3), 0) << "a ridge";
    const double diagonal = std::sqrt(2.0);
    EXPECT_NEAR(network.lengths[2], 8.0, 1e-12);
    EXPECT_NEAR(network.lengths[1], 2 * 4 * diagonal, 1e-12);
    EXPECT_NEAR(network.lengths[0], (4 * 2 + 6) * diagonal, 1.0);
}

TEST(ChannelNetwork, RatiosOfSuccessiveOrdersAreWeightedByTheirStreams) {
    // 38 of order 1, 10 of order 2, 2 of order 3: (3.8 · 48 + 5 · 12) / 60.
    EXPECT_NEAR(weighted_mean_ratio({38, 10, 2}, {38, 10, 2}), 4.04, 1e-12);
    EXPECT_NEAR(weighted_mean_ratio({1.0, 0.5, 0.125}, {38, 10, 2}), (2.0 * 48 + 4.0 * 12) / 60,
                1e-12);
    EXPECT_TRUE(std::isnan(weighted_mean_ratio({7}, {7})));
}

TEST(ChannelNetwork, TheFitsFindTheLawsThatABedWasMadeWith) {
    // A river along x = 1 of a bed with three columns, its slope the −0.4th power of its area.
    const int ny = 400;
    std::vector<double> river(ny, 0.0);
    for (int y = 1; y < ny; ++y) {
        const double area = 1.0 * (ny - 1 - y) + 1.0;
        river[static_cast<std::size_t>(y)] =
            river[static_cast<std::size_t>(y - 1)] + 0.1 * std::pow(area, -0.4);
    }
    const Grid bed = bed_of(3, ny, [&](int x, int y) {
        return x == 1 ? river[static_cast<std::size_t>(y)] : 50.0 + 0.0 * y;
    });
    const NetworkShape shape = network_shape(route_flow(bed, {}, 1.0, 1.0), 4.0, {});
    EXPECT_NEAR(shape.concavity, 0.4, 0.02);
    EXPECT_THROW(network_shape(route_flow(bed, {}, 1.0, 1.0), 0.0, {}), InputError);
}

TEST(ChannelDistance, IsExact) {
    Field<std::uint8_t> channels(23, 17);
    const std::vector<std::pair<int, int>> marked{{2, 3}, {20, 1}, {11, 15}, {12, 9}};
    for (const auto& [x, y] : marked) channels(x, y) = 1;
    for (const bool wraps : {false, true}) {
        double sum = 0.0;
        for (int y = 0; y < 17; ++y) {
            for (int x = 0; x < 23; ++x) {
                double nearest = 1e9;
                for (const auto& [u, v] : marked) {
                    int across = std::abs(u - x);
                    if (wraps) across = std::min(across, 23 - across);
                    nearest = std::min(nearest, std::hypot(1.5 * across, 0.7 * (v - y)));
                }
                sum += nearest;
            }
        }
        EXPECT_NEAR(mean_channel_distance(channels, {}, 1.5, 0.7, wraps), sum / (23 * 17), 1e-12);
    }
    EXPECT_TRUE(std::isnan(mean_channel_distance(Field<std::uint8_t>(4, 4), {}, 1.0, 1.0)));
}

NetworkShape shape_of(const std::filesystem::path& file, double area) {
    const Terrain land = read_terrain(file, {});
    return network_shape(route_flow(land.heights, land.nodata, land.dx, land.dy), area,
                         land.nodata);
}

TEST(RealLand, AGullysBasinsGrowAsHacksLawHasIt) {
    // Hack (1957) found 0.6; Montgomery & Dietrich (1992) 0.5 to 0.7 for small basins.
    const NetworkShape shape =
        shape_of(std::filesystem::path(FUMON_TERRAIN_FOLDER) / "west_bijou_gully.asc", 100.0);
    EXPECT_GT(shape.hack_exponent, 0.5);
    EXPECT_LT(shape.hack_exponent, 0.7);
    EXPECT_GE(shape.sources, 10.0);
}

TEST(RealLand, MountainsHaveTheRatiosOfHortonAndStrahler) {
    const char* folder = std::getenv("FUMON_REAL_TERRAIN");
    if (folder == nullptr)
        GTEST_SKIP() << "FUMON_REAL_TERRAIN names no folder with srtm_boulder_front_range.asc";
    for (const double area : {2e5, 5e5, 1e6}) {
        const NetworkShape shape =
            shape_of(std::filesystem::path(folder) / "srtm_boulder_front_range.asc", area);
        EXPECT_GT(shape.bifurcation_ratio, 3.0) << area << ": 3 to 5, Strahler (1957)";
        EXPECT_LT(shape.bifurcation_ratio, 5.0) << area;
        EXPECT_GT(shape.length_ratio, 1.5) << area << ": 1.5 to 3.5, Horton (1945)";
        EXPECT_LT(shape.length_ratio, 3.5) << area;
        EXPECT_GT(shape.hack_exponent, 0.5) << area;
        EXPECT_LT(shape.hack_exponent, 0.65) << area;
        EXPECT_GT(shape.concavity, 0.1) << area << ": slopes fall downstream";
    }
}

TEST(NetworkMeasures, StandInTheSuiteWhereTheyAreAskedFor) {
    Snapshot land;
    land.landform = Landform::terrain;
    land.bed = bed_of(30, 30, [](int x, int y) { return std::abs(x - 15) + 0.1 * y; });
    land.scale = {10.0, 10.0, 1.0, true};
    const MeasureSuite usual(Landform::bed, land);
    MeasureSuite asked(Landform::bed, land, {5000.0});
    ASSERT_EQ(asked.columns().size(), usual.columns().size() + 11);
    const std::vector<double> row = asked.row(land);
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (asked.columns()[k].name == "stream_sources") {
            EXPECT_EQ(row[k], 1.0);
        }
        if (asked.columns()[k].name == "drainage_density") {
            EXPECT_EQ(asked.columns()[k].unit, "1/m");
            EXPECT_GT(row[k], 0.0);
        }
    }
    Snapshot sand = land;
    sand.landform = Landform::bed;
    EXPECT_EQ(MeasureSuite(Landform::bed, sand, {5000.0}).columns().size(),
              MeasureSuite(Landform::bed, sand).columns().size());
}

}  // namespace
}  // namespace fumon::test
