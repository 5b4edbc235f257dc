// Rings of drops in whole pictures of water.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "support/drawn_picture.h"
#include "support/water_views.h"

namespace fumon {
namespace {

/// A pond at a time, s, in a rain of so many millimetres an hour that ends at 1000 s.
Snapshot pond_in_rain(double rate, double time = 600.0) {
    Snapshot pond = under_water(flat_bed(40, 40), 0.6, 0.0);
    pond.time = time;
    pond.time_unit = "s";
    pond.rain = [rate](double from, double until) {
        const double seconds = std::min(until, 1000.0) - std::min(from, 1000.0);
        return Grid(1, 1, seconds * rate / 3.6e6);
    };
    return pond;
}

/// Over the water, from a height in metres.
View view_from(double height) {
    View view = map_view(240);
    view.camera.projection = Projection::perspective;
    view.camera.at = {20, 20.0 - height, 1.6 + height};
    view.camera.look_at = {20, 20, 1.6};
    view.look.turbidity = 0.85;
    return view;
}

/// The mean square of the differences of neighbouring pixels.
double unevenness(const Image& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 1; x < image.width; ++x) {
            const std::uint8_t* pixel = image.row(y) + 3 * static_cast<std::size_t>(x);
            const double difference = int{pixel[1]} - int{pixel[-2]};
            sum += difference * difference;
        }
    }
    return sum / (image.height * (image.width - 1));
}

TEST(RainOnWater, RingsAreSeenFromNearWhileItRains) {
    const View near = view_from(1.5);
    const Image calm = picture(near, pond_in_rain(0.0));
    EXPECT_GT(unevenness(picture(near, pond_in_rain(60.0))), 1.5 * unevenness(calm));
    Snapshot unknown = pond_in_rain(60.0);
    unknown.rain = nullptr;
    EXPECT_EQ(picture(near, unknown).rgb, calm.rgb);
}

TEST(RainOnWater, NoneASecondAfterItsEnd) {
    const View near = view_from(1.5);
    EXPECT_EQ(picture(near, pond_in_rain(60.0, 1001.0)).rgb,
              picture(near, pond_in_rain(0.0, 1001.0)).rgb);
    EXPECT_NE(picture(near, pond_in_rain(60.0, 1000.0)).rgb,
              picture(near, pond_in_rain(0.0, 1000.0)).rgb);
}

TEST(RainOnWater, FarWaterDoesNotSparkle) {
    const auto change = [](const View& view) {
        const Image before = picture(view, pond_in_rain(60.0));
        const Image after = picture(view, pond_in_rain(60.0, 607.0));
        double sum = 0.0;
        for (std::size_t i = 0; i < before.rgb.size(); ++i)
            sum += std::abs(int{before.rgb[i]} - int{after.rgb[i]});
        return sum / static_cast<double>(before.rgb.size());
    };
    View far = view_from(19.0);
    far.image.width = far.image.height = 60;
    EXPECT_LT(change(far), 0.05);
    EXPECT_GT(change(view_from(1.5)), 1.0);
}

TEST(RainOnWater, FallsOnlyWhereAMapHasIt) {
    Snapshot half = pond_in_rain(0.0);
    half.rain = [](double from, double until) {
        Grid fallen(40, 40);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 18; ++x) fallen(x, y) = (until - from) * 60.0 / 3.6e6;
        return fallen;
    };
    const View near = view_from(6.0);
    const Image calm = picture(near, pond_in_rain(0.0));
    const Image rained = picture(near, half);
    int west = 0;
    int east = 0;
    for (int y = 120; y < 240; ++y) {
        for (int x = 0; x < 240; ++x) {
            const std::size_t at = 3 * static_cast<std::size_t>(x);
            const bool changed = calm.row(y)[at] != rained.row(y)[at];
            (x < 120 ? west : east) += changed ? 1 : 0;
        }
    }
    EXPECT_GT(west, 1000);
    EXPECT_EQ(east, 0);
}

TEST(RainOnWater, FiguresAndBedsInSitesHaveNone) {
    View figure = view_from(1.5);
    figure.look.mode = ViewMode::figure;
    EXPECT_EQ(picture(figure, pond_in_rain(60.0)).rgb, picture(figure, pond_in_rain(0.0)).rgb);
    const auto in_sites = [](double rate) {
        Snapshot pond = pond_in_rain(rate);
        pond.scale.in_metres = false;
        return pond;
    };
    const View near = view_from(1.5);
    EXPECT_EQ(picture(near, in_sites(60.0)).rgb, picture(near, in_sites(0.0)).rgb);
}

TEST(RainOnWater, AnyNumberOfThreadsDrawsTheSame) {
    const View near = view_from(1.5);
    EXPECT_EQ(picture(near, pond_in_rain(60.0), 1).rgb, picture(near, pond_in_rain(60.0), 2).rgb);
}

}  // namespace
}  // namespace fumon
