#include "render/view/water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>

#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/colour/colouring.h"
#include "render/ready_picture.h"
#include "render/renderer.h"
#include "render/view/block.h"
#include "render/view/framing.h"
#include "support/drawn_picture.h"
#include "support/water_views.h"

namespace fumon {
namespace {

/// The frame of a run that began with another snapshot.
Image later_picture(const View& view, const Snapshot& first, const Snapshot& snapshot,
                    int threads = 2) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(threads);
    Renderer renderer(*context, view, first, 100, pool);
    return renderer.render(snapshot);
}

/// The mean colour of the picture's part x0 … x1, from 0.2 to 0.8 of its height.
std::array<double, 3> mean_between(const Image& image, double x0, double x1) {
    std::array<double, 3> sum{};
    int count = 0;
    for (int y = image.height / 5; y < 4 * image.height / 5; ++y) {
        for (int x = static_cast<int>(x0 * image.width); x < static_cast<int>(x1 * image.width);
             ++x) {
            const std::uint8_t* pixel = image.row(y) + 3 * static_cast<std::size_t>(x);
            for (std::size_t i = 0; i < 3; ++i) sum[i] += pixel[i];
            ++count;
        }
    }
    for (double& channel : sum) channel /= count;
    return sum;
}

double brightness(const std::array<double, 3>& colour) {
    return 0.21 * colour[0] + 0.72 * colour[1] + 0.07 * colour[2];
}

TEST(Water, ChangesOnlyWetCellsAndTheirRim) {
    const View view = map_view();
    const Snapshot dry = under_water(flat_bed(100, 100), 0.0, 0.0);
    const Snapshot wet = half_wet(0.05);
    const Image without = picture(view, dry);
    const Image with = later_picture(view, dry, wet);
    int changed = 0;
    int beyond = 0;
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 200; ++x) {
            const double at_x = (x + 0.5) / 200.0;
            const double at_y = (y + 0.5) / 200.0;
            // The sky over the rim is a little less open beside the water's edge.
            const auto there = colour_at(with, at_x, at_y);
            const auto before = colour_at(without, at_x, at_y);
            bool same = true;
            for (std::size_t i = 0; i < 3; ++i) same = same && std::abs(there[i] - before[i]) <= 1;
            if (at_x > 0.54 && !same) ++beyond;  // four cells of rim
            if (at_x < 0.48 && !same) ++changed;
        }
    }
    EXPECT_GT(changed, 200 * 90);
    EXPECT_EQ(beyond, 0);
}

TEST(Water, WithoutItPicturesAreThoseOfABedWithoutItsFields) {
    View view = map_view();
    view.camera.projection = Projection::perspective;
    view.look.grain = 0.5;
    Snapshot bare = wavy_bed(120, 90);
    bare.scale = {1.0, 1.0, 1.0, true};
    View undrawn = view;
    undrawn.look.water = false;
    EXPECT_EQ(picture(undrawn, under_water(bare, 0.5, 1.0)), picture(view, bare));
    EXPECT_NE(picture(view, under_water(bare, 0.5, 1.0)), picture(view, bare));
}

TEST(Water, AMillimetreOnLargeCellsDarkensTheGroundAndDoesNotGlazeIt) {
    // Grazing, where a closed surface mirrors the sky.
    View view = map_view();
    view.camera.projection = Projection::orthographic;
    view.camera.azimuth = 120.0;
    view.camera.elevation = 15.0;
    const auto shown = [&](double depth) {
        Snapshot wet = under_water(flat_bed(100, 100), depth, 0.0);
        wet.scale.dx = wet.scale.dy = 70.0;
        Snapshot dry = wet;
        for (double& nothing : dry.fields[0].values.values()) nothing = 0.0;
        const auto bed = mean_between(later_picture(view, dry, dry), 0.45, 0.55);
        const auto film = mean_between(later_picture(view, dry, wet), 0.45, 0.55);
        return std::array{brightness(film) - brightness(bed), film[2] / film[0] - bed[2] / bed[0]};
    };
    const auto thin = shown(0.001);
    EXPECT_LT(thin[0], -1.0);
    EXPECT_LT(thin[1], 0.02);
    EXPECT_GT(shown(0.05)[1], 0.03);
}

