#include "render/view/tile_warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "render/view/framing.h"
#include "render/view/tile_warp_vectors.h"
#include "render/view/tile_warp_waves.h"
#include "support/repeated_dunes.h"
#include "vectors/target.h"

namespace fumon {
namespace {

/// Waves eastward, so many to the bed, and one low wave northward.
Snapshot bed_of_waves(int along) {
    Snapshot bed;
    bed.periodic = true;
    bed.bed = Grid(120, 80);
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 120; ++x)
            bed.bed(x, y) = std::sin(2.0 * std::numbers::pi * along * x / 120.0) +
                            0.1 * std::cos(2.0 * std::numbers::pi * y / 80.0);
    }
    return bed;
}

View standing() {
    View view;
    view.look.ground = Ground::endless;
    view.camera.at = {20.0, 12.0, 3.0};
    view.camera.look_at = {31.0, 20.0, 0.0};
    return view;
}

TileWarp copies_of(const View& view, const Snapshot& bed) {
    return tile_warp_of(view, framed_block(view, bed), bed);
}

/// Places all around, the nearest ones a period away.
std::vector<glm::dvec2> far_places() {
    std::vector<glm::dvec2> positions;
    for (int i = 0; i < 4000; ++i) {
        const double turn = 2.399963 * i;
        positions.push_back((1.0 + 0.01 * i) * glm::dvec2(std::cos(turn), std::sin(turn)));
    }
    return positions;
}

TEST(TileWarp, LeaveWhatTheCameraSeesAsItIs) {
    const View view = standing();
    const Snapshot bed = bed_of_waves(1);
    const Block block = framed_block(view, bed);
    const TileWarp copies = tile_warp_of(view, block, bed);
    ASSERT_TRUE(copies.varied());
    const glm::dvec2 middle = 0.5 * (glm::dvec2(*block.eye) + glm::dvec2(*block.look_at));
    const glm::dvec2 extent(block.width_x, block.width_y);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec2 way = 0.003 * i * glm::dvec2(std::cos(1.0 * i), std::sin(1.0 * i));
        const WarpedGround copy = copies.at(middle + way * extent);
        ASSERT_EQ(copy.offset, glm::dvec2(0.0));
        ASSERT_EQ(copy.height, 1.0);
    }
    EXPECT_NE(copies.at(middle + extent).offset, glm::dvec2(0.0));
    for (const std::vector<double>& at : {view.camera.at, view.camera.look_at}) {
        const glm::dvec2 position = glm::dvec2(at[0], at[1]) / block.side - 0.5 * extent;
        EXPECT_EQ(copies.bed_position_at(position), position);
    }
}

/// A bed that is looked at as a whole, from farther away than it is wide.
TEST(TileWarp, LeaveABlockThatIsFramedAsItIs) {
    View view = standing();
    view.camera.at.clear();
    view.camera.look_at.clear();
    const Snapshot bed = bed_of_waves(1);
    const Block block = framed_block(view, bed);
    const TileWarp copies = tile_warp_of(view, block, bed);
    ASSERT_TRUE(copies.varied());
    for (const double x : {-0.48, 0.48}) {
        for (const double y : {-0.48, 0.48}) {
            const glm::dvec2 position(x * block.width_x, y * block.width_y);
            EXPECT_EQ(copies.bed_position_at(position), position);
        }
    }
}

TEST(TileWarp, AreAlikeWhereTheyAreNotAskedForOrNotCopies) {
    View view = standing();
    Snapshot bed = bed_of_waves(1);
    EXPECT_TRUE(copies_of(view, bed).varied());
    view.look.far_copies = FarGround::alike;
    EXPECT_FALSE(copies_of(view, bed).varied());
    view = standing();
    view.look.ground = Ground::table;
    EXPECT_FALSE(copies_of(view, bed).varied());
    view = standing();
    bed.periodic = false;
    EXPECT_FALSE(copies_of(view, bed).varied()) << "it ends in a plain";
}

TEST(TileWarp, DifferTheLessTheMoreLandformsABedHas) {
    const double few = copies_of(standing(), bed_of_waves(1)).strength();
    const double more = copies_of(standing(), bed_of_waves(6)).strength();
    const double many = copies_of(standing(), bed_of_waves(12)).strength();
    EXPECT_EQ(few, 1.0);
    EXPECT_EQ(many, 0.6);
    EXPECT_LT(many, more);
    EXPECT_LT(more, few);
}

TEST(TileWarp, SlopesAreThoseOfTheHeights) {
    const View view = standing();
    const Snapshot bed = bed_of_waves(1);
    const Block block = framed_block(view, bed);
    const TileWarp copies = tile_warp_of(view, block, bed);
    const glm::dvec2 turn = 2.0 * std::numbers::pi / glm::dvec2(block.width_x, block.width_y);
    const auto on_bed = [&](const glm::dvec2& at) {
        return 0.03 * (std::sin(turn.x * at.x) + std::cos(turn.y * at.y));
    };
    const auto height = [&](const glm::dvec2& at) {
        return copies.raised(copies.at(at), on_bed(copies.bed_position_at(at)));
    };
    constexpr double step = 1e-6;
    int creases = 0;
    for (const glm::dvec2& position : far_places()) {
        const glm::dvec2 shown = copies.bed_position_at(position);
        const glm::dvec2 slope(0.03 * turn.x * std::cos(turn.x * shown.x),
                               -0.03 * turn.y * std::sin(turn.y * shown.y));
        const glm::dvec2 found = copies.slope(copies.at(position), slope, on_bed(shown));
        const glm::dvec2 expected(
            height(position + glm::dvec2(step, 0.0)) - height(position - glm::dvec2(step, 0.0)),
            height(position + glm::dvec2(0.0, step)) - height(position - glm::dvec2(0.0, step)));
        const double apart = glm::distance(found, expected / (2.0 * step));
        ASSERT_LT(apart, 1e-5) << position.x << ' ' << position.y;
        creases += apart > 1e-7 ? 1 : 0;
    }
    EXPECT_LT(creases, 3) << "where parabolas meet";
}

