#include "render/view/far_copies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "render/view/far_copies_vectors.h"
#include "render/view/far_copies_waves.h"
#include "render/view/framing.h"
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

FarCopies copies_of(const View& view, const Snapshot& bed) {
    return far_copies_of(view, framed_block(view, bed), bed);
}

/// Places all around, the nearest ones a period away.
std::vector<glm::dvec2> far_places() {
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 4000; ++i) {
        const double turn = 2.399963 * i;
        places.push_back((1.0 + 0.01 * i) * glm::dvec2(std::cos(turn), std::sin(turn)));
    }
    return places;
}

TEST(FarCopies, LeaveWhatTheCameraSeesAsItIs) {
    const View view = standing();
    const Snapshot bed = bed_of_waves(1);
    const Block block = framed_block(view, bed);
    const FarCopies copies = far_copies_of(view, block, bed);
    ASSERT_TRUE(copies.varied());
    const glm::dvec2 middle = 0.5 * (glm::dvec2(*block.eye) + glm::dvec2(*block.look_at));
    const glm::dvec2 extent(block.width_x, block.width_y);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec2 way = 0.003 * i * glm::dvec2(std::cos(1.0 * i), std::sin(1.0 * i));
        const GroundCopy copy = copies.at(middle + way * extent);
        ASSERT_EQ(copy.aside, glm::dvec2(0.0));
        ASSERT_EQ(copy.height, 1.0);
    }
    EXPECT_NE(copies.at(middle + extent).aside, glm::dvec2(0.0));
    for (const std::vector<double>& at : {view.camera.at, view.camera.look_at}) {
        const glm::dvec2 place = glm::dvec2(at[0], at[1]) / block.side - 0.5 * extent;
        EXPECT_EQ(copies.shown_at(place), place);
    }
}

/// A bed that is looked at as a whole, from farther away than it is wide.
TEST(FarCopies, LeaveABlockThatIsFramedAsItIs) {
    View view = standing();
    view.camera.at.clear();
    view.camera.look_at.clear();
    const Snapshot bed = bed_of_waves(1);
    const Block block = framed_block(view, bed);
    const FarCopies copies = far_copies_of(view, block, bed);
    ASSERT_TRUE(copies.varied());
    for (const double x : {-0.48, 0.48}) {
        for (const double y : {-0.48, 0.48}) {
            const glm::dvec2 place(x * block.width_x, y * block.width_y);
            EXPECT_EQ(copies.shown_at(place), place);
        }
    }
}

