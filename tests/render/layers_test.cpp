#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include "base/error.h"
#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/renderer.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"
#include "render/view/tile_warp.h"
#include "support/drawn_picture.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

LayeredImage layers_of(const View& view, const Snapshot& bed, int threads = 2,
                       const RenderLimits& limits = {}) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(threads);
    return Renderer(*context, view, bed, 100, pool, limits, PixelFormat::radiance)
        .render_layers(bed, true);
}

const std::vector<float>& layer(const LayeredImage& image, const std::string& name) {
    const auto found = std::ranges::find(image.layers, name, &ImageLayer::name);
    if (found == image.layers.end()) throw std::runtime_error("there is no layer " + name);
    return found->values;
}

/// Metres of 2 m a cell, 0.5 m a model height; periodic beds go on to the horizon.
Snapshot in_metres(Snapshot bed, bool periodic) {
    bed.scale = {2.0, 2.0, 0.5, true, {}};
    bed.periodic = periodic;
    return bed;
}

TEST(Layers, ALevelPlainSeenFromAboveIsAsFarAsTheCameraIsHigh) {
    Snapshot bed;
    bed.bed = Grid(40, 30, 3.0);
    bed = in_metres(bed, false);
    View view = small_view(80, 60);
    view.camera.azimuth = 180.0;
    view.camera.elevation = 90.0;
    view.camera.at = {40.0, 30.0, 25.0};  // metres above the bed, over its middle
    view.camera.look_at = {40.0, 30.0, 0.0};
    view.camera.field_of_view = 30.0;
    const LayeredImage image = layers_of(view, bed);
    for (std::size_t i = 0; i < layer(image, "Z").size(); ++i) {
        ASSERT_NEAR(layer(image, "Z")[i], 25.0, 1e-4);
        ASSERT_NEAR(layer(image, "position.Z")[i], 1.5, 1e-5);
        ASSERT_EQ(layer(image, "field.height")[i], 1.5F);
        ASSERT_EQ(layer(image, "normal.Z")[i], 1.0F);
    }
    // The picture is 2·25·tan 15° high.
    EXPECT_NEAR(layer(image, "position.Y").front() - layer(image, "position.Y").back(),
                50.0 * std::tan(0.2617993878) * 59.0 / 60.0, 1e-3);
}

/// The ground of a view of a bed of 2 m a cell, where its far copies differ from it.
struct Repeated {
    Repeated(const View& view_, const Snapshot& bed_)
        : bed(bed_),
          view(with_chosen_ground(view_, bed)),
          block(framed_block(view, bed)),
          copies(tile_warp_of(view, block, bed)) {}

    [[nodiscard]] glm::dvec2 in_block(double east, double north) const {
        return glm::dvec2(east, north) / block.side -
               0.5 * glm::dvec2(block.width_x, block.width_y);
    }
    /// The cell's height, metres.
    [[nodiscard]] double shown_at(double east, double north) const {
        const glm::dvec2 shown = copies.bed_position_at(in_block(east, north));
        const auto cell = [](double share, int count) {
            const int number = static_cast<int>(std::floor((share + 0.5) * count));
            return ((number % count) + count) % count;
        };
        return 0.5 * bed.bed(cell(shown.x / block.width_x, bed.bed.nx()),
                             cell(shown.y / block.width_y, bed.bed.ny()));
    }
    /// That height as the copy stands.
    [[nodiscard]] double stands_at(double east, double north, double height) const {
        const double mean = 0.5 * block.reference;
        return mean + copies.at(in_block(east, north)).height * (height - mean);
    }

    Snapshot bed;
    View view;
    Block block;
    TileWarp copies;
};