TEST(Water, IsClosedWhereItIsDeeperThanTheGroundIsRough) {
    EXPECT_NEAR(closed_depth({1.0, 1.0, 1.0, true}), 0.004, 1e-15);
    EXPECT_NEAR(closed_depth({100.0, 400.0, 1.0, true}), 0.04, 1e-15);
    const Snapshot film = under_water(flat_bed(20, 20), 0.001, 0.0);
    WorkerPool pool(1);
    EXPECT_NEAR(display_water(film, 1, pool).damp(10, 10), 0.5F, 1e-6F);
    const Snapshot deep = under_water(flat_bed(20, 20), 0.004, 0.0);
    EXPECT_EQ(display_water(deep, 1, pool).damp(10, 10), 1.0F);
}

TEST(Water, WhatItLaidDownIsPaleAndWhatItWoreIsDark) {
    const Snapshot before = under_water(flat_bed(100, 100), 0.0, 0.0);
    Snapshot after = before;
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) after.bed(x, y) += x < 33 ? 0.05 : x < 66 ? 0.0 : -0.05;
    }
    const Field<float> worked = worked_bed(after, before, 0.1, 1);
    EXPECT_NEAR(worked(5, 5), 0.5F, 0.01F);
    EXPECT_NEAR(worked(95, 5), -0.5F, 0.01F);
    Snapshot sunk = before;
    for (double& height : sunk.bed.values()) height -= 3.0;  // all alike
    EXPECT_NEAR(worked_bed(sunk, before, 0.1, 1)(50, 50), 0.0F, 1e-6F);
    const Image image = later_picture(map_view(), before, after);
    const double usual = brightness(mean_between(image, 0.40, 0.60));
    EXPECT_GT(brightness(mean_between(image, 0.05, 0.28)), usual + 5.0);
    EXPECT_LT(brightness(mean_between(image, 0.72, 0.95)), usual - 5.0);
}

/// From a few metres over the bed's southern edge.
View near_view() {
    View view = map_view(400);
    view.camera.projection = Projection::perspective;
    view.camera.at = {50, -4, 4};
    view.camera.look_at = {50, 14, 0};
    return view;
}

/// The mean difference of neighbouring pixels in the lower half.
double fineness(const Image& image) {
    double sum = 0.0;
    int count = 0;
    for (int y = image.height / 2; y < image.height; ++y) {
        for (int x = 1; x < image.width; ++x) {
            const std::uint8_t* pixel = image.row(y) + 3 * static_cast<std::size_t>(x);
            sum += std::abs(int{pixel[1]} - int{pixel[-2]});
            ++count;
        }
    }
    return sum / count;
}

TEST(Water, GroundUnderItHasDetailFromNear) {
    View view = near_view();
    const Snapshot rained = under_water(flat_bed(100, 100), 0.0005, 0.0);
    const double rough = fineness(picture(view, rained));
    view.look.water = false;
    EXPECT_GT(rough, 4.0 * fineness(picture(view, rained)));
}

TEST(Water, LeavesTheSkyAloneFromNear) {
    // Where its ground is shaded finer than the first picture's, the sky is what it was.
    View view = near_view();
    view.look.sky = SkyModel::atmosphere;
    const Snapshot pond = under_water(flat_bed(100, 100), 0.3, 0.0);
    const Image with = picture(view, pond);
    view.look.water = false;
    EXPECT_EQ(colour_at(with, 0.5, 0.01), colour_at(picture(view, pond), 0.5, 0.01));
}

// Only the part that a picture shows is shaded: what an earlier one left beside it must not show.
TEST(Water, ShowsNothingOfAnEarlierCamera) {
    Snapshot bed = under_water(wavy_bed(600, 600), 0.0, 0.0);
    for (int y = 0; y < 600; ++y)
        for (int x = 0; x < 600; ++x)
            if (x / 20 % 2 == 0) bed.fields[0].values(x, y) = 0.3;
    View view = map_view(120);
    view.camera.projection = Projection::perspective;
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    const auto shared = std::make_shared<Snapshot>(bed);
    const auto from = [&](double x) {
        View seen = view;
        seen.camera.at = {x, -20, 12};
        seen.camera.look_at = {x + 10.0, 100, 0};
        return FramePose{camera_at_step(seen, framed_block(seen, bed), 0, 100), view.sun};
    };
    const auto drawn = [&](Renderer& renderer, const FramePose& pose) {
        return renderer.render(renderer.ready(shared, pose, nullptr, pool));
    };
    Renderer alone(*context, view, bed, 100, pool);
    const Image expected = drawn(alone, from(300.0));
    Renderer later(*context, view, bed, 100, pool);
    for (const double x : {100.0, 200.0, 280.0, 420.0}) drawn(later, from(x));
    EXPECT_EQ(drawn(later, from(300.0)), expected);
}

