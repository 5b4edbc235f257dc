#include "render/view/block.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/view_beds.h"

namespace fumon {
namespace {

Snapshot terrain(double relief_metres, double cell) {
    Snapshot snapshot;
    snapshot.bed = Grid(100, 50);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 100; ++x) snapshot.bed(x, y) = 900.0 + relief_metres * x / 99.0;
    snapshot.scale = {cell, cell, 1.0, true};
    return snapshot;
}

Snapshot noise() {
    Snapshot snapshot;
    snapshot.bed = Grid(100, 100);
    std::mt19937 random(1);
    for (double& height : snapshot.bed.values())
        height = std::uniform_real_distribution<>()(random);
    return snapshot;
}

TEST(Exaggeration, RaisesFlatRealTerrainToAReadableRelief) {
    EXPECT_EQ(automatic_exaggeration(terrain(2000.0, 100.0)), 1.0);  // 20 % of 10 km
    EXPECT_EQ(automatic_exaggeration(terrain(900.0, 100.0)), 1.5);
    EXPECT_EQ(automatic_exaggeration(terrain(500.0, 100.0)), 3.0);
    EXPECT_EQ(automatic_exaggeration(terrain(1.0, 1.0)), 15.0);  // a gully 1 m deep in 100 m
    EXPECT_EQ(automatic_exaggeration(terrain(1e-6, 1.0)), 100.0);
}

/// Ridges of metres across x: a long stoss, and a slip face of two cells whose tangent is given.
Snapshot ridges(double slip_face) {
    Snapshot snapshot;
    snapshot.bed = Grid(480, 20);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 480; ++x) {
            const int on = x % 40;
            const int below_brink = std::max(on - 38, 0);
            const double stoss = std::min(on, 38) / 38.0;
            snapshot.bed(x, y) = slip_face * (2.0 * stoss - below_brink);
        }
    }
    snapshot.scale = {1.0, 1.0, 1.0, true};
    return snapshot;
}

TEST(Exaggeration, KeepsSlipFacesFromBecomingSpires) {
    EXPECT_EQ(relief_exaggeration(ridges(0.65)), 50.0);
    EXPECT_EQ(automatic_exaggeration(ridges(0.65)), 1.5);
    EXPECT_EQ(automatic_exaggeration(ridges(0.3)), 3.0);
    EXPECT_EQ(automatic_exaggeration(ridges(3.0)), 1.0) << "steeper than 45° as it is";
    Snapshot few = terrain(1.0, 1.0);
    few.bed(50, 25) += 5.0;  // a rock
    EXPECT_EQ(automatic_exaggeration(few), relief_exaggeration(few));
}

TEST(Exaggeration, LeavesModelBedsAlone) {
    Snapshot bed = noise();
    EXPECT_EQ(automatic_exaggeration(bed), 1.0);
    bed.scale.in_metres = true;
    EXPECT_EQ(automatic_exaggeration(bed), 1.0);
    Snapshot flat = terrain(0.0, 1.0);
    EXPECT_EQ(automatic_exaggeration(flat), 1.0);
    Snapshot sites = terrain(1.0, 1.0);
    sites.scale.in_metres = false;
    EXPECT_EQ(automatic_exaggeration(sites), 1.0);
}

TEST(Block, ItsUndersideLiesBelowWhatSandModelsReach) {
    const Block block = frame_block(noise(), 1.0);
    EXPECT_LT(block.base, block.z(-0.2));
    EXPECT_GE(block.top, block.z(5.0));  // room for dunes of five sites
}

TEST(Block, MeasuresCellsNotTheirCentres) {
    Snapshot bed = wavy_bed(50, 20);
    bed.scale.dx = 2.0;
    const Block block = frame_block(bed, 1.0);
    EXPECT_DOUBLE_EQ(block.side, 100.0);
    EXPECT_DOUBLE_EQ(block.width_x, 1.0);
    EXPECT_DOUBLE_EQ(block.width_y, 0.2);
}

TEST(Block, AMaskedBedIsFramedByItsDomain) {
    const Block block = frame_block(masked_bed(100, 100), 1.0);
    for (const glm::dvec2& point : block.outline) {
        EXPECT_LT(std::abs(point.x), 0.47);
        EXPECT_LT(std::abs(point.y), 0.41);
    }
}

}  // namespace
}  // namespace fumon