/// What holds of any picture: a point lies where the matrix says, in front of the camera by Z.
void expect_consistent(const LayeredImage& image, const View& view, const Snapshot& bed,
                       bool plain) {
    const Repeated ground(view, bed);
    const auto& z = layer(image, "Z");
    int seen = 0;
    int beds = 0;
    int others = 0;
    int copied = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto i = static_cast<std::size_t>(y * image.width + x);
            const double length =
                std::hypot(layer(image, "normal.X")[i], layer(image, "normal.Y")[i],
                           layer(image, "normal.Z")[i]);
            if (std::isinf(z[i])) {
                ASSERT_EQ(length, 0.0);
                ASSERT_TRUE(std::isnan(layer(image, "field.height")[i]));
                continue;
            }
            ++seen;
            ASSERT_NEAR(length, 1.0, 1e-5);
            const std::array<double, 4> point{layer(image, "position.X")[i],
                                              layer(image, "position.Y")[i],
                                              layer(image, "position.Z")[i], 1.0};
            const auto through = [&](const std::array<float, 16>& matrix, std::size_t column) {
                double sum = 0.0;
                for (std::size_t row = 0; row < 4; ++row)
                    sum += point.at(row) * static_cast<double>(matrix.at(4 * row + column));
                return sum;
            };
            const double w = through(image.world_to_picture, 3);
            ASSERT_NEAR(through(image.world_to_picture, 0) / w * image.width, x + 0.5, 0.02);
            ASSERT_NEAR(through(image.world_to_picture, 1) / w * image.height, y + 0.5, 0.02);
            ASSERT_NEAR(through(image.world_to_camera, 2), z[i], 2e-5 * z[i] + 1e-3);
            const float height = layer(image, "field.height")[i];
            if (std::isnan(height)) {  // a side or the plain: it faces the eye
                double away = 0.0;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const std::array<double, 3> normal{layer(image, "normal.X")[i],
                                                       layer(image, "normal.Y")[i],
                                                       layer(image, "normal.Z")[i]};
                    double along = 0.0;
                    for (std::size_t row = 0; row < 3; ++row)
                        along += normal.at(row) *
                                 static_cast<double>(image.world_to_camera.at(4 * row + axis));
                    away += along * through(image.world_to_camera, axis);
                }
                ASSERT_LT(away, 0.0);
                continue;
            }
            ++beds;
            const bool copy = ground.copies.varies_at(ground.in_block(point[0], point[1]));
            const bool other = std::abs(height - ground.shown_at(point[0], point[1])) > 1e-6;
            ASSERT_TRUE(copy || !other);
            others += other ? 1 : 0;
            if (z[i] < 60.0F || (copy && z[i] < 200.0F)) {
                copied += copy ? 1 : 0;
                const double stands = ground.stands_at(point[0], point[1], height);
                ASSERT_NEAR(point[2], stands, 0.9);  // drawn between the cells
            }
        }
    }
    EXPECT_GT(beds, image.width * image.height / 8);
    if (ground.copies.varied()) {
        EXPECT_LT(others, beds / 500) << "at the edges of cells";
        EXPECT_GT(copied, 100);
    }
    if (plain) {
        EXPECT_GT(seen, beds);  // the sides and the plain are no bed
    }
}

TEST(Layers, ABlockLiesWhereTheyTell) {
    View view = small_view(160, 90);
    view.look.exaggeration = {"", 1.0};
    const Snapshot bed = in_metres(wavy_bed(60, 50), false);
    expect_consistent(layers_of(view, bed), view, bed, true);
}

TEST(Layers, EndlessGroundLiesWhereTheyTell) {
    View view = small_view(160, 90);
    view.look.exaggeration = {"", 1.0};
    view.camera.elevation = 12.0;
    view.camera.distance = {"", 0.8};
    const Snapshot bed = in_metres(wavy_bed(64, 48), true);
    expect_consistent(layers_of(view, bed), view, bed, false);
}

/// Of neutral tone, as common/colour.glsl has it, on grey and coloured light of a contrast of 1.
std::array<double, 3> neutral_display(std::array<double, 3> c) {
    const double least = std::min({c[0], c[1], c[2]});
    for (double& v : c) v -= least < 0.08 ? least - 6.25 * least * least : 0.04;
    const double peak = std::max({c[0], c[1], c[2]});
    if (peak >= 0.76) {
        const double bright = 1.0 - 0.24 * 0.24 / (peak + 0.24 - 0.76);
        const double pale = 1.0 - 1.0 / (0.15 * (peak - bright) + 1.0);
        for (double& v : c) v = v * bright / peak * (1.0 - pale) + bright * pale;
    }
    for (double& v : c) v = v < 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
    return c;
}

