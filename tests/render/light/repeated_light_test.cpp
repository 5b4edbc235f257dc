#include "render/light/repeated_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/worker_pool.h"
#include "render/light/light.h"
#include "render/view/framing.h"
#include "support/drawn_picture.h"

namespace fumon {
namespace {

/// Ridges of sites 24 apart that rise by a tenth over 20 of them and fall over three.
Snapshot ridges_with_slip_faces() {
    Snapshot snapshot;
    snapshot.bed = Grid(48, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 48; ++x) {
            const int along = x % 24;
            snapshot.bed(x, y) = along <= 20 ? 0.1 * along : 2.0 - 0.65 * (along - 20);
        }
    }
    return snapshot;
}

TEST(RepeatedLight, SandLiesAsItSlidOnSlipFacesAndACellAroundThem) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.exaggeration = {"", 1.0};
    const Snapshot bed = ridges_with_slip_faces();
    WorkerPool pool(1);
    constexpr int refinement = 3;
    const RepeatedLight light = repeated_light(bed, framed_block(view, bed), refinement, {},
                                               sun_direction(view.sun), {1.0, 0.0}, pool);
    ASSERT_EQ(light.surface.size(), 2 * light.z.size());
    const auto slid = [&](int site) {
        const int middle = refinement * site + refinement / 2;
        return int{light.surface[2 * static_cast<std::size_t>(middle) + 1]};
    };
    EXPECT_GE(slid(22), 250);
    EXPECT_GE(slid(22 + 24), 250);
    EXPECT_GE(slid(20), 250) << "the brink";
    for (const int site : {4, 10, 16, 28, 34, 40}) EXPECT_EQ(slid(site), 0) << site;
}

/// The sand that slid at the middle of a site of a row, 0 … 255.
int slid_at(const Snapshot& bed, double exaggeration, int site) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.exaggeration = {"", exaggeration};
    WorkerPool pool(1);
    const RepeatedLight light = repeated_light(bed, framed_block(view, bed), 1, {},
                                               sun_direction(view.sun), {1.0, 0.0}, pool);
    return light.surface[2 * static_cast<std::size_t>(site) + 1];
}

Snapshot against_the_wind(const Snapshot& bed) {
    Snapshot turned = bed;
    for (int y = 0; y < bed.bed.ny(); ++y)
        for (int x = 0; x < bed.bed.nx(); ++x) turned.bed(x, y) = bed.bed(bed.bed.nx() - 1 - x, y);
    return turned;
}

TEST(RepeatedLight, SandSlidInTheLeeOfAnyWindAlone) {
    const Snapshot bed = ridges_with_slip_faces();
    Snapshot turned = against_the_wind(bed);
    EXPECT_GE(slid_at(bed, 1.0, 22), 250);
    EXPECT_EQ(slid_at(turned, 1.0, 47 - 22), 0) << "a steep stoss side";
    turned.winds = {{1.0, 0.0, 1.0}, {-1.0, 0.0, 0.2}};
    EXPECT_GE(slid_at(turned, 1.0, 47 - 22), 250) << "a second wind";
    turned.winds.clear();
    turned.scale.in_metres = true;
    EXPECT_GE(slid_at(turned, 1.0, 47 - 22), 250) << "at the angle of repose";
}

TEST(RepeatedLight, TheTrueSlopeTellsWhereSandSlid) {
    Snapshot bed = ridges_with_slip_faces();
    EXPECT_GE(slid_at(bed, 0.5, 22), 250);
    for (double& height : bed.bed.values()) height *= 0.4;
    EXPECT_EQ(slid_at(bed, 3.0, 22), 0);
}

/// A table of rock in metres, 12 m high, whose wall faces south and runs oblique to the cells by 20
/// degrees through the middle of the bed.
Snapshot table_of_rock() {
    Snapshot snapshot;
    snapshot.bed = Grid(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double across = 0.940 * (y - 32) - 0.342 * (x - 32);
            snapshot.bed(x, y) =
                across > 0.3 && across < 20.0 && std::abs(x - 32) < 26 ? 12.0 : 0.0;
        }
    }
    snapshot.scale = {1.0, 1.0, 1.0, true, {}};
    snapshot.periodic = true;
    return snapshot;
}

// Cells at the rim see all of the sun, those below the rim nothing.
TEST(RepeatedLight, AWallThatTurnsAwayFromTheSunIsInShadeFromALineOn) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.exaggeration = {"", 1.0};
    view.sun.azimuth = 340.0;
    view.sun.elevation = 20.0;
    const Snapshot bed = table_of_rock();
    WorkerPool pool(1);
    constexpr int refinement = 3;
    const RepeatedLight light = repeated_light(bed, framed_block(view, bed), refinement, {},
                                               sun_direction(view.sun), {1.0, 0.0}, pool);
    EXPECT_TRUE(light.walls);
    const auto share = [&](double x, double y) {  // between fine cells; metres
        const double u = refinement * (x + 0.5) - 0.5;
        const double v = refinement * (y + 0.5) - 0.5;
        const auto of = [&](int column, int row) {
            const auto cell = static_cast<std::size_t>(row * light.z.nx() + column);
            const double texel = light.texels[4 * cell + 2] / 65535.0;
            return sun_bounds.lowest + texel * (sun_bounds.highest - sun_bounds.lowest);
        };
        const int west = static_cast<int>(u);
        const int south = static_cast<int>(v);
        const double low = of(west, south) + (u - west) * (of(west + 1, south) - of(west, south));
        const double high =
            of(west, south + 1) + (u - west) * (of(west + 1, south + 1) - of(west, south + 1));
        return low + (v - south) * (high - low);
    };
    double least = 1e6;
    double most = -1e6;
    for (int step = -40; step < 40; ++step) {
        const double along = 0.2 * step;
        double across = 4.0;
        while (across > -4.0 && share(32.0 + 0.940 * along - 0.342 * across,
                                      32.0 + 0.342 * along + 0.940 * across) > 0.5)
            across -= 0.02;
        least = std::min(least, across);
        most = std::max(most, across);
    }
    EXPECT_GT(least, -1.0);
    EXPECT_LT(most, 1.5);
    EXPECT_LT(most - least, 0.2);
}

}  // namespace
}  // namespace fumon
