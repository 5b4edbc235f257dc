#include "render/view/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/repeated_dunes.h"

namespace fumon {
namespace {

constexpr Framing all[] = {Framing::overview, Framing::low, Framing::along_crest,
                           Framing::slip_face, Framing::aerial};

TEST(Framing, KeepsOffTheLatticesDirections) {
    for (const Framing framing : all) {
        for (int wind = 0; wind < 360; wind += 15) {
            Snapshot bed = repeated_dunes(60, 40);
            const double turn = wind * M_PI / 180.0;
            bed.winds = {{std::sin(turn), std::cos(turn), 1.0}};
            View view;
            view.camera.framing = framing;
            const Block block = framed_block(view, bed);
            const Camera camera = camera_at_step(view, block, 0, 1);
            const double heading = std::atan2(camera.forward.x, camera.forward.y) * 180.0 / M_PI;
            for (const double lattice : {0.0, 90.0, std::atan2(60.0, 40.0) * 180.0 / M_PI,
                                         -std::atan2(60.0, 40.0) * 180.0 / M_PI}) {
                const double off = std::abs(std::remainder(heading - lattice, 180.0));
                EXPECT_GE(off, 9.99) << static_cast<int>(framing) << " wind " << wind;
            }
        }
    }
}

TEST(Framing, StandsOverTheGroundAndSeesTheHighestCrest) {
    const Snapshot bed = repeated_dunes(90, 120);
    for (const Framing framing : all) {
        View view;
        view.camera.framing = framing;
        const Block block = framed_block(view, bed);
        const Camera camera = above_ground(camera_at_step(view, block, 0, 1), block, bed);
        ASSERT_TRUE(block.eye);
        EXPECT_LT(glm::length(camera.eye - *block.eye), 1e-12) << "already above";
        const glm::dvec2 crest = project(camera, *block.look_at);
        EXPECT_NEAR(crest.x, 0.0, 1e-9);
        EXPECT_NEAR(crest.y, 0.0, 1e-9);
        EXPECT_LT(camera.forward.z, 0.2) << "looks at the bed";
    }
}

TEST(Framing, StandsBeforeABedAroundWhichLandGoesOn) {
    Snapshot bed = repeated_dunes(60, 40);
    bed.periodic = false;
    for (const double elevation : {3.0, 12.0, 32.0}) {
        View view;
        view.look.ground = Ground::endless;
        view.camera.elevation = elevation;
        const auto most_seen = [&](const Snapshot& first) {
            const Block block = framed_block(view, first);
            const Camera camera = camera_at_step(view, block, 0, 1);
            double below = 1.0;
            for (const glm::dvec2& corner : block.outline)
                below = std::min(below, project(camera, glm::dvec3(corner, block.surface)).y);
            return std::pair(below, glm::length(camera.eye));
        };
        const auto [lowest, distance] = most_seen(bed);
        EXPECT_LT(lowest, -0.999) << "no invented land before it, at " << elevation;
        view.camera.distance.word = "fit";
        const auto [fitted, farther] = most_seen(bed);
        EXPECT_GT(fitted, -0.999);
        EXPECT_GT(farther, 1.1 * distance);
        view.camera.distance.word = "auto";
        bed.periodic = true;
        EXPECT_EQ(most_seen(bed).second, farther) << "what repeats has no edge";
        bed.periodic = false;
    }
}

TEST(Framing, LeavesOutWhatIsNoGround) {
    Snapshot bed = repeated_dunes(60, 50);
    bed.nodata = Mask(60, 50);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 60; ++x) bed.nodata(x, y) = 1;
    View view;
    view.camera.framing = Framing::low;
    const Block block = framed_block(view, bed);
    for (int x = 0; x < 60; ++x) bed.bed(x, 3) = x % 2 == 0 ? -1e3 : 1e3;
    const Block same = framed_block(view, bed);
    EXPECT_EQ(*block.eye, *same.eye);
    EXPECT_EQ(*block.look_at, *same.look_at);
}

TEST(Framing, ACameraOverNoDataStandsOnTheNearestGround) {
    Snapshot bed = repeated_dunes(20, 12);
    bed.periodic = false;
    bed.nodata = Mask(20, 12);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 20; ++x) {
            bed.bed(x, y) += 1700.0;
            if (x >= 5) continue;
            bed.nodata(x, y) = 1;
            bed.bed(x, y) = 0.0;
        }
    }
    View view;
    view.camera.at = {2.5 * bed.scale.dx, 6.5 * bed.scale.dy, 3.0};
    const Block block = framed_block(view, bed);
    ASSERT_TRUE(block.eye);
    EXPECT_NEAR(block.eye->z, block.z(bed.bed(5, 6) + 3.0 / bed.scale.height_unit), 1e-9);
}

TEST(Framing, ACameraRisesWithTheGround) {
    Snapshot bed = repeated_dunes(50, 50);
    View view;
    view.camera.at = {20.0, 30.0, 2.0};
    const Block block = framed_block(view, bed);
    const Camera before = above_ground(camera_at_step(view, block, 0, 1), block, bed);
    EXPECT_LT(glm::length(before.eye - *block.eye), 1e-12);
    for (double& height : bed.bed.values()) height += 5.0;
    const Camera after = above_ground(camera_at_step(view, block, 0, 1), block, bed);
    EXPECT_NEAR(after.eye.z - before.eye.z, 5.0 * block.height_scale, 1e-12);
    for (double& height : bed.bed.values()) height -= 9.0;
    EXPECT_EQ(above_ground(camera_at_step(view, block, 0, 1), block, bed).eye, *block.eye)
        << "but does not sink with it";
}

}  // namespace
}  // namespace fumon