TEST(Layers, TheToneCurveMakesThePictureOfTheirLight) {
    View view = small_view(200, 120);
    view.image.supersampling = 1;  // one light a pixel
    view.look.sky = SkyModel::two_colours;
    view.look.tone = Tone::neutral;
    view.look.exposure = 0.5;
    view.look.grain = 0.0;
    const Snapshot bed = wavy_bed(60, 50);
    const LayeredImage light = layers_of(view, bed);
    view.image.deep_colour = true;
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    const Image deep =
        Renderer(*context, view, bed, 100, pool, {}, PixelFormat::display_16).render(bed);
    const Image plain = picture(view, bed);
    int off = 0;
    for (std::size_t i = 0; i < light.layers[0].values.size(); ++i) {
        const double factor = std::sqrt(2.0);
        const auto display =
            neutral_display({factor * layer(light, "R")[i], factor * layer(light, "G")[i],
                             factor * layer(light, "B")[i]});
        for (std::size_t c = 0; c < 3; ++c) {
            if (std::abs(255.0 * display.at(c) - deep.rgb16[3 * i + c] / 257.0) > 1.0) ++off;
            ASSERT_EQ(deep.rgb[3 * i + c], rounded_to_8(deep.rgb16[3 * i + c]));
            // Of 8 bits with a step of dither around the block.
            ASSERT_LE(std::abs(plain.rgb[3 * i + c] - deep.rgb[3 * i + c]), 3);
        }
    }
    EXPECT_LT(off, 0.01 * static_cast<double>(deep.rgb.size()));  // where shade ends
}

TEST(Layers, AreTheSameForAnyNumberOfThreads) {
    const Snapshot bed = in_metres(wavy_bed(60, 50), false);
    const LayeredImage one = layers_of(small_view(), bed, 1);
    const LayeredImage eight = layers_of(small_view(), bed, 8);
    ASSERT_EQ(one.layers.size(), eight.layers.size());
    for (std::size_t k = 0; k < one.layers.size(); ++k) {
        const auto same = [](float a, float b) {
            return a == b || (std::isnan(a) && std::isnan(b));
        };
        EXPECT_TRUE(std::ranges::equal(one.layers[k].values, eight.layers[k].values, same))
            << one.layers[k].name;
    }
}

TEST(Layers, TilesLeaveNoSeams) {
    const Snapshot bed = in_metres(wavy_bed(60, 50), false);
    const View view = small_view(397, 211);
    const LayeredImage whole = layers_of(view, bed);
    const LayeredImage tiled = layers_of(view, bed, 2, {384});
    for (const char* name : {"R", "Z", "normal.X", "position.Y"}) {
        const auto& a = layer(whole, name);
        const auto& b = layer(tiled, name);
        int off = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (std::abs(a[i] - b[i]) > 2e-3F * std::max(1.0F, std::abs(a[i]))) ++off;
        }
        EXPECT_LE(off, 40) << name;  // single edge pixels; a seam would be a row of 211 or more
    }
}

TEST(Layers, ATransparentBackgroundIsSeenThrough) {
    View view = small_view(80, 60);
    view.look.background = Background::transparent;
    const LayeredImage image = layers_of(view, wavy_bed(30, 30));
    const auto& opacity = layer(image, "A");
    EXPECT_EQ(opacity.front(), 0.0F);
    EXPECT_EQ(layer(image, "R").front(), 0.0F);
    EXPECT_EQ(layer(image, "Z").front(), std::numeric_limits<float>::infinity());
    EXPECT_EQ(opacity[40 + 80 * std::size_t{30}], 1.0F);
}

TEST(Persons, StandOnTheBedAndAreAsTallAsPeople) {
    Snapshot bed;
    bed.bed = Grid(40, 30, 3.0);
    for (const bool periodic : {false, true}) {
        bed = in_metres(bed, periodic);  // 80 m by 60 m, 1.5 m high
        View view = small_view(120, 90);
        view.look.exaggeration = {"", 1.0};
        view.camera.at = {40.0, 22.0, 1.6};
        view.camera.look_at = {40.0, 30.0, 1.0};
        PersonSettings person;
        person.at = {40.0, 30.0};
        view.persons = {person};
        const LayeredImage image = layers_of(view, bed);
        float top = 0.0F;
        float foot = 100.0F;
        for (std::size_t i = 0; i < layer(image, "Z").size(); ++i) {
            const float x = layer(image, "position.X")[i];
            const float y = layer(image, "position.Y")[i];
            const float z = layer(image, "position.Z")[i];
            const bool bed_seen = !std::isnan(layer(image, "field.height")[i]);
            if (bed_seen || std::isinf(layer(image, "Z")[i]) || z < 1.4F) continue;
            EXPECT_NEAR(x, 40.0, 0.35);
            EXPECT_NEAR(y, 30.0, 0.35);
            top = std::max(top, z);
            foot = std::min(foot, z);
        }
        EXPECT_NEAR(top, 1.5 + 1.75, 0.05) << periodic;  // a pixel is 4 cm high there
        EXPECT_NEAR(foot, 1.5, 0.06) << periodic;
    }
}

