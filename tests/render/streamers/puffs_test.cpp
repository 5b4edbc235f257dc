#include "render/streamers/puffs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "render/view/block.h"
#include "support/slip_face.h"

namespace fumon {
namespace {

const SunDirection noon{0.0F, -1.0F, 2.0F, 2.2F};

View asking(double strength = 1.0) {
    View view;
    view.look.ground = Ground::endless;
    view.streamers.strength = strength;
    return view;
}

/// Of the ridge of slip_face(), with winds that blow toward +x or another way.
BlownSand sand_of(const Snapshot& bed) {
    return blown_sand(bed, asking(), frame_block(bed, 1.0), noon);
}

/// 5 m over the ridge, looking at its crest from the south; block lengths are 128 m.
Camera beside() {
    Camera camera;
    camera.right = {1.0, 0.0, 0.0};
    camera.forward = {0.0, 1.0, 0.0};
    camera.up = {0.0, 0.0, 1.0};
    camera.eye = {0.0, -0.35, 0.06};
    camera.half = {0.8, 0.45};
    return camera;
}

std::vector<Puff> seen(const BlownSand& sand, double strength, double gone = 0.0) {
    const PuffGround ground{glm::dvec2(-0.5, -0.25), glm::dvec2(1.0, 0.5), 0.0, {}};
    return visible_puffs(sand, strength, gone, ground, beside(), 0.9 / 1080.0);
}

/// Optical depths times areas.
double held(const std::vector<Puff>& puffs) {
    double sum = 0.0;
    for (const Puff& puff : puffs)
        sum += static_cast<double>(puff.middle.w * puff.along.w * puff.across.x * puff.across.y);
    return sum;
}

/// Without wisps, which are everywhere on open ground.
BlownSand without_wisps(BlownSand sand) {
    std::ranges::fill(sand.open.values(), 0.0F);
    return sand;
}

TEST(BlownSand, LeavesOverTheBrinkAlone) {
    const BlownSand sand = sand_of(slip_face(2.0));
    ASSERT_FALSE(sand.brinks.empty());
    double leaving = 0.0;
    for (const Brink& brink : sand.brinks) {
        EXPECT_NEAR(128.0 * brink.position.x, 61.0, 1.6);
        leaving += brink.flux;
    }
    EXPECT_NEAR(leaving / 64.0, 2.0, 0.1);  // all of the flux, of each row
}

TEST(BlownSand, IsNoneWithoutBrinksOrFlux) {
    Snapshot level = slip_face(2.0);
    level.bed = Grid(128, 64, 1.0);
    EXPECT_TRUE(sand_of(level).brinks.empty());
    EXPECT_TRUE(sand_of(slip_face(0.0)).brinks.empty());
    Snapshot turned = slip_face(2.0);
    turned.winds = {{-1.0, 0.0, 1.0}};  // down the gentle side
    EXPECT_TRUE(sand_of(turned).brinks.empty());
}

TEST(BlownSand, FollowsTheWindOfTheStep) {
    Snapshot bed = slip_face(2.0);
    bed.winds = {{1.0, 0.0, 1.0}, {0.0, 1.0, 1.0}};
    bed.numbers = {{"wind_from", "degrees", 270.0}};
    const HorizontalDirection way = sand_of(bed).way;
    EXPECT_NEAR(way.x, 1.0, 1e-12);
    EXPECT_NEAR(way.y, 0.0, 1e-12);
}

TEST(BlownSand, ShadowOfTheCrestDarkensPlumes) {
    const Snapshot bed = slip_face(2.0);
    const SunDirection low_in_the_west{-1.0F, 0.0F, 0.05F, 0.08F};
    const BlownSand sand = blown_sand(bed, asking(), frame_block(bed, 1.0), low_in_the_west);
    for (const Brink& brink : sand.brinks) {
        EXPECT_GT(brink.sun.x, 0.95F);
        EXPECT_LT(brink.sun.z, 0.3F);
    }
}

TEST(Puffs, MoreFluxIsMoreSand) {
    const double once = held(seen(without_wisps(sand_of(slip_face(1.0))), 1.0));
    EXPECT_GT(once, 0.0);
    EXPECT_NEAR(held(seen(without_wisps(sand_of(slip_face(2.0))), 1.0)) / once, 2.0, 1e-4);
    EXPECT_NEAR(held(seen(without_wisps(sand_of(slip_face(1.0))), 0.5)) / once, 0.5, 1e-4);
    EXPECT_EQ(seen(sand_of(slip_face(0.0)), 1.0).size(), 0U);
}

TEST(Puffs, WispsAreWhereTheWindReachesTheGround) {
    BlownSand sand = sand_of(slip_face(2.0));
    sand.brinks.clear();
    const std::vector<Puff> wisps = seen(sand, 1.0);
    ASSERT_GT(wisps.size(), 100U);
    for (const Puff& wisp : wisps) {
        double x = 128.0 * (static_cast<double>(wisp.middle.x) + beside().eye.x + 0.5);
        x -= 128.0 * std::floor(x / 128.0);
        EXPECT_FALSE(x > 64.0 && x < 69.0) << x;  // the slip face
    }
}

TEST(Puffs, PlumesLieDownwindOfTheBrink) {
    for (const Puff& puff : seen(without_wisps(sand_of(slip_face(1.0))), 1.0)) {
        const double x = 128.0 * (static_cast<double>(puff.middle.x) + 0.5);
        const double from_brink = x - 61.0 - 128.0 * std::floor((x - 60.0) / 128.0);
        EXPECT_GT(from_brink, -2.0);
        EXPECT_LT(from_brink, 16.0);  // 12 m, from 6 m of relief
    }
}

/// Each copy of a bed has gusts of its own, which go on over its border.
TEST(Puffs, GustsGoOverCopiesAsOverOneGround) {
    const BlownSand sand = without_wisps(sand_of(slip_face(1.0)));
    constexpr int rows = 16;
    std::vector<double> here(rows);
    std::vector<double> beyond(rows);
    for (const Puff& puff : seen(sand, 1.0)) {
        const double y = static_cast<double>(puff.middle.y) + beside().eye.y + 0.25;
        const double x = static_cast<double>(puff.middle.x);
        const int row = static_cast<int>(std::floor(y / 0.5 * rows));
        if (std::abs(x) > 0.3 || row < rows / 2 || row >= rows * 2) continue;
        if (row >= rows && row < rows * 3 / 2) continue;
        (row < rows ? here : beyond)[static_cast<std::size_t>(row % rows)] += held({puff});
    }
    double off = 0.0;
    double sum = 0.0;
    for (std::size_t row = rows / 2; row < rows; ++row) {
        off += std::abs(here[row] - beyond[row]);
        sum += here[row] + beyond[row];
    }
    EXPECT_GT(sum, 0.0);
    EXPECT_GT(off, 0.1 * sum);
}

TEST(Puffs, GoOnWithTheWind) {
    BlownSand sand = without_wisps(sand_of(slip_face(1.0)));
    sand.repeats = false;
    sand.brinks.resize(16);
    const double way = 0.4 / 128.0;
    const std::vector<Puff> before = seen(sand, 1.0);
    const std::vector<Puff> after = seen(sand, 1.0, way);
    std::size_t moved = 0;
    for (const Puff& puff : before) {
        moved += std::ranges::any_of(after, [&](const Puff& other) {
            const glm::vec3 on = glm::vec3(other.middle) - glm::vec3(puff.middle);
            return std::abs(static_cast<double>(on.x) - way) < 0.02 * way &&
                   std::abs(on.y) < 0.0002F && std::abs(on.z) < 0.0012F;
        });
    }
    ASSERT_GT(before.size(), 50U);
    EXPECT_GT(moved, before.size() * 9 / 10);
}

TEST(Streamers, AreRefusedWithoutWind) {
    Snapshot bed = slip_face(1.0);
    const auto fault = [&](const View& view) {
        try {
            check_streamers(view, bed);
        } catch (const KeyError& error) {
            return error.key() + ": " + error.what();
        }
        return std::string();
    };
    EXPECT_EQ(fault(asking()), "");
    bed.saltation_flux = {};
    EXPECT_EQ(fault(asking(0.0)), "");
    EXPECT_NE(
        fault(asking()).find("streamers.strength: streamers show sand driven by a model's wind"),
        std::string::npos);
}

}  // namespace
}  // namespace fumon
