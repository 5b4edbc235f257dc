#include "render/land/land_cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace fumon {
namespace {

constexpr int land_side = 60;

/// A tent of cells of 10 m. Its ridge runs from west to east; a valley leads down its northern
/// side.
Snapshot tent(double slope) {
    Snapshot bed;
    bed.landform = Landform::terrain;
    bed.scale = {10.0, 10.0, 1.0, true};
    bed.bed = Grid(land_side, land_side);
    for (int y = 0; y < land_side; ++y) {
        for (int x = 0; x < land_side; ++x) {
            const double aside = std::abs(x - 30);
            const double valley = y > 30 ? 0.1 * slope * 10.0 * aside : 0.0;
            bed.bed(x, y) = 500.0 - slope * 10.0 * std::abs(y - 30) + valley;
        }
    }
    return bed;
}

TEST(LandCover, GrowsGrassWhereItIsWetOrFacesNorthAndNoneOnRock) {
    const Field<CellCover> gentle = land_cover(tent(0.2), std::nullopt);
    EXPECT_EQ(gentle(10, 45).rock, 0);
    EXPECT_GT(gentle(10, 45).grass, gentle(10, 15).grass) << "faces north";
    EXPECT_GT(gentle(10, 45).green, gentle(10, 15).green + 40);
    EXPECT_GT(gentle(30, 50).green, gentle(20, 50).green) << "the valley's bottom";
    const Field<CellCover> steep = land_cover(tent(1.0), std::nullopt);
    EXPECT_GT(steep(10, 15).rock, 240);
    EXPECT_EQ(steep(10, 15).grass, 0);
    EXPECT_EQ(steep(10, 15).snow, 0);
}

TEST(LandCover, LaysSnowAboveALineLowerInShadeAndNoneOnWalls) {
    const Snapshot bed = tent(0.3);  // 410 to 500 m
    const Field<CellCover> cover = land_cover(bed, 460.0);
    EXPECT_EQ(cover(10, 30).snow, 255) << "500 m";
    EXPECT_EQ(cover(10, 5).snow, 0) << "425 m";
    EXPECT_GT(cover(30, 44).snow, cover(30, 16).snow + 60) << "458 m, north and south";
    EXPECT_EQ(land_cover(tent(2.0), 0.0)(10, 15).snow, 0);
}

TEST(LandCover, IsNothingWhereThereIsNoLand) {
    Snapshot bed = tent(0.2);
    bed.nodata = Mask(land_side, land_side, 0);
    for (int y = 0; y < land_side; ++y) bed.nodata(5, y) = 1;
    const Field<CellCover> cover = land_cover(bed, 0.0);
    EXPECT_EQ(cover(5, 20).grass, 0);
    EXPECT_EQ(cover(5, 20).snow, 0);
    EXPECT_GT(cover(6, 20).snow, 0);
    EXPECT_EQ(cover(6, 20).rock, 0) << "no wall beside what is missing";
}

TEST(LandCover, GrowsUnderShallowWaterAlone) {
    Snapshot bed = tent(0.2);
    bed.fields = {{"water_depth", "", "m", Grid(land_side, land_side)}};
    bed.fields[0].values(10, 45) = 0.05;
    bed.fields[0].values(11, 45) = 2.0;
    const Field<CellCover> dry = land_cover(tent(0.2), std::nullopt);
    const Field<CellCover> cover = land_cover(bed, 400.0);
    EXPECT_EQ(cover(10, 45).grass, dry(10, 45).grass);
    EXPECT_EQ(cover(11, 45).grass, 0);
    EXPECT_EQ(cover(11, 45).snow, 0);
    EXPECT_GT(cover(12, 45).snow, 0);
}

}  // namespace
}  // namespace fumon
