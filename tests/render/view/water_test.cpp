#include "render/view/water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "base/error.h"
#include "base/worker_pool.h"
#include "gl/context.h"
#include "numerics/resampling.h"
#include "render/colour/colouring.h"
#include "render/colour/palette.h"
#include "render/renderer.h"
#include "render/view/block.h"
#include "support/drawn_picture.h"
#include "support/water_beds.h"

namespace fumon {
namespace {

/// From above, of a square bed, without margins: picture places are places on the bed.
View map_view(int side = 200) {
    View view;
    view.image.width = side;
    view.image.height = side;
    view.camera.projection = Projection::map;
    view.camera.margin = 0.0;
    view.look.grain = 0.0;
    view.look.exaggeration = {"", 1.0};
    return view;
}

View map_figure(Colouring colour_by) {
    View view = map_view();
    view.look.mode = ViewMode::figure;
    view.look.colour_by = colour_by;
    view.look.palette = "viridis";
    view.look.shading = 0.0;
    return view;
}

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

/// The west half of a flat bed wet, to one depth and speed.
Snapshot half_wet(double depth, double speed = 0.0) {
    Snapshot snapshot = under_water(flat_bed(100, 100), 0.0, 0.0);
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 50; ++x) {
            snapshot.fields[0].values(x, y) = depth;
            snapshot.fields[2].values(x, y) = speed;
        }
    }
    return snapshot;
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
            const bool same = colour_at(with, at_x, at_y) == colour_at(without, at_x, at_y);
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
    EXPECT_GT(shown(0.05)[1], 0.1);
}

TEST(Water, IsClosedWhereItIsDeeperThanTheGroundIsRough) {
    EXPECT_NEAR(closed_depth({1.0, 1.0, 1.0, true}), 0.004, 1e-15);
    EXPECT_NEAR(closed_depth({100.0, 400.0, 1.0, true}), 0.04, 1e-15);
    const Snapshot film = under_water(flat_bed(20, 20), 0.001, 0.0);
    EXPECT_NEAR(display_water(film, 1).damp(10, 10), 0.5F, 1e-6F);
    const Snapshot deep = under_water(flat_bed(20, 20), 0.004, 0.0);
    EXPECT_EQ(display_water(deep, 1).damp(10, 10), 1.0F);
}

/// A V-shaped valley, steeper in the west, that falls southward by a tenth, a stream in its lowest
/// column and rain's film on its flanks.
Snapshot stream_in_a_valley() {
    Snapshot valley = under_water(flat_bed(21, 40), 0.0005, 0.0);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 21; ++x)
            valley.bed(x, y) = (x < 10 ? 0.8 * (10 - x) : 0.3 * (x - 10)) + 0.1 * y;
        valley.fields[0].values(10, y) = 0.15;
    }
    return valley;
}

TEST(Water, LiesLevelAcrossAChannelOfOneCell) {
    const DisplayWater water = display_water(stream_in_a_valley(), 1);
    EXPECT_NEAR(water.slope_x(10, 20), 0.0F, 1e-6F);
    EXPECT_NEAR(water.slope_y(10, 20), 0.1F, 1e-5F);
    EXPECT_NEAR(water.slope_x(9, 20), 0.0F, 1e-6F);  // its bank's film does not tilt it
    const DisplayWater sheet = display_water(
        [] {
            Snapshot plane = under_water(flat_bed(20, 20), 0.1, 0.0);
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 20; ++x) plane.bed(x, y) = 0.3 * x;
            return plane;
        }(),
        1);
    EXPECT_NEAR(sheet.slope_x(10, 10), 0.3F, 1e-5F);
    EXPECT_NEAR(sheet.slope_x(0, 10), 0.3F, 1e-5F);
}

TEST(Water, EndsWhereItsLevelMeetsTheGround) {
    // A pond to level 1.6 before a bank of 45 degrees, on which there is a film of half a
    // millimetre.
    constexpr int finer = 8;
    Snapshot pond = under_water(flat_bed(20, 12), 0.0005, 0.0);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 20; ++x) {
            pond.bed(x, y) = std::max(0.0, x - 8.3);
            if (pond.bed(x, y) < 1.6) pond.fields[0].values(x, y) = 1.6 - pond.bed(x, y);
        }
    }
    const DisplayWater water = display_water(pond, finer);
    Field<float> bed(20, 12);
    std::copy(pond.bed.values().begin(), pond.bed.values().end(), bed.values().begin());
    const Field<float> ground = refined(bed, finer);
    const int middle = 6 * finer;
    for (int x = 9 * finer; x < 18 * finer; ++x) {
        const double above = 1.6 - static_cast<double>(ground(x, middle));
        if (above > 0.02) {
            EXPECT_NEAR(water.depth(x, middle), above, 0.02) << x;
        } else if (above < -0.02) {
            EXPECT_LT(water.depth(x, middle), 0.0011) << x;
        }
    }
    // A film on a slope follows it, however far its surface falls within a cell.
    const DisplayWater stream = display_water(stream_in_a_valley(), finer);
    for (int x = 2 * finer; x < 8 * finer; ++x)
        EXPECT_NEAR(stream.depth(x, 20 * finer), 0.0005F, 1e-5F) << x;
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

TEST(Water, DeeperWaterIsDarkerAndBluer) {
    Snapshot lake = under_water(flat_bed(100, 100), 0.2, 0.0);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 50; ++x) lake.fields[0].values(x, y) = 3.0;
    View view = map_view();
    view.look.water_clarity = {"", 1.0};
    const Image image = picture(view, lake);
    const auto deep = mean_between(image, 0.1, 0.4);
    const auto shallow = mean_between(image, 0.6, 0.9);
    EXPECT_LT(brightness(deep), brightness(shallow) - 15.0);
    EXPECT_GT(deep[2] / deep[0], 1.5 * shallow[2] / shallow[0]);
    view.look.turbidity = 1.0;
    const auto muddy = mean_between(picture(view, lake), 0.1, 0.4);
    EXPECT_LT(muddy[2] / muddy[0], 0.6 * deep[2] / deep[0]);
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