TEST(Water, DeeperWaterIsDarkerAndBluerWhereItIsTinted) {
    Snapshot lake = under_water(flat_bed(100, 100), 0.2, 0.0);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 50; ++x) lake.fields[0].values(x, y) = 3.0;
    View view = map_view();
    view.look.water_clarity = {"", 1.0};
    const Image plain = picture(view, lake);
    EXPECT_LT(brightness(mean_between(plain, 0.1, 0.4)),
              brightness(mean_between(plain, 0.6, 0.9)) - 15.0);
    view.look.water_tint = WaterTint::blue_green;
    const Image image = picture(view, lake);
    const auto deep = mean_between(image, 0.1, 0.4);
    const auto shallow = mean_between(image, 0.6, 0.9);
    EXPECT_LT(brightness(deep), brightness(shallow) - 15.0);
    EXPECT_GT(deep[2] / deep[0], 1.5 * shallow[2] / shallow[0]);
    view.look.turbidity = 1.0;
    const auto muddy = mean_between(picture(view, lake), 0.1, 0.4);
    EXPECT_LT(muddy[2] / muddy[0], 0.6 * deep[2] / deep[0]);
}

TEST(Water, SedimentMuddiesItByPlace) {
    Snapshot lake = under_water(flat_bed(100, 100), 3.0, 0.0);
    View view = map_view();
    view.look.turbidity = 0.0;
    view.look.water_clarity = {"", 1.0};
    const auto red_over_blue = [](const auto& colour) { return colour[0] / colour[2]; };
    const double clear = red_over_blue(mean_between(picture(view, lake), 0.1, 0.4));
    SnapshotField sediment{"concentration", "sediment in the water", "kg/m3", Grid(100, 100)};
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 50; ++x) sediment.values(x, y) = x == 20 ? std::nan("") : 2.0;
    }
    lake.fields.push_back(sediment);
    EXPECT_NEAR(mean_turbidity(view.look, lake), 0.49 * 2.0 / 2.0615, 1e-6);
    const Image image = picture(view, lake);
    EXPECT_GT(red_over_blue(mean_between(image, 0.1, 0.4)), 1.3 * clear);
    EXPECT_NEAR(red_over_blue(mean_between(image, 0.6, 0.9)), clear, 0.01);
    lake.fields.back().unit = "1";
    EXPECT_EQ(mean_turbidity(view.look, lake), 0.0);
}

// Muddy water hides its ground, also how that lies to the sun.
TEST(Water, IsLitAsItsSurfaceLiesAndNotAsItsGround) {
    View view = map_view();
    view.sun.azimuth = 270.0;
    view.sun.elevation = 15.0;
    view.look.water_clarity = {"", 0.2};
    view.look.turbidity = 1.0;
    const auto shown = [&](double fall) {
        Snapshot lake = under_water(flat_bed(100, 100), 0.0, 0.0);
        for (int y = 0; y < 100; ++y) {
            for (int x = 0; x < 100; ++x) {
                lake.bed(x, y) = -fall * x;
                lake.fields[0].values(x, y) = 10.0 - lake.bed(x, y);
            }
        }
        return brightness(mean_between(picture(view, lake), 0.3, 0.7));
    };
    EXPECT_NEAR(shown(0.4), shown(0.0), 3.0);
}

