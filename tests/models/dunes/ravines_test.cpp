#include "models/dunes/setup/ravines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/dunes/dunes.h"
#include "models/dunes/setup/ground_features.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

DuneGround ground_of_cells(int cells, double size) {
    DuneGround ground;
    ground.nx = cells;
    ground.ny = cells;
    ground.dx = size;
    ground.dy = size;
    return ground;
}

DuneFeature hill() {
    DuneFeature feature;
    feature.x = 32.0;
    feature.y = 32.0;
    feature.length = 60.0;
    feature.width = 44.0;
    feature.height = 20.0;
    feature.axis = 30.0;
    feature.ravines = 0.5;
    return feature;
}

Grid cut(const DuneFeature& feature, const DuneGround& ground, std::uint64_t seed,
         std::uint32_t rock) {
    Grid shape = feature_shape(feature, ground);
    cut_ravines(shape, feature, ground, seed, rock);
    return shape;
}

double mean_difference(const Grid& one, const Grid& other) {
    double sum = 0.0;
    for (std::size_t cell = 0; cell < one.size(); ++cell)
        sum += std::abs(one.values()[cell] - other.values()[cell]);
    return sum / static_cast<double>(one.size());
}

TEST(Ravines, AreSmoothAndReachFromRidgesToTheDeepest) {
    const Ravines ravines(3, 1, 10.0, 2.0);
    constexpr double way = 1e-4;
    double least = 1.0;
    double deepest = 0.0;
    for (int k = 0; k < 4000; ++k) {
        const double x = 0.37 * k - 700.0;
        const double y = 150.0 - 0.11 * k;
        const double depth = ravines.depth_at(x, y);
        least = std::min(least, depth);
        deepest = std::max(deepest, depth);
        ASSERT_LT(std::abs(ravines.depth_at(x + way, y) - depth), 2.0 * way) << x;
        ASSERT_LT(std::abs(ravines.depth_at(x, y + way) - depth), 2.0 * way) << y;
    }
    EXPECT_GE(least, 0.0);
    EXPECT_LT(least, 0.05);
    EXPECT_GT(deepest, 0.75);
    EXPECT_LE(deepest, 1.0);
}

TEST(Ravines, TakeNoMoreOfAHillThanTheirShare) {
    const DuneGround ground = ground_of_cells(64, 1.0);
    const Grid whole = feature_shape(hill(), ground);
    const Grid left = cut(hill(), ground, 5, 1);
    double least = 1.0;
    for (std::size_t cell = 0; cell < whole.size(); ++cell) {
        const double before = whole.values()[cell];
        ASSERT_LE(left.values()[cell], before);
        ASSERT_GE(left.values()[cell], 0.5 * before);
        if (before > 0.0) least = std::min(least, left.values()[cell] / before);
    }
    EXPECT_LT(least, 0.7);
}

TEST(Ravines, DifferByRockAndSeedAndHardlyByTheSizeOfCells) {
    const DuneGround ground = ground_of_cells(64, 1.0);
    const Grid first = cut(hill(), ground, 5, 1);
    EXPECT_GT(mean_difference(first, cut(hill(), ground, 5, 2)), 0.01);
    EXPECT_GT(mean_difference(first, cut(hill(), ground, 6, 1)), 0.01);
    const Grid fine = cut(hill(), ground_of_cells(192, 1.0 / 3.0), 5, 1);
    Grid middles(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) middles(x, y) = fine(3 * x + 1, 3 * y + 1);
    EXPECT_LT(mean_difference(first, middles), 0.01);
}

TEST(Ravines, CutTheRockOfABedAndNoSand) {
    WorkerPool pool(1);
    const ModelSetup setup{Grid(64, 64, 0.0), {}, {1.0, 1.0, 1.0, true}, 5, pool};
    DunesParameters parameters;
    parameters.rock_level = 0.0;
    parameters.features = {hill()};
    const Dunes dunes(parameters, setup);
    const Grid shape = cut(hill(), ground_of_cells(64, 1.0), 5, 1);
    for (std::size_t cell = 0; cell < shape.size(); ++cell)
        ASSERT_EQ(dunes.bed().rock.values()[cell], to_units(20.0 * shape.values()[cell])) << cell;
    parameters.features[0].kind = FeatureKind::sand;
    const std::string refusal = message_of<KeyError>([&] { Dunes(parameters, setup); });
    EXPECT_NE(refusal.find("only rock has ravines"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace fumon::test
