#include "render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/view/tiles.h"
#include "scene/placed_sun.h"
#include "support/drawn_picture.h"
#include "support/missing_library.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

struct Difference {
    double share = 0.0;       // of the values that differ
    int beyond_rounding = 0;  // values more than two levels apart
};

Difference difference(const Image& a, const Image& b) {
    Difference result;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const int here = std::abs(static_cast<int>(a.rgb[i]) - static_cast<int>(b.rgb[i]));
        if (here > 2) ++result.beyond_rounding;
        if (here != 0) result.share += 1.0 / static_cast<double>(a.rgb.size());
    }
    return result;
}

std::array<double, 3> mean_colour(const Image& image) {
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < image.rgb.size(); ++i) sum[i % 3] += image.rgb[i];
    for (double& channel : sum) channel *= 3.0 / static_cast<double>(image.rgb.size());
    return sum;
}

TEST(Renderer, GivesTheSamePixelsForAnyNumberOfThreads) {
    const Snapshot bed = wavy_bed(120, 90);
    const Image expected = picture(small_view(), bed, 1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(picture(small_view(), bed, threads), expected);
    for (const char* raster_threads : {"0", "1", "2", "8"}) {
        setenv("LP_NUM_THREADS", raster_threads, 1);
        EXPECT_EQ(picture(small_view(), bed), expected) << raster_threads;
    }
    unsetenv("LP_NUM_THREADS");
}

TEST(Renderer, GivesTheSamePixelsAgainAndAfterAnotherPicture) {
    const Snapshot bed = wavy_bed(450, 450);  // coarse enough a mesh to be built anew
    Snapshot other = bed;
    for (double& height : other.bed.values()) height *= 0.1;
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    for (const double turn : {0.0, 90.0}) {
        View view = small_view();
        view.camera.turn = turn;
        Renderer renderer(*context, view, bed, 100, pool);
        const Image expected = renderer.render(bed);
        EXPECT_EQ(renderer.render(bed), expected);
        other.step = 60;
        EXPECT_NE(renderer.render(other), expected);
        EXPECT_EQ(renderer.render(bed), expected);
    }
}

/// The surroundings of a picture that is the only one are drawn where the block leaves them alone,
/// those of several as a whole: with and without the horizon, in the night, and seen from above.
TEST(Renderer, DrawsOnePictureAsItDrawsSeveral) {
    const Snapshot bed = wavy_bed(120, 90);
    RenderLimits one;
    one.one_picture = true;
    for (const double elevation : {4.0, 32.0, 80.0}) {
        for (const double sun : {-8.0, 2.0, 30.0}) {
            View view = small_view();
            view.camera.elevation = elevation;
            view.sun.elevation = sun;
            const Image expected = pictures(view, {bed, bed}).back();
            EXPECT_EQ(picture(view, bed, 2, gl::Backend::automatic, one), expected)
                << elevation << ' ' << sun;
        }
    }
}

TEST(Renderer, GivesTheSamePixelsByOsmesaAndByEgl) {
    for (const gl::Backend backend : {gl::Backend::osmesa, gl::Backend::egl}) {
        try {
            gl::Context::create(backend);
        } catch (const Error& error) {
            if (!test::library_is_missing(error.what())) throw;
            GTEST_SKIP() << error.what();
        }
    }
    const Snapshot bed = wavy_bed(120, 90);
    EXPECT_EQ(picture(small_view(), bed, 2, gl::Backend::egl),
              picture(small_view(), bed, 2, gl::Backend::osmesa));
}

TEST(Renderer, AStillIsTheRunsFrame) {
    const Snapshot first = wavy_bed(60, 60);
    Snapshot later = first;
    later.step = 40;
    for (double& height : later.bed.values()) height = 2.0 * height - 1.0;
    View view = small_view();
    view.camera.turn = 50.0;
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer run(*context, view, first, 100, pool);
    run.render(first);
    const Image frame = run.render(later);
    Renderer still(*context, view, first, 100, pool);
    EXPECT_EQ(still.render(later), frame);
}

/// The light of every frame is its own, whichever frames came before it.
TEST(Renderer, AStillIsTheRunsFrameWhereTheSunWanders) {
    for (const Ground ground : {Ground::table, Ground::endless}) {
        const Snapshot first = wavy_bed(60, 60);
        Snapshot later = first;
        later.step = 40;
        Snapshot last = first;
        last.step = 100;
        View view = small_view();
        view.look.ground = ground;
        view.look.light = LightKind::sun;
        view.sun.place = {23.0, 5.0};
        view.sun.time = "2026-03-20T06:40Z";
        view.sun.hours = 5.0;
        place_sun(view.sun);
        const auto context = gl::Context::create(gl::Backend::automatic);
        WorkerPool pool(2);
        Renderer run(*context, view, first, 100, pool);
        const Image morning = run.render(first);
        const Image frame = run.render(later);
        const Image noon = run.render(last);
        EXPECT_NE(morning, frame);
        EXPECT_NE(frame, noon);
        EXPECT_EQ(run.render(first), morning);
        Renderer still(*context, view, first, 100, pool);
        EXPECT_EQ(still.render(later), frame);
        // As if it stood there.
        View standing = view;
        standing.sun = sun_at(view.sun, 0.4);
        standing.sun.place.clear();
        standing.sun.hours = 0.0;
        Renderer other(*context, standing, first, 100, pool);
        EXPECT_EQ(other.render(later), frame);
    }
}

TEST(Renderer, TilesLeaveNoSeams) {
    for (const Snapshot& bed : {wavy_bed(120, 90), masked_bed(70, 90)}) {
        for (const int factor : {1, 2}) {
            View view = small_view(797, 611);  // large enough for shading at full detail
            view.image.supersampling = factor;
            const Image whole = picture(view, bed);
            const Image tiled = picture(view, bed, 2, gl::Backend::automatic, {512});
            const Difference seen = difference(whole, tiled);
            // OpenGL rounds interpolated places differently with the tile's offset, so single edge
            // pixels may differ; a seam would be a whole row of them.
            EXPECT_LE(seen.share, 0.001);
            EXPECT_LE(seen.beyond_rounding, 20);
        }
    }
}

/// One look at the bed for a pixel shows what sixteen samples do: no speck along an edge, and the
/// same light.
TEST(Tiles, CoverThePictureOnce) {
    for (const int factor : {1, 2, 4}) {
        const TilePlan plan = plan_tiles(1001, 777, factor, 600);
        Field<int> seen(1001, 777, 0);
        for (const Tile& tile : plan.tiles) {
            EXPECT_LE(tile.width * factor + 2 * plan.margin, plan.target_width);
            EXPECT_LE(plan.target_width, 600);
            for (int y = tile.y; y < tile.y + tile.height; ++y)
                for (int x = tile.x; x < tile.x + tile.width; ++x) ++seen(x, y);
        }
        EXPECT_EQ(std::count(seen.values().begin(), seen.values().end(), 1), 1001 * 777);
    }
}

/// Every two of size, projection and factor meet once.
TEST(Renderer, DrawsEverySizeAndProjection) {
    const Snapshot bed = wavy_bed(40, 30);
    constexpr std::array<std::pair<int, int>, 4> sizes{{{16, 16}, {17, 33}, {201, 16}, {97, 131}}};
    constexpr std::array projections{Projection::perspective, Projection::orthographic,
                                     Projection::map};
    constexpr std::array factors{1, 2, 4};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const auto [width, height] = sizes[i];
        for (std::size_t j = 0; j < projections.size(); ++j) {
            View view = small_view(width, height);
            view.camera.projection = projections[j];
            view.image.supersampling = factors[(i + j) % factors.size()];
            const Image image = picture(view, bed);
            EXPECT_EQ(image.width, width);
            EXPECT_EQ(image.height, height);
            const auto [low, high] = std::minmax_element(image.rgb.begin(), image.rgb.end());
            EXPECT_GT(*high - *low, 20);
        }
    }
}

