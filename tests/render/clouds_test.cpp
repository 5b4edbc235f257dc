#include "render/frame/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "support/drawn_picture.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

/// Sand to the horizon, over which the camera looks a little upward.
View view_of_clouds(Clouds clouds, int width = 320, int height = 180) {
    View view = small_view(width, height);
    view.look.ground = Ground::endless;
    view.camera.at = {10.0, 10.0, 8.0};
    view.camera.look_at = {50.0, 50.0, 22.0};
    view.camera.field_of_view = 50.0;
    view.sun.elevation = 50.0;
    view.air.clouds = clouds;
    return view;
}

View view_upward(double cover) {
    View view = view_of_clouds(Clouds::cumulus);
    view.camera.look_at = {11.0, 10.0, 12.0};
    view.camera.field_of_view = 90.0;
    view.air.cloud_cover = cover;
    view.air.cloud_seed = 4;
    return view;
}

/// How much of a picture is no blue sky.
double share_of_grey(const Image& image) {
    int grey = 0;
    const auto pixels = static_cast<int>(image.rgb.size() / 3);
    for (int i = 0; i < pixels; ++i) {
        const std::uint8_t* pixel = &image.rgb[3 * static_cast<std::size_t>(i)];
        if (pixel[2] < pixel[0] + 45) ++grey;
    }
    return static_cast<double>(grey) / pixels;
}

double brightness_of_ground(const Image& image) {
    double sum = 0.0;
    for (int x = 0; x < image.width; ++x) sum += image.row(image.height - 20)[3 * x + 1];
    return sum / image.width;
}

TEST(Clouds, StandInTheSkyBySeed) {
    const Snapshot bed = wavy_bed(60, 60);
    const Image clear = picture(view_of_clouds(Clouds::none), bed);
    for (const Clouds kind : {Clouds::cumulus, Clouds::cirrus}) {
        View view = view_of_clouds(kind);
        const Image seen = picture(view, bed);
        EXPECT_NE(seen, clear);
        EXPECT_EQ(picture(view, bed, 3), seen);
        view.air.cloud_seed = 2;
        EXPECT_NE(picture(view, bed), seen);
        view.air.cloud_seed = 1;
        view.air.cloud_wind = 200.0;
        // Cumulus does not know where the wind comes from until it drifts.
        EXPECT_EQ(picture(view, bed) == seen, kind == Clouds::cumulus);
    }
}

TEST(Clouds, CoverAsMuchAsIsAsked) {
    const Snapshot bed = wavy_bed(60, 60);
    double before = 0.0;
    for (const double cover : {0.0, 0.2, 0.6, 1.0}) {
        double seen = 0.0;
        for (const int seed : {1, 2}) {
            View view = view_upward(cover);
            view.air.cloud_seed = seed;
            seen += 0.5 * share_of_grey(picture(view, bed));
        }
        // The sides of clouds are seen, too.
        EXPECT_NEAR(seen, cover + 0.3 * cover * (1.0 - cover), 0.2) << cover;
        EXPECT_GE(seen, before) << cover;
        before = seen;
    }
}

/// Seen from below, away from their edges: light, of daylight that has passed through, and mottled.
TEST(Clouds, HaveLightMottledBases) {
    const Snapshot bed = wavy_bed(60, 60);
    View view = view_upward(0.95);
    view.camera.field_of_view = 40.0;
    double mean = 0.0;
    double rough = 0.0;
    for (const int seed : {1, 2, 3}) {
        view.air.cloud_seed = seed;
        const Image image = picture(view, bed);
        double sum = 0.0;
        double steps = 0.0;
        for (int y = 20; y < image.height - 20; ++y) {
            for (int x = 20; x < image.width - 20; ++x) {
                sum += image.row(y)[3 * x + 1];
                steps += std::abs(image.row(y)[3 * x + 1] - image.row(y)[3 * (x + 4) + 1]);
            }
        }
        const double count = (image.height - 40.0) * (image.width - 40.0);
        mean += sum / count / 3.0;
        rough += steps / count / 3.0;
    }
    EXPECT_GT(mean, 116.0);
    EXPECT_LT(mean, 200.0);
    EXPECT_GT(rough, 4.0);
}

/// Edges of clouds around the sun stand out from the sky as much as fronts that it lights.
TEST(Clouds, HaveBrightEdgesTowardsTheSun) {
    const Snapshot bed = wavy_bed(60, 60);
    const auto outshine = [&](double azimuth) {
        View view = view_of_clouds(Clouds::cumulus);
        view.sun.elevation = 28.0;
        view.sun.azimuth = azimuth;
        view.look.exposure = -3.0;
        view.air.aerosol = Aerosol::thin;  // the sky around the sun is dark beside clouds
        const Image image = picture(view, bed);
        view.air.clouds = Clouds::none;
        const Image clear = picture(view, bed);
        std::vector<int> more;
        for (int y = 0; y < image.height / 2; ++y)
            for (int x = 0; x < image.width; ++x)
                more.push_back(image.row(y)[3 * x + 1] - clear.row(y)[3 * x + 1]);
        std::ranges::sort(more);
        return more[more.size() * 98 / 100];
    };
    // The camera looks north-east.
    EXPECT_GT(outshine(45.0), outshine(225.0) - 15);
}