TEST(Persons, CastTheirShadowsAwayFromTheSun) {
    Snapshot bed;
    bed.bed = Grid(40, 30, 3.0);
    for (const bool periodic : {false, true}) {
        bed = in_metres(bed, periodic);
        View view = small_view(120, 90);
        view.look.exaggeration = {"", 1.0};
        view.look.ripples = 0.0;
        view.look.grain = 0.0;
        view.camera.at = {40.0, 20.0, 6.0};
        view.camera.look_at = {40.0, 30.0, 0.0};
        view.look.light = LightKind::sun;  // a lamp's shadows are soft
        view.sun.azimuth = 270.0;
        view.sun.elevation = 30.0;
        const LayeredImage without = layers_of(view, bed);
        view.persons.resize(1);
        view.persons[0].at = {40.0, 30.0};
        const LayeredImage with = layers_of(view, bed);
        // How much of the light is left near a point on the ground.
        const auto left = [&](float east) {
            double least = 2.0;
            for (std::size_t i = 0; i < layer(with, "Z").size(); ++i) {
                const bool there = std::abs(layer(without, "position.X")[i] - east) < 0.15F &&
                                   std::abs(layer(without, "position.Y")[i] - 30.0F) < 0.15F;
                if (there)
                    least = std::min(least, static_cast<double>(layer(with, "R")[i]) /
                                                static_cast<double>(layer(without, "R")[i]));
            }
            return least;
        };
        EXPECT_LT(left(42.0F), 0.6) << periodic;  // of the chest, 1.15 m high
        EXPECT_NEAR(left(38.0F), 1.0, 1e-6) << periodic;
        EXPECT_NEAR(left(44.0F), 1.0, 1e-6) << periodic;  // the hat's ends at 43.2 m
    }
}

TEST(Persons, AreHiddenByWhatStandsBeforeThem) {
    for (const bool periodic : {false, true}) {
        View view = small_view(120, 90);
        view.look.exaggeration = {"", 1.0};
        view.camera.at = {40.0, 20.0, 1.6};
        view.camera.look_at = {40.0, 40.0, 1.0};
        View with = view;
        with.persons.resize(1);
        with.persons[0].at = {40.0, 40.0};
        Snapshot bed = in_metres(wavy_bed(40, 30), periodic);
        const auto ridge = [&](double height) {  // across the view, ten metres before them
            bed.bed = Grid(40, 30, 3.0);
            for (int x = 0; x < 40; ++x) bed.bed(x, 15) = height;
        };
        ridge(4.0);  // half a metre over the plain
        EXPECT_FALSE(picture(with, bed).rgb == picture(view, bed).rgb) << periodic;
        ridge(13.0);
        EXPECT_TRUE(picture(with, bed).rgb == picture(view, bed).rgb) << periodic;
    }
}

TEST(Persons, StandWhereTheyShowAScale) {
    Snapshot bed = in_metres(wavy_bed(40, 30), false);
    View view = small_view();
    view.look.exaggeration = {"", 1.0};
    view.persons.resize(1);
    const auto fault = [&](const Snapshot& first) {
        try {
            picture(view, first);
        } catch (const KeyError& error) {
            return error.key() + ": " + error.what();
        }
        return std::string();
    };
    EXPECT_NE(fault(bed).find("person.0.at is two numbers"), std::string::npos) << fault(bed);
    view.persons[0].at = {90.0, 10.0};
    EXPECT_NE(fault(bed).find("is outside the bed, which is 80 x 60 m"), std::string::npos);
    view.persons[0].at = {30.0, 10.0};
    EXPECT_EQ(fault(bed), "");
    EXPECT_NE(fault(wavy_bed(40, 30)).find("this bed is not in metres"), std::string::npos);
    view.look.exaggeration = {"", 2.0};
    EXPECT_NE(fault(bed).find("heights are exaggerated 2 times"), std::string::npos);
    bed.scale.dx = bed.scale.dy = 0.01;
    view.look.exaggeration = {"", 1.0};
    EXPECT_NE(fault(bed).find("is 1.75 m tall, and this bed is 0.4 m long"), std::string::npos);
}

}  // namespace
}  // namespace fumon