struct PixelRectangle {
    int left, top, right, bottom;  // right and bottom lie beyond it
};

/// Around all that is not the figure's white paper.
PixelRectangle drawn_box(const Image& image) {
    PixelRectangle box{image.width, image.height, 0, 0};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* pixel = image.row(y) + 3 * static_cast<std::size_t>(x);
            if (pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255) continue;
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
                   std::max(box.bottom, y + 1)};
        }
    }
    return box;
}

TEST(Renderer, DrawsNarrowAndTinyBeds) {
    for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 40}, {300, 1}, {2, 3}, {1500, 2}}) {
        View view = small_view(640, 480);
        view.look.mode = ViewMode::figure;
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            view.camera.projection = projection;
            const PixelRectangle box = drawn_box(picture(view, wavy_bed(nx, ny)));
            EXPECT_TRUE(box.left > 0 && box.top > 0 && box.right < 640 && box.bottom < 480)
                << nx << " x " << ny << " is cut off";
            EXPECT_GT(std::max((box.right - box.left) / 640.0, (box.bottom - box.top) / 480.0),
                      0.75)
                << nx << " x " << ny << " does not fill the picture";
        }
        view.camera.projection = Projection::map;
        view.camera.margin = 0.0;
        const double deep = nx > 1 && ny == 1 ? 0.25 * nx : ny;  // a profile becomes a strip
        const double site = std::min(640.0 / nx, 480.0 / deep);
        const PixelRectangle box = drawn_box(picture(view, wavy_bed(nx, ny)));
        EXPECT_NEAR(box.right - box.left, nx * site, 2.0) << nx << " x " << ny;
        EXPECT_NEAR(box.bottom - box.top, deep * site, 2.0) << nx << " x " << ny;
        EXPECT_NEAR(0.5 * (box.left + box.right), 320.0, 1.0) << nx << " x " << ny;
        EXPECT_NEAR(0.5 * (box.top + box.bottom), 240.0, 1.0) << nx << " x " << ny;
    }
}

