#include "render/life/plant_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/life/plant_meshes.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

Snapshot planted(double grass, double shrubs, double cell = 0.5, int nx = 40) {
    const int ny = nx * 3 / 4;
    Snapshot snapshot = wavy_bed(nx, ny);
    snapshot.scale = {cell, cell, 1.0, true};
    snapshot.fields.push_back({"grass", "grass", "1", Grid(nx, ny, grass)});
    snapshot.fields.push_back({"shrubs", "shrubs", "1", Grid(nx, ny, shrubs)});
    return snapshot;
}

Block block_of(const Snapshot& snapshot) {
    Block block;
    block.side = snapshot.bed.nx() * snapshot.scale.dx;
    block.width_y = 0.75;
    return block;
}

std::vector<Plant> positions(const Snapshot& snapshot, double share = 1.0) {
    return plant_positions(snapshot, block_of(snapshot), share);
}

TEST(PlantPositions, AreAsManyAsTheCoverSays) {
    EXPECT_TRUE(positions(planted(0.0, 0.0)).empty());
    EXPECT_TRUE(positions(wavy_bed(40, 30)).empty());
    constexpr double area = 120.0 * 90.0;  // m²
    const auto count = [](double grass, double shrubs, double share = 1.0) {
        return static_cast<double>(positions(planted(grass, shrubs, 0.5, 240), share).size());
    };
    const double full = count(1.0, 0.0);
    EXPECT_NEAR(full / area, 5.0, 0.1);
    EXPECT_NEAR(count(0.5, 0.0) / full, (0.5 - 0.04) / 0.9, 0.01);
    EXPECT_NEAR(count(1.0, 0.0, 0.3) / full, 0.3, 0.01);
    EXPECT_NEAR(count(0.0, 1.0) / area, 0.8, 0.03);
    const auto shrubs = positions(planted(0.0, 1.0));
    EXPECT_TRUE(std::ranges::all_of(
        shrubs, [](const Plant& plant) { return plant.kind == PlantKind::shrub; }));
}

TEST(PlantPositions, AreAsHighAsTheSnapshotSays) {
    Snapshot snapshot = planted(1.0, 1.0);
    const auto usual = positions(snapshot);
    snapshot.grass_height = 0.9;
    snapshot.shrub_height = 3.3;
    const auto high = positions(snapshot);
    ASSERT_EQ(high.size(), usual.size());
    for (std::size_t i = 0; i < high.size(); ++i) {
        const float times = high[i].kind == PlantKind::shrub ? 3.0F : 2.0F;
        ASSERT_NEAR(high[i].height / usual[i].height, times, 1e-4F);
    }
}

TEST(PlantPositions, PlantsGrowWhereTheyStandAsTheCoverGrows) {
    const auto before = positions(planted(0.4, 0.0));
    const auto after = positions(planted(0.45, 0.0));
    EXPECT_GT(after.size(), before.size());
    std::size_t next = 0;
    for (const Plant& plant : before) {
        while (next < after.size() && after[next].position != plant.position) ++next;
        ASSERT_LT(next, after.size());
        EXPECT_GE(after[next].height, plant.height);
        EXPECT_EQ(after[next].turn, plant.turn);
    }
}

TEST(PlantPositions, AreAsHighAsPlantsInMetres) {
    for (const double cell : {0.5, 2.0}) {
        const Snapshot snapshot = planted(1.0, 1.0, cell);
        float grass = 0.0F;
        float shrub = 0.0F;
        for (const Plant& plant : positions(snapshot)) {
            EXPECT_GE(plant.position.x, 0.0F);
            EXPECT_LE(plant.position.x, 1.0F);
            EXPECT_LE(plant.position.y, 0.75F);
            float& most = plant.kind == PlantKind::grass ? grass : shrub;
            most = std::max(most, plant.height * static_cast<float>(block_of(snapshot).side));
        }
        EXPECT_NEAR(grass, 0.45F, 0.01F);
        EXPECT_NEAR(shrub, 1.1F, 0.04F);
    }
}

TEST(PlantMeshes, StandOnTheGroundAndAreAboutOneHigh) {
    for (const PlantKind kind : {PlantKind::grass, PlantKind::shrub}) {
        std::size_t finer = 1U << 20U;
        for (const PlantDetail detail :
             {PlantDetail::near, PlantDetail::middle, PlantDetail::far}) {
            const auto mesh = plant_mesh(kind, detail);
            EXPECT_EQ(mesh.size() % 3, 0U);
            EXPECT_LT(mesh.size(), finer);
            finer = mesh.size();
            float low = 1.0F;
            float high = 0.0F;
            for (const LeafVertex& corner : mesh) {
                low = std::min(low, corner.position.z);
                high = std::max(high, corner.position.z);
                EXPECT_NEAR(glm::length(corner.normal), 1.0F, 1e-3F);
                EXPECT_LT(std::hypot(corner.position.x, corner.position.y), 1.1F);
            }
            EXPECT_GT(low, -0.2F);
            EXPECT_LT(low, 0.35F);
            EXPECT_GT(high, 0.75F);
            EXPECT_LT(high, 1.35F);
        }
    }
}

}  // namespace
}  // namespace fumon
