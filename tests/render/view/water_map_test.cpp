#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "render/colour/colouring.h"
#include "render/colour/palette.h"
#include "support/drawn_picture.h"
#include "support/water_views.h"

namespace fumon {
namespace {

View map_figure(Colouring colour_by) {
    View view = map_view();
    view.look.mode = ViewMode::figure;
    view.look.colour_by = colour_by;
    view.look.palette = "viridis";
    view.look.shading = 0.0;
    return view;
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
    return colour_range(look, snapshot, coloured_values(look, snapshot, first));
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
    EXPECT_EQ(coloured_values(look, film, film)(10, 10), 0.5F);
    EXPECT_EQ(coloured_values(look, film, film)(90, 10), 0.0F);
}

TEST(WaterMap, NeedsWater) {
    for (const Colouring colour_by :
         {Colouring::water_depth, Colouring::speed, Colouring::froude}) {
        const View view = map_figure(colour_by);
        EXPECT_THROW(picture(view, flat_bed(20, 20)), InputError);
    }
}

}  // namespace
}  // namespace fumon