TEST(FarCopies, AreAlikeWhereTheyAreNotAskedForOrNotCopies) {
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

TEST(FarCopies, DifferTheLessTheMoreLandformsABedHas) {
    const double few = copies_of(standing(), bed_of_waves(1)).strength();
    const double more = copies_of(standing(), bed_of_waves(6)).strength();
    const double many = copies_of(standing(), bed_of_waves(12)).strength();
    EXPECT_EQ(few, 1.0);
    EXPECT_EQ(many, 0.6);
    EXPECT_LT(many, more);
    EXPECT_LT(more, few);
}

TEST(FarCopies, SlopesAreThoseOfTheHeights) {
    const View view = standing();
    const Snapshot bed = bed_of_waves(1);
    const Block block = framed_block(view, bed);
    const FarCopies copies = far_copies_of(view, block, bed);
    const glm::dvec2 turn = 2.0 * std::numbers::pi / glm::dvec2(block.width_x, block.width_y);
    const auto on_bed = [&](const glm::dvec2& at) {
        return 0.03 * (std::sin(turn.x * at.x) + std::cos(turn.y * at.y));
    };
    const auto height = [&](const glm::dvec2& at) {
        return copies.raised(copies.at(at), on_bed(copies.shown_at(at)));
    };
    constexpr double step = 1e-6;
    int creases = 0;
    for (const glm::dvec2& place : far_places()) {
        const glm::dvec2 shown = copies.shown_at(place);
        const glm::dvec2 slope(0.03 * turn.x * std::cos(turn.x * shown.x),
                               -0.03 * turn.y * std::sin(turn.y * shown.y));
        const glm::dvec2 found = copies.slope(copies.at(place), slope, on_bed(shown));
        const glm::dvec2 expected(
            height(place + glm::dvec2(step, 0.0)) - height(place - glm::dvec2(step, 0.0)),
            height(place + glm::dvec2(0.0, step)) - height(place - glm::dvec2(0.0, step)));
        const double apart = glm::distance(found, expected / (2.0 * step));
        ASSERT_LT(apart, 1e-5) << place.x << ' ' << place.y;
        creases += apart > 1e-7 ? 1 : 0;
    }
    EXPECT_LT(creases, 3) << "where parabolas meet";
}

/// So that slip faces stay below the angle of repose, and what is hidden is found by the bed's
/// highest place.
TEST(FarCopies, AreNeitherHigherNorMuchSteeperThanTheBed) {
    for (const int along : {1, 12}) {
        const FarCopies copies = copies_of(standing(), bed_of_waves(along));
        double lowest = 1.0;
        int steeper = 0;
        for (const glm::dvec2& place : far_places()) {
            const GroundCopy copy = copies.at(place);
            ASSERT_LE(copy.height, 1.0);
            lowest = std::min(lowest, copy.height);
            const glm::dmat2 square = glm::transpose(copy.way) * copy.way;
            const double half = 0.5 * (square[0][0] + square[1][1]);
            const double det = glm::determinant(copy.way);
            ASSERT_GT(det, 0.0) << "no place is shown twice, and none mirrored";
            const double off = std::sqrt(std::max(half * half - det * det, 0.0));
            const double growth = copy.height * std::sqrt(half + off);
            ASSERT_LT(growth, 1.05);
            steeper += growth > 1.0 ? 1 : 0;
            ASSERT_LT(1.0 / std::sqrt(half - off), far_copies::widest);
            ASSERT_LT(std::abs(copy.aside.x), far_copies::farthest_aside);
            ASSERT_LT(std::abs(copy.aside.y), far_copies::farthest_aside);
        }
        EXPECT_LT(steeper, 40) << "of 4000";
        EXPECT_LT(lowest, along == 1 ? 0.5 : 0.7);
        EXPECT_GT(lowest, along == 1 ? 0.35 : 0.6);
    }
}

TEST(FarCopies, ShowEachPlaceOfARepetitionOnce) {
    const FarCopies copies = copies_of(standing(), bed_of_waves(1));
    for (const glm::dvec2& place : far_places()) {
        const glm::dvec2 found = copies.place_of(copies.shown_at(place));
        ASSERT_LT(glm::distance(found, place), 1e-6) << place.x << ' ' << place.y;
    }
}

/// Neighbours a period apart, and rows of them.
TEST(FarCopies, StandInNoRows) {
    const FarCopies copies = copies_of(standing(), bed_of_waves(1));
    for (const glm::dvec2& way : {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 40.0 / 60.0)}) {
        double least = 1e9;
        double most = -1e9;
        double changed = 0.0;
        constexpr int count = 40;
        for (int i = 3; i < 3 + count; ++i) {
            const GroundCopy here = copies.at(1.0 * i * way);
            const GroundCopy next = copies.at((i + 1.0) * way);
            const glm::dvec2 across(way.y == 0.0 ? here.aside.y : here.aside.x, 0.0);
            least = std::min(least, across.x);
            most = std::max(most, across.x);
            changed += std::abs(next.height - here.height) / count;
        }
        EXPECT_GT(most - least, 0.4);
        EXPECT_GT(changed, 0.08);
    }
}

TEST(FarCopies, AreTheSameOnEveryTarget) {
    const std::string before = vectors::target();
    for (const glm::dvec2& place : {glm::dvec2(1.7, -0.4), glm::dvec2(-31.3, 12.9)}) {
        vectors::use_target(vectors::targets().front());
        const GroundCopy expected = far_copies::copy_at(place, 0.83);
        for (const std::string& target : vectors::targets()) {
            vectors::use_target(target);
            const GroundCopy copy = far_copies::copy_at(place, 0.83);
            EXPECT_EQ(copy.aside, expected.aside) << target;
            EXPECT_EQ(copy.way, expected.way) << target;
            EXPECT_EQ(copy.height, expected.height) << target;
            EXPECT_EQ(copy.growth, expected.growth) << target;
        }
    }
    vectors::use_target(before);
}

/// "1.5 above the bed there", of a far copy too; but a table's bed has none.
TEST(FarCopies, HeightsAboveTheBedAreAboveTheCopy) {
    View view = standing();
    view.camera.at = {20.0, 12.0, 1.5};
    view.camera.look_at = {20.0 + 2.6 * 120.0, 12.0, 1.5};
    const Snapshot bed = bed_of_waves(1);
    const Block block = framed_block(view, bed);
    const FarCopies copies = far_copies_of(view, block, bed);
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