TEST(Renderer, LeavesCellsWithoutDataOut) {
    View view = small_view(200, 200);
    view.camera.projection = Projection::map;
    view.camera.margin = 0.0;
    view.look.mode = ViewMode::figure;
    const Image image = picture(view, masked_bed(100, 100));
    const std::array<int, 3> white{255, 255, 255};
    EXPECT_EQ(colour_at(image, 0.02, 0.02), white);
    EXPECT_EQ(colour_at(image, 0.98, 0.98), white);
    EXPECT_NE(colour_at(image, 0.5, 0.5), white);
}

TEST(Renderer, ColoursRunUpToTheRimOfAMaskedBed) {
    Snapshot bed;
    bed.bed = Grid(30, 30, 0.0);
    bed.nodata = Mask(30, 30, 1);
    for (int y = 8; y < 22; ++y) {
        for (int x = 8; x < 22; ++x) {
            bed.bed(x, y) = 1000.0;  // far from the zeros where nothing is known
            bed.nodata(x, y) = 0;
        }
    }
    View view = small_view(200, 200);
    view.camera.projection = Projection::map;
    view.look.mode = ViewMode::figure;
    view.look.colour_by = Colouring::height;
    view.look.palette = "grey";
    view.look.low = {"", 999.0};
    view.look.high = {"", 1001.0};
    view.sun.elevation = 90.0;
    const Image image = picture(view, bed);
    int dark = 0;
    int grey = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        if (image.rgb[i] < 90) ++dark;
        if (image.rgb[i] >= 90 && image.rgb[i] < 200) ++grey;
    }
    EXPECT_EQ(dark, 0) << "the palette's low end at the rim";
    EXPECT_GT(grey, 1000) << "the middle of the palette inside";
}