TEST(Clouds, ThrowShadowsOnEndlessGround) {
    const Snapshot bed = wavy_bed(60, 60);
    View view = view_of_clouds(Clouds::cumulus);
    const double clear = brightness_of_ground(picture(view_of_clouds(Clouds::none), bed));
    view.air.cloud_cover = 0.0;
    EXPECT_NEAR(brightness_of_ground(picture(view, bed)), clear, 2.0);
    view.air.cloud_cover = 1.0;
    EXPECT_LT(brightness_of_ground(picture(view, bed)), 0.85 * clear);
}

TEST(Clouds, DriftOverTheRun) {
    const Snapshot first = wavy_bed(60, 60);
    Snapshot later = first;
    later.step = 50;
    for (const Clouds kind : {Clouds::cumulus, Clouds::cirrus}) {
        View view = view_of_clouds(kind);
        EXPECT_EQ(pictures(view, {first, later}).back(), picture(view, later));
        view.air.cloud_drift = 3.0;
        const std::vector<Image> frames = pictures(view, {first, later, first});
        EXPECT_NE(frames[1], frames[0]);
        EXPECT_EQ(frames[2], frames[0]);
    }
    AirSettings air;
    air.cloud_drift = 4.0;
    EXPECT_NEAR(cloud_shift(air, 0.5).x, 2.0F, 1e-6F) << "a wind from the west blows east";
    EXPECT_NEAR(cloud_shift(air, 0.5).y, 0.0F, 1e-6F);
}

/// They are fixed in the world: what a camera sees after going as far as they drift is the same
/// sky.
TEST(Clouds, StayWhereTheyAreWhenTheCameraMoves) {
    Snapshot first = wavy_bed(60, 60);
    first.periodic = true;
    View view = view_of_clouds(Clouds::cumulus);
    view.look.grain = 0.0;
    view.look.ripples = 0.0;
    const Image standing = picture(view, first);
    View moved = view;
    moved.camera.at[0] += 60.0;  // a period of the bed: a kilometre without metres
    moved.camera.look_at[0] += 60.0;
    EXPECT_NE(picture(moved, first), standing);
    Snapshot last = first;
    last.step = 100;
    moved.air.cloud_drift = 1.0;
    const Image along = pictures(moved, {first, last}).back();
    int off = 0;
    for (int y = 0; y < 60; ++y) {
        for (int i = 0; i < 3 * along.width; ++i)
            off = std::max(off, std::abs(along.row(y)[i] - standing.row(y)[i]));
    }
    EXPECT_LE(off, 3);
}

TEST(Clouds, LeaveNoSeamsBetweenTiles) {
    const Snapshot bed = wavy_bed(60, 60);
    for (const Clouds kind : {Clouds::cumulus, Clouds::cirrus}) {
        const View view = view_of_clouds(kind, 397, 260);
        const Image whole = picture(view, bed);
        const Image tiled = picture(view, bed, 2, gl::Backend::automatic, {256});
        int sky_off = 0;
        for (int y = 0; y < 100; ++y) {
            for (int i = 0; i < 3 * whole.width; ++i)
                sky_off = std::max(sky_off, std::abs(whole.row(y)[i] - tiled.row(y)[i]));
        }
        EXPECT_LE(sky_off, 1);
    }
}

TEST(Clouds, AreNoPartOfFiguresAndOtherSkies) {
    const Snapshot bed = wavy_bed(60, 60);
    View view = small_view();
    view.look.mode = ViewMode::figure;
    const Image figure = picture(view, bed);
    view.air.clouds = Clouds::cumulus;
    EXPECT_EQ(picture(view, bed), figure);
    view.look.mode = ViewMode::scenic;
    view.look.sky = SkyModel::overcast;
    const Image overcast = picture(view, bed);
    view.air.clouds = Clouds::none;
    EXPECT_EQ(picture(view, bed), overcast);
    // A block before the sky of an atmosphere has them.
    view.look.sky = SkyModel::atmosphere;
    view.camera.elevation = 3.0;
    const Image clear = picture(view, bed);
    view.air.clouds = Clouds::cumulus;
    EXPECT_NE(picture(view, bed), clear);
    view.look.background = Background::transparent;
    const Image alone = picture(view, bed);
    view.air.clouds = Clouds::none;
    view.look.sky = SkyModel::atmosphere;
    EXPECT_EQ(picture(view, bed).rgb.size(), alone.rgb.size());
}

}  // namespace
}  // namespace fumon
