#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "gl/functions.h"
#include "render/bed/drape_texture.h"
#include "support/drawn_picture.h"
#include "support/view_beds.h"
#include "support/water_views.h"

namespace fumon {
namespace {

using Colour = std::array<std::uint8_t, 4>;

template <class ColourOf>
std::shared_ptr<const Drape> drape_of(int width, int height, const ColourOf& colour_of) {
    auto drape = std::make_shared<Drape>();
    drape->width = width;
    drape->height = height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Colour colour = colour_of(x, y);
            drape->texels.insert(drape->texels.end(), colour.begin(), colour.end());
        }
    }
    return drape;
}

View map_view(int width, int height) {
    View view = small_view(width, height);
    view.camera.projection = Projection::map;
    view.camera.margin = 0.0;
    view.look.drape_light = DrapeLight::as_it_is;
    view.look.grain = 0.0;
    return view;
}

TEST(Drape, LiesNorthUpAndEachPixelInItsPlace) {
    // Four texels to a pixel of the picture, one of a colour of its own.
    View view = map_view(200, 100);
    view.drape = drape_of(200, 100, [](int x, int y) {
        return x == 150 && y == 80 ? Colour{255, 0, 0, 255} : Colour{0, 0, 255, 255};
    });
    const Image image = picture(view, flat_bed(200, 100));
    double sum = 0.0;
    double east = 0.0;
    double south = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double red = image.row(y)[3 * x];
            sum += red;
            east += red * (x + 0.5);
            south += red * (y + 0.5);
        }
    }
    ASSERT_GT(sum, 100.0);
    EXPECT_NEAR(east / sum, 150.5, 0.5);
    EXPECT_NEAR(south / sum, 100.0 - 80.5, 0.5);
}

TEST(Drape, AsItIsKeepsItsColours) {
    View view = map_view(64, 64);
    view.drape = drape_of(2, 1, [](int x, int) {
        return x == 0 ? Colour{10, 120, 230, 255} : Colour{200, 60, 90, 255};
    });
    for (const ViewMode mode : {ViewMode::scenic, ViewMode::figure}) {
        view.look.mode = mode;
        const Image image = picture(view, flat_bed(64, 64));
        const auto west = colour_at(image, 0.1, 0.5);
        const auto east = colour_at(image, 0.9, 0.5);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(west[channel], (std::array{10, 120, 230}[channel]), 1);
            EXPECT_NEAR(east[channel], (std::array{200, 60, 90}[channel]), 1);
        }
    }
}

TEST(Drape, TheGroundShowsWhereItHasNoDataAndAtNoStrength) {
    const Snapshot bed = wavy_bed(80, 60);
    const View bare = map_view(80, 60);
    View view = bare;
    view.drape = drape_of(4, 4, [](int x, int) {
        return Colour{255, 0, 0, x < 2 ? std::uint8_t{0} : std::uint8_t{255}};
    });
    const Image ground = picture(bare, bed);
    const Image image = picture(view, bed);
    for (const double x : {0.05, 0.2, 0.3}) {
        const auto seen = colour_at(image, x, 0.5);
        const auto expected = colour_at(ground, x, 0.5);
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(seen[channel], expected[channel], 3) << x;
    }
    EXPECT_EQ(colour_at(image, 0.8, 0.5), (std::array{255, 0, 0}));
    view.look.drape_strength = 0.0;
    const Image none = picture(view, bed);
    for (const double x : {0.1, 0.5, 0.9}) {
        const auto seen = colour_at(none, x, 0.5);
        const auto expected = colour_at(ground, x, 0.5);
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(seen[channel], expected[channel], 3) << x;
    }
}

/// What is finer than a pixel is grey, wherever it lies; no pattern of its own comes of it.
TEST(Drape, FineStripesFromAfarAreGrey) {
    for (const bool endless : {false, true}) {
        View view = small_view(160, 90);
        view.look.drape_light = DrapeLight::as_it_is;
        view.look.grain = 0.0;
        view.camera.elevation = 50.0;
        view.look.ground = endless ? Ground::endless : Ground::table;
        view.drape = drape_of(1024, 1024, [](int x, int y) {
            const std::uint8_t level = (x + y) % 2 == 0 ? 255 : 0;
            return Colour{level, level, level, 255};
        });
        Snapshot bed = flat_bed(64, 64);
        const Image image = picture(view, bed);
        double sum = 0.0;
        double squares = 0.0;
        int count = 0;
        for (int y = 40; y < 52; ++y) {
            for (int x = 70; x < 90; ++x) {
                const double level = image.row(y)[3 * x];
                sum += level;
                squares += level * level;
                ++count;
            }
        }
        const double mean = sum / count;
        EXPECT_NEAR(mean, 188.0, 6.0) << endless;  // of half the light
        EXPECT_LT(squares / count - mean * mean, 9.0) << endless;
    }
}