TEST(WaterMap, DepthsHaveThePalettesColoursAndDryCellsNone) {
    Snapshot pools = half_wet(0.010);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 25; ++x) pools.fields[0].values(x, y) = 0.012;
    View view = map_figure(Colouring::water_depth);
    view.look.low = {"", 0.008};
    view.look.high = {"", 0.012};
    const Palette palette = read_palette("viridis");
    const auto expect_entry = [&](const Image& image, double x, std::size_t entry) {
        const auto shown = colour_at(image, x, 0.5);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(shown[i], palette[entry][i], 1) << entry;
    };
    const Image image = picture(view, pools);
    expect_entry(image, 0.12, 255);
    expect_entry(image, 0.38, 128);
    view.look.palette_reversed = true;
    const Image reversed = picture(view, pools);
    expect_entry(reversed, 0.12, 0);
    EXPECT_EQ(colour_at(reversed, 0.8, 0.5), colour_at(image, 0.8, 0.5));  // dry
    EXPECT_NE(colour_at(reversed, 0.8, 0.5), colour_at(reversed, 0.38, 0.5));
}

TEST(WaterMap, ShadingIsAShare) {
    Snapshot relief = under_water(wavy_bed(100, 100), 0.01, 0.2);
    View view = map_figure(Colouring::height);
    const auto spread = [&](double shading) {
        view.look.shading = shading;
        view.look.low = {"", -100.0};  // one colour everywhere
        view.look.high = {"", 100.0};
        const Image image = picture(view, relief);
        int darkest = 255;
        for (int y = 0; y < 200; ++y)
            darkest = std::min(darkest, colour_at(image, (y + 0.5) / 200.0, 0.5)[1]);
        return darkest;
    };
    EXPECT_GT(spread(0.5), spread(1.0) + 10);
    EXPECT_GT(spread(0.0), spread(0.5) + 10);
}

std::pair<double, double> range_in_wet_cells(const LookSettings& look, const Snapshot& snapshot,
                                             const Snapshot& first) {
    return colour_range(look, snapshot, coloured_values(look.colour_by, snapshot, first));
}

TEST(WaterMap, AutomaticRangesAreThoseOfWetCells) {
    Snapshot film = half_wet(0.01, 0.5);
    film.nodata = Mask(100, 100);
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 50; ++x) film.fields[0].values(x, y) += 1e-7 * (y * 50 + x);
    }
    film.nodata(3, 3) = 1;
    film.fields[0].values(3, 3) = 7.0;
    film.fields[0].values(4, 4) = 5.0;  // one cell of 4999
    LookSettings look;
    look.colour_by = Colouring::water_depth;
    const auto [low, high] = range_in_wet_cells(look, film, film);
    EXPECT_NEAR(low, 0.01 + 0.005 * 5e-4, 1e-6);
    EXPECT_NEAR(high, 0.01 + 0.995 * 5e-4, 1e-6);
    look.colour_by = Colouring::froude;
    const auto froude = range_in_wet_cells(look, film, film);
    EXPECT_NEAR(froude.second, 0.5 / std::sqrt(9.8 * 0.01), 0.01);
    EXPECT_GT(froude.first, 1.5);
    look.colour_by = Colouring::speed;
    EXPECT_EQ(coloured_values(look.colour_by, film, film)(10, 10), 0.5F);
    EXPECT_EQ(coloured_values(look.colour_by, film, film)(90, 10), 0.0F);
}

TEST(WaterMap, NeedsWater) {
    for (const Colouring colour_by :
         {Colouring::water_depth, Colouring::speed, Colouring::froude}) {
        const View view = map_figure(colour_by);
        EXPECT_THROW(picture(view, flat_bed(20, 20)), InputError);
    }
}

TEST(WaterClarity, FollowsTheDepths) {
    const LookSettings look;
    const WaterStatistics film = water_statistics(under_water(flat_bed(50, 50), 0.01, 0.6));
    EXPECT_NEAR(film.high_depth, 0.01, 1e-6);
    EXPECT_NEAR(film.median_froude, 0.6 / std::sqrt(9.8 * 0.01), 1e-4);
    EXPECT_NEAR(water_clarity(look, film), 0.04, 1e-5);
    EXPECT_NEAR(water_clarity(look, {2.0, 0.2, 0.0}), 1.2, 1e-3);
    EXPECT_GT(water_clarity(look, water_statistics(flat_bed(9, 9))), 0.0);
    LookSettings chosen;
    chosen.water_clarity = {"", 0.3};
    EXPECT_EQ(water_clarity(chosen, film), 0.3);
}

TEST(WaterRelief, AFilmsChannelsAreExaggeratedAndKeepTheirRoom) {
    Snapshot film = under_water(flat_bed(100, 100), 0.01, 0.6);
    const double exaggeration = automatic_exaggeration(film);
    EXPECT_EQ(exaggeration, 50.0);  // the first to make 4 % of 100 m from ten depths
    EXPECT_EQ(automatic_exaggeration(flat_bed(100, 100)), 1.0);
    EXPECT_EQ(automatic_exaggeration(under_water(flat_bed(100, 100), 2.0, 1.0)), 1.0);
    const Block block = frame_block(film, exaggeration);
    EXPECT_LT(block.base, block.z(1.0 - 0.05));
    EXPECT_GT(block.base, -0.2);
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

}  // namespace
}  // namespace fumon