/// So that slip faces stay below the angle of repose, and what is hidden is found by the bed's
/// highest place.
TEST(TileWarp, AreNeitherHigherNorMuchSteeperThanTheBed) {
    for (const int along : {1, 12}) {
        const TileWarp copies = copies_of(standing(), bed_of_waves(along));
        double lowest = 1.0;
        int steeper = 0;
        for (const glm::dvec2& position : far_places()) {
            const WarpedGround copy = copies.at(position);
            ASSERT_LE(copy.height, 1.0);
            lowest = std::min(lowest, copy.height);
            const glm::dmat2 square = glm::transpose(copy.jacobian) * copy.jacobian;
            const double half = 0.5 * (square[0][0] + square[1][1]);
            const double det = glm::determinant(copy.jacobian);
            ASSERT_GT(det, 0.0) << "no place is shown twice, and none mirrored";
            const double off = std::sqrt(std::max(half * half - det * det, 0.0));
            const double growth = copy.height * std::sqrt(half + off);
            ASSERT_LT(growth, 1.05);
            steeper += growth > 1.0 ? 1 : 0;
            ASSERT_LT(1.0 / std::sqrt(half - off), tile_warp::largest_stretch);
            ASSERT_LT(std::abs(copy.offset.x), tile_warp::largest_offset);
            ASSERT_LT(std::abs(copy.offset.y), tile_warp::largest_offset);
        }
        EXPECT_LT(steeper, 40) << "of 4000";
        EXPECT_LT(lowest, along == 1 ? 0.5 : 0.7);
        EXPECT_GT(lowest, along == 1 ? 0.35 : 0.6);
    }
}

TEST(TileWarp, ShowEachPlaceOfARepetitionOnce) {
    const TileWarp copies = copies_of(standing(), bed_of_waves(1));
    for (const glm::dvec2& position : far_places()) {
        const glm::dvec2 found = copies.ground_position_of(copies.bed_position_at(position));
        ASSERT_LT(glm::distance(found, position), 1e-6) << position.x << ' ' << position.y;
    }
}

/// Neighbours a period apart, and rows of them.
TEST(TileWarp, StandInNoRows) {
    const TileWarp copies = copies_of(standing(), bed_of_waves(1));
    for (const glm::dvec2& way : {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 40.0 / 60.0)}) {
        double least = 1e9;
        double most = -1e9;
        double changed = 0.0;
        constexpr int count = 40;
        for (int i = 3; i < 3 + count; ++i) {
            const WarpedGround here = copies.at(1.0 * i * way);
            const WarpedGround next = copies.at((i + 1.0) * way);
            const glm::dvec2 across(way.y == 0.0 ? here.offset.y : here.offset.x, 0.0);
            least = std::min(least, across.x);
            most = std::max(most, across.x);
            changed += std::abs(next.height - here.height) / count;
        }
        EXPECT_GT(most - least, 0.4);
        EXPECT_GT(changed, 0.08);
    }
}

TEST(TileWarp, AreTheSameOnEveryTarget) {
    const std::string before = vectors::target();
    for (const glm::dvec2& position : {glm::dvec2(1.7, -0.4), glm::dvec2(-31.3, 12.9)}) {
        vectors::use_target(vectors::targets().front());
        const WarpedGround expected = tile_warp::warp_at(position, 0.83);
        for (const std::string& target : vectors::targets()) {
            vectors::use_target(target);
            const WarpedGround copy = tile_warp::warp_at(position, 0.83);
            EXPECT_EQ(copy.offset, expected.offset) << target;
            EXPECT_EQ(copy.jacobian, expected.jacobian) << target;
            EXPECT_EQ(copy.height, expected.height) << target;
            EXPECT_EQ(copy.height_gradient, expected.height_gradient) << target;
        }
    }
    vectors::use_target(before);
}

/// "1.5 above the bed there", of a far copy too; but a table's bed has none.
TEST(TileWarp, HeightsAboveTheBedAreAboveTheCopy) {
    View view = standing();
    view.camera.at = {20.0, 12.0, 1.5};
    view.camera.look_at = {20.0 + 2.6 * 120.0, 12.0, 1.5};
    const Snapshot bed = bed_of_waves(1);
    const Block block = framed_block(view, bed);
    const TileWarp copies = tile_warp_of(view, block, bed);
    const glm::dvec2 eye(*block.eye);
    ASSERT_TRUE(copies.varies_at(eye)) << "what it looks at is not";
    Camera sunk = camera_at_step(view, block, 0, 1);
    const double stands = sunk.eye.z;
    sunk.eye.z = -1.0;
    EXPECT_NEAR(above_ground(sunk, block, bed, copies).eye.z, stands, 1e-12);
    view.look.far_copies = FarGround::alike;
    EXPECT_GT(std::abs(framed_block(view, bed).eye->z - stands), 1e-4);
}

}  // namespace
}  // namespace fumon