TEST(Renderer, AFigureKeepsThePalettesHue) {
    Snapshot flat;
    flat.bed = Grid(50, 50, 1.0);
    View view = small_view(100, 100);
    view.camera.projection = Projection::map;
    view.look.mode = ViewMode::figure;
    view.look.colour_by = Colouring::height;
    view.look.palette = "viridis";
    view.look.low = {"", 0.0};
    view.look.high = {"", 1.0};
    const std::array<int, 3> top = colour_at(picture(view, flat), 0.5, 0.5);
    EXPECT_NEAR(top[0], 253, 2);  // level ground in full light shows the colour itself
    EXPECT_NEAR(top[1], 231, 2);
    EXPECT_NEAR(top[2], 37, 2);
}

TEST(Renderer, NorthIsUpOnAMapAndWestIsLeft) {
    Snapshot bed;
    bed.bed = Grid(60, 60, 0.0);
    for (int y = 40; y < 60; ++y)
        for (int x = 0; x < 20; ++x) bed.bed(x, y) = 1.0;  // the north-western corner
    View view = small_view(90, 90);
    view.camera.projection = Projection::map;
    view.look.mode = ViewMode::figure;
    view.look.colour_by = Colouring::height;
    view.look.palette = "grey";
    const Image image = picture(view, bed);
    EXPECT_GT(colour_at(image, 0.2, 0.2)[0], 200);
    EXPECT_LT(colour_at(image, 0.8, 0.2)[0], 60);
    EXPECT_LT(colour_at(image, 0.2, 0.8)[0], 60);
    EXPECT_LT(colour_at(image, 0.8, 0.8)[0], 60);
}

TEST(Renderer, RefusesAnUnknownPalette) {
    View view = small_view();
    view.look.palette = "sandy";
    EXPECT_THROW(picture(view, wavy_bed(20, 20)), InputError);
}

TEST(Renderer, RefusesASnapshotOfAnotherSize) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(1);
    Renderer renderer(*context, small_view(), wavy_bed(20, 20), 1, pool);
    EXPECT_THROW(renderer.render(wavy_bed(21, 20)), Error);
}

TEST(Renderer, DrawsTheLargestPicture) {
#ifdef FUMON_SANITIZED
    constexpr int side = 4608;  // four tiles; the largest would take a minute
#else
    constexpr int side = 8192;
#endif
    View view = small_view(side, side);
    view.image.supersampling = 1;
    const Image image = picture(view, wavy_bed(64, 64));
    EXPECT_EQ(image.rgb.size(), std::size_t{3} * side * side);
    const std::array<double, 3> large_mean = mean_colour(image);
    const std::array<double, 3> small_mean =
        mean_colour(picture(small_view(512, 512), wavy_bed(64, 64)));
    for (std::size_t i = 0; i < 3; ++i)  // the same scene at another size
        EXPECT_NEAR(large_mean[i], small_mean[i], 1.5);
}

TEST(Renderer, ATransparentBackgroundLeavesTheBlockWithoutAFringe) {
    const Snapshot bed = wavy_bed(40, 30);
    View view = small_view();
    view.look.ground = Ground::table;
    const Image on_table = picture(view, bed);
    view.look.background = Background::transparent;
    const Image open = picture(view, bed);
    ASSERT_EQ(open.alpha.size(), open.rgb.size() / 3);
    std::size_t partly = 0;
    int darkest_edge = 255;
    int darkest_inside = 255;
    for (std::size_t i = 0; i < open.alpha.size(); ++i) {
        if (open.alpha[i] == 255) {
            darkest_inside = std::min<int>(darkest_inside, open.rgb[3 * i]);
            EXPECT_EQ(open.rgb[3 * i], on_table.rgb[3 * i]) << i;
        } else {
            if (open.alpha[i] != 0) ++partly;
            darkest_edge = std::min<int>(darkest_edge, open.rgb[3 * i]);
        }
    }
    EXPECT_EQ(open.alpha.front(), 0);
    EXPECT_GT(partly, 20U);
    EXPECT_GE(darkest_edge, darkest_inside - 3) << "colours outside are those of the block";
    for (const int threads : {1, 3}) EXPECT_EQ(picture(view, bed, threads), open);
    view.look.ground = Ground::endless;
    EXPECT_THROW(picture(view, bed), InputError);
}

}  // namespace
}  // namespace fumon