TEST(Water, FoamsWhereItShoots) {
    // Two streams as deep, one at Froude number 0.5, the other at 2.5.
    Snapshot streams = under_water(flat_bed(100, 100), 0.1, 0.5 * std::sqrt(9.8 * 0.1));
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 40; ++x) streams.fields[2].values(x, y) = 2.5 * std::sqrt(9.8 * 0.1);
    const Image image = picture(map_view(), streams);
    const auto shooting = mean_between(image, 0.05, 0.35);
    const auto streaming = mean_between(image, 0.6, 0.95);
    EXPECT_GT(brightness(shooting), brightness(streaming) + 8.0);
}

TEST(Water, WetSandIsDarkerThanDry) {
    View view = map_view();
    view.look.water_clarity = {"", 10.0};  // far too thin a film to tint
    const Image image = picture(view, half_wet(0.001));
    EXPECT_LT(brightness(mean_between(image, 0.1, 0.4)),
              0.9 * brightness(mean_between(image, 0.6, 0.9)));
}

TEST(Water, StandsOnTheBed) {
    View view = map_view(300);
    view.camera.projection = Projection::orthographic;
    view.camera.elevation = 5.0;
    view.look.room = {"", 40.0};
    const Snapshot dry = under_water(flat_bed(100, 100), 0.0, 0.0);
    const auto top_row = [&](const Snapshot& snapshot) {
        const Image image = later_picture(view, dry, snapshot);
        const auto background = colour_at(image, 0.5, 0.0);
        int row = 0;
        while (row < 299 && std::abs(colour_at(image, 0.5, row / 300.0)[0] - background[0]) < 25)
            ++row;
        return row;
    };
    EXPECT_LT(top_row(under_water(flat_bed(100, 100), 20.0, 0.0)), top_row(dry) - 20);
}

TEST(Water, GivesTheSamePixelsForAnyNumberOfThreads) {
    const Snapshot stream = under_water(wavy_bed(120, 90), 0.5, 3.0);
    View view = map_view();
    view.camera.projection = Projection::perspective;
    const Image expected = later_picture(view, stream, stream, 1);
    for (const int threads : {2, 5})
        EXPECT_EQ(later_picture(view, stream, stream, threads), expected);
}

TEST(Water, CellsWithoutDataAreNotDrawnWhateverTheirWater) {
    Snapshot masked = under_water(masked_bed(80, 80), 0.4, 1.0);
    Snapshot unknown = masked;
    for (std::size_t i = 0; i < masked.nodata.size(); ++i) {
        if (masked.nodata.values()[i] == 0) continue;
        for (SnapshotField& field : unknown.fields)
            field.values.values()[i] = std::numeric_limits<double>::quiet_NaN();
    }
    for (const Colouring colour_by : {Colouring::natural, Colouring::froude}) {
        View view = map_view();
        view.look.colour_by = colour_by;
        EXPECT_EQ(picture(view, unknown), picture(view, masked));
    }
}

TEST(Datum, ABedThatSinksAsAWholeStaysWhereItWas) {
    const Snapshot first = under_water(wavy_bed(90, 90), 0.01, 0.6);
    Snapshot sunk = first;
    for (double& height : sunk.bed.values()) height -= 8.0;
    View view = map_view();
    view.camera.projection = Projection::perspective;
    const Image before = later_picture(view, first, first);
    const Image mean = later_picture(view, first, sunk);
    std::size_t different = 0;
    for (std::size_t i = 0; i < mean.rgb.size(); ++i) {
        if (std::abs(int{mean.rgb[i]} - int{before.rgb[i]}) > 2) ++different;
    }
    EXPECT_LT(different, mean.rgb.size() / 1000);
    view.look.datum = Datum::first;
    EXPECT_EQ(later_picture(view, first, first), before);
    EXPECT_NE(later_picture(view, first, sunk), mean);
}

TEST(Datum, TheSeaStaysWhereItIs) {
    const Snapshot dry = wavy_bed(20, 20);
    const Snapshot wet = under_water(dry, 0.01, 0.6);
    LookSettings look;
    EXPECT_FALSE(counts_from_own_mean(look, dry));
    EXPECT_TRUE(counts_from_own_mean(look, wet));
    look.sea_level = 0.0;
    EXPECT_FALSE(counts_from_own_mean(look, wet));
    look.datum = Datum::mean;
    EXPECT_TRUE(counts_from_own_mean(look, wet));
}

}  // namespace
}  // namespace fumon
