// Pictures of a dry block, whose samples fumon finds itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "render/renderer.h"
#include "support/drawn_picture.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

/// The same picture where Mesa draws each sample, as it does for 16 bits.
Image picture_of_samples(const View& view, const Snapshot& snapshot) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    return Renderer(*context, view, snapshot, 100, pool, {}, PixelFormat::display_16)
        .render(snapshot);
}

TEST(BlockPicture, PixelsColouredAsWholesAreWhatTheirSamplesSee) {
    View view = small_view(600, 400);
    const Snapshot bed = wavy_bed(120, 90);
    const Image wholes = picture(view, bed);
    view.image.supersampling = 4;
    const Image samples = picture(view, bed);
    double sum = 0.0;
    int far_off = 0;
    for (std::size_t i = 0; i < wholes.rgb.size(); ++i) {
        const int off = static_cast<int>(wholes.rgb[i]) - static_cast<int>(samples.rgb[i]);
        sum += off;
        if (std::abs(off) > 16) ++far_off;
    }
    EXPECT_NEAR(sum / static_cast<double>(wholes.rgb.size()), 0.0, 0.05);
    EXPECT_LE(far_off, 300);  // where an edge passes between four samples otherwise than sixteen
}

/// Sides that are seen from their edge, or nearly, cover no pixel's middle where they are seen:
/// they have the colours that each of their samples gets in a picture of 16 bits, which Mesa draws.
TEST(BlockPicture, SidesSeenFromTheirEdgeHaveTheirColours) {
    const Snapshot bed = wavy_bed(60, 60);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const double azimuth : {180.0, 181.0, 195.0, 269.5}) {
            View view = small_view(333, 187);
            view.look.ground = Ground::table;
            view.camera.projection = projection;
            view.camera.azimuth = azimuth;
            const Image image = picture(view, bed);
            const Image by_samples = picture_of_samples(view, bed);
            int far_off = 0;  // where a sliver of a side just takes a sample, or just not
            for (std::size_t i = 0; i < image.rgb.size(); ++i)
                if (std::abs(image.rgb[i] - by_samples.rgb[i]) > 12) ++far_off;
            EXPECT_LE(far_off, 100) << azimuth;
        }
    }
}

/// Near enough that corners of the block lie behind the camera: drawn sample by sample.
TEST(BlockPicture, IsSeenFromWithin) {
    const Snapshot bed = wavy_bed(120, 90);
    View view = small_view();
    view.look.ground = Ground::table;
    view.camera.at = {60.0, 45.0, 4.0};
    const Image image = picture(view, bed);
    const auto [low, high] = std::minmax_element(image.rgb.begin(), image.rgb.end());
    EXPECT_GT(*high - *low, 60);
    EXPECT_EQ(picture(view, bed, 3), image);
}

/// Each sample of the surface and the sides gets a colour, up to where two of them meet.
TEST(BlockPicture, HasNoHoles) {
    const std::array<std::uint8_t, 3> white{255, 255, 255};
    Snapshot flat;
    flat.bed = Grid(40, 30, 1.0);
    for (const int width : {48, 333}) {
        for (const int factor : {1, 2}) {
            for (const double azimuth : {215.0, 40.0}) {
                View view = small_view(width, 3 * width / 4);
                view.image.supersampling = factor;
                view.look.mode = ViewMode::figure;
                view.camera.azimuth = azimuth;
                const Image image = picture(view, flat);
                int rows_drawn = 0;
                for (int y = 0; y < image.height; ++y) {
                    const auto is_drawn = [&](int x) {
                        return !std::equal(white.begin(), white.end(),
                                           image.row(y) + 3 * static_cast<std::size_t>(x));
                    };
                    int pieces = 0;
                    for (int x = 0; x < image.width; ++x)
                        if (is_drawn(x) && (x == 0 || !is_drawn(x - 1))) ++pieces;
                    EXPECT_LE(pieces, 1) << "row " << y << " of " << width << " wide";
                    rows_drawn += pieces;
                }
                EXPECT_GT(rows_drawn, image.height / 3);
            }
        }
    }
}

}  // namespace
}  // namespace fumon
