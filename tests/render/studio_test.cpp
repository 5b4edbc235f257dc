// A block as a museum lights a model.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "render/light/view_light.h"
#include "render/view/ground_choice.h"
#include "support/drawn_picture.h"
#include "support/water_beds.h"

namespace fumon {
namespace {

View studio_view(int width = 320, int height = 180) {
    View view = small_view(width, height);
    view.look.ground = Ground::table;
    return view;
}

double saturation(const std::uint8_t* pixel) {
    const auto [low, high] = std::minmax({pixel[0], pixel[1], pixel[2]});
    return high == 0 ? 0.0 : static_cast<double>(high - low) / high;
}

/// CIE L*, 0 … 100, of a grey of that display value.
double lightness(const std::uint8_t* pixel) {
    const double value = (0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]) / 255.0;
    const double luminance =
        value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    return luminance <= 0.008856 ? 903.3 * luminance : 116.0 * std::cbrt(luminance) - 16.0;
}

TEST(Studio, ShadowOnTheTableIsGreyAndSoft) {
    for (const double elevation : {12.0, 24.0, 50.0}) {
        View view = studio_view();
        view.camera.elevation = 40.0;
        view.camera.margin = 0.3;
        view.sun.elevation = elevation;
        view.look.colour_by = Colouring::height;  // the ground is blue and green, the table is not
        view.look.palette = "viridis";
        view.look.block_sides = false;
        View bare = view;
        bare.look.background = Background::transparent;
        const Snapshot bed = wavy_bed(60, 50);
        const Image image = picture(view, bed);
        const Image alone = picture(bare, bed);
        double lit = 0.0;
        double dark = 100.0;
        double most_coloured = 0.0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const auto at = static_cast<std::size_t>(y * image.width + x);
                if (alone.alpha[at] != 0) continue;
                const std::uint8_t* pixel = image.row(y) + 3 * static_cast<std::size_t>(x);
                lit = std::max(lit, lightness(pixel));
                dark = std::min(dark, lightness(pixel));
                most_coloured = std::max(most_coloured, saturation(pixel));
            }
        }
        EXPECT_LE(most_coloured, 0.15) << elevation;
        EXPECT_GE(dark, 0.4 * lit) << elevation;
        EXPECT_LE(dark, 0.9 * lit) << elevation;  // there is one
    }
}

TEST(Studio, IsForBlocksThatAskForNoSky) {
    const auto chosen = [](const View& view) { return with_chosen_light(view).look.light; };
    const View block = studio_view();
    EXPECT_EQ(chosen(block), LightKind::studio);
    EXPECT_EQ(with_chosen_light(block).sun.diameter, studio_lamp_width);
    View other = block;
    other.look.ground = Ground::endless;
    EXPECT_EQ(chosen(other), LightKind::sun);
    other = block;
    other.look.mode = ViewMode::figure;
    EXPECT_EQ(chosen(other), LightKind::sun);
    other = block;
    other.look.light = LightKind::sun;
    EXPECT_EQ(chosen(other), LightKind::sun);
    EXPECT_EQ(with_chosen_light(other).sun.diameter, block.sun.diameter);
    other = block;
    other.look.sky = SkyModel::atmosphere;
    EXPECT_EQ(chosen(other), LightKind::sun);
    other.look.light = LightKind::studio;
    EXPECT_EQ(chosen(other), LightKind::studio);
    other = block;
    other.sun.source = LightSource::moon;
    EXPECT_EQ(chosen(other), LightKind::sun);
    other = block;
    other.sun.place = {35.0, 139.0};
    EXPECT_EQ(chosen(other), LightKind::sun);
}

TEST(Studio, EndlessGroundIsLitByTheSun) {
    View view = small_view();
    view.look.light = LightKind::studio;
    EXPECT_EQ(with_chosen_ground(view, wavy_bed(40, 30)).look.ground, Ground::table);
    view.look.ground = Ground::endless;
    EXPECT_THROW(with_chosen_ground(view, wavy_bed(40, 30)), InputError);
}

TEST(Studio, TableAndWallHaveNoEdgeBetweenThem) {
    View view = studio_view(240, 180);
    view.camera.elevation = 4.0;
    const Image image = picture(view, wavy_bed(60, 50));
    for (int y = 1; y < image.height; ++y) {
        for (std::size_t c = 0; c < 3; ++c)  // beside the block
            EXPECT_LE(std::abs(image.row(y)[c] - image.row(y - 1)[c]), 6) << y;
    }
}

TEST(Studio, IsTheSameOnAnyNumberOfThreads) {
    for (const Snapshot& bed : {wavy_bed(60, 50), masked_bed(60, 50)}) {
        const Image one = picture(studio_view(), bed, 1);
        EXPECT_EQ(one.rgb, picture(studio_view(), bed, 2).rgb);
    }
}

TEST(Studio, PilesLieOnABoard) {
    View view = studio_view(160, 120);
    view.camera.elevation = 60.0;
    view.look.block_sides = false;
    view.look.grain = 0.0;
    view.look.background = Background::transparent;
    Snapshot pile;
    pile.landform = Landform::pile;
    pile.bed = Grid(48, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 48; ++x)
            pile.bed(x, y) = std::max(0.0, std::round(12.0 - std::hypot(x - 24.0, y - 20.0)));
    const auto neutral_share = [&](PileSurface surface) {
        view.look.pile = surface;
        const Image image = picture(view, pile);
        int ground = 0;
        int neutral = 0;
        for (std::size_t i = 0; i < image.alpha.size(); ++i) {
            if (image.alpha[i] != 255) continue;
            ++ground;
            neutral += saturation(image.rgb.data() + 3 * i) < 0.15 ? 1 : 0;
        }
        return static_cast<double>(neutral) / ground;
    };
    const double board = 1.0 - 3.14 * 12.0 * 12.0 / (48.0 * 40.0);
    EXPECT_NEAR(neutral_share(PileSurface::smooth), board, 0.06);
    EXPECT_EQ(neutral_share(PileSurface::cells), 0.0);
}

TEST(Studio, WaterIsDarkFromAboveAndMirrorsWindowsSeenFlatly) {
    const auto mean = [](double elevation) {
        View view = studio_view(160, 120);
        view.camera.elevation = elevation;
        view.look.block_sides = false;
        view.look.background = Background::transparent;
        view.look.water_clarity = {"", 0.4};
        const Image image = picture(view, under_water(flat_bed(40, 40), 4.0, 0.0));
        std::array<double, 3> sum{};
        double count = 0.0;
        for (std::size_t i = 0; i < image.alpha.size(); ++i) {
            if (image.alpha[i] != 255) continue;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += image.rgb[3 * i + c];
            ++count;
        }
        std::array<std::uint8_t, 3> colour{};
        for (std::size_t c = 0; c < 3; ++c) colour[c] = static_cast<std::uint8_t>(sum[c] / count);
        return colour;
    };
    const auto above = mean(70.0);
    const auto flat = mean(14.0);
    EXPECT_LE(lightness(above.data()), 35.0);
    EXPECT_GE(lightness(flat.data()), lightness(above.data()) + 15.0);
    EXPECT_LE(lightness(flat.data()), 85.0);  // nor white as plaster
    EXPECT_GE(flat[2], flat[0]);
}

TEST(Studio, SidesArePlasterByThemselves) {
    View view = studio_view();
    const Snapshot bed = wavy_bed(60, 50);
    const Image plain = picture(view, bed);
    view.look.sides = BlockSides::soil;
    const Image soil = picture(view, bed);
    EXPECT_NE(plain.rgb, soil.rgb);
}

}  // namespace
}  // namespace fumon