TEST(Drape, ItsMipmapsKeepPlaceAndLightWhereSidesAreOdd) {
    const auto drape = drape_of(7, 5, [](int x, int) {
        return x < 3 ? Colour{0, 0, 0, 0} : Colour{90, 90, 90, 255};
    });
    const std::vector<DrapeLevel> levels = drape_levels(*drape);
    ASSERT_EQ(levels.size(), 3U);
    EXPECT_EQ(levels[1].width, 3);
    EXPECT_EQ(levels[1].height, 2);
    EXPECT_EQ(levels[2].width, 1);
    EXPECT_EQ(levels[2].texels[3], (255 * 4 + 3) / 7);  // four of seven columns
    // Seen through, it is no darker: colours are times the opacity.
    const DrapeLevel& last = levels[2];
    EXPECT_NEAR(255.0 * last.texels[0] / last.texels[3], 90.0, 1.0);
    EXPECT_EQ(levels[0].texels[4 * 3], 90);
    EXPECT_EQ(levels[0].texels[3], 0);
}

TEST(Drape, RelitItHasTheScenesShade) {
    View view = small_view(200, 150);
    view.camera.elevation = 60.0;
    view.drape = drape_of(8, 8, [](int, int) { return Colour{128, 128, 128, 255}; });
    const Snapshot bed = wavy_bed(80, 60);
    const auto spread = [](const Image& image) {
        double sum = 0.0;
        double squares = 0.0;
        int count = 0;
        for (int y = 60; y < 90; ++y) {
            for (int x = 80; x < 120; ++x) {
                const double level = image.row(y)[3 * x];
                sum += level;
                squares += level * level;
                ++count;
            }
        }
        return squares / count - sum / count * sum / count;
    };
    EXPECT_GT(spread(picture(view, bed)), 100.0);
    view.look.drape_light = DrapeLight::as_it_is;
    EXPECT_LT(spread(picture(view, bed)), 2.0);
}

TEST(Drape, HasTheSamePixelsForAnyNumberOfThreads) {
    const Snapshot bed = wavy_bed(60, 50);
    for (const Ground ground : {Ground::table, Ground::endless}) {
        View view = small_view(160, 90);
        view.look.ground = ground;
        view.drape = drape_of(77, 53, [](int x, int y) {
            return Colour{static_cast<std::uint8_t>(3 * x), static_cast<std::uint8_t>(4 * y), 90,
                          static_cast<std::uint8_t>(x % 7 == 0 ? 60 : 255)};
        });
        const Image expected = picture(view, bed, 1);
        EXPECT_EQ(picture(view, bed, 2), expected);
        setenv("LP_NUM_THREADS", "1", 1);
        EXPECT_EQ(picture(view, bed, 2), expected);
        unsetenv("LP_NUM_THREADS");
    }
}

TEST(Drape, LiesUnderShallowWater) {
    View view = small_view(160, 90);
    const Snapshot bed = half_wet(0.3);
    const Image ground = picture(view, bed);
    view.drape = drape_of(8, 8, [](int, int) { return Colour{255, 0, 0, 255}; });
    EXPECT_NE(picture(view, bed), ground);
}

/// OpenGL 3.3 grants a fragment shader 16 textures. Programs are asked by the names of samplers.
TEST(Drape, UnderWaterNoProgramHasMoreTexturesThanOpenGlGrants) {
    constexpr std::array samplers{
        "lighting_map",   "value_map",        "palette",      "mark_map",
        "uncoloured_map", "noise_map",        "ground_map",   "water_map",
        "surface_map",    "streak_map",       "rill_map",     "ring_map",
        "sky_map",        "drape_map",        "visibility",   "grain",
        "positions",      "shaded",           "kinds",        "height_map",
        "cloud_map",      "floor_map",        "streamer_map", "offsets",
        "finer",          "water_surface_map"};
    View view = small_view(160, 90);
    view.drape = drape_of(8, 8, [](int, int) { return Colour{255, 0, 0, 255}; });
    const Snapshot bed = half_wet(0.3);
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer renderer(*context, view, bed, 100, pool);
    renderer.render(bed);
    const gl::Functions& gl = gl::functions();
    int most = 0;
    bool draped = false;
    constexpr GLuint names_tried = 400;
    for (GLuint program = 1; program < names_tried; ++program) {
        int count = 0;
        for (const char* sampler : samplers)
            count += gl.GetUniformLocation(program, sampler) >= 0 ? 1 : 0;
        draped = draped || gl.GetUniformLocation(program, "drape_map") >= 0;
        most = std::max(most, count);
    }
    while (gl.GetError() != GL_NO_ERROR) {
    }
    EXPECT_TRUE(draped);
    EXPECT_GT(most, 10);
    EXPECT_LE(most, 16);
}

}  // namespace
}  // namespace fumon
