#include "render/world/world_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "picture/tile_similarity.h"
#include "render/view/repeated_bed.h"
#include "support/drawn_picture.h"
#include "support/photograph.h"
#include "support/repeated_dunes.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

View standing_view(double east, double north) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.exaggeration = {"", 1.0};
    view.camera.at = {200.0 + east, 150.0 + north, 6.0};
    view.camera.look_at = {260.0 + east, 220.0 + north, 0.0};
    return view;
}

/// Without what stays where it is where a bed is shifted.
View bare(View view) {
    view.look.grain = 0.0;
    view.look.ripples = 0.0;
    return view;
}

/// Values of a picture that are not as expected where a bed is shifted with the camera, and by how
/// many levels the most.
std::pair<std::size_t, int> changed_by_shift(const Image& expected, View view, const Snapshot& bed,
                                             int east, int north) {
    Snapshot moved = bed;
    moved.bed = rolled(bed.bed, -east, -north);
    for (std::vector<double>* position : {&view.camera.at, &view.camera.look_at}) {
        (*position)[0] += east * bed.scale.dx;
        (*position)[1] += north * bed.scale.dy;
    }
    const Image shifted = picture(view, moved);
    std::size_t changed = 0;
    int most = 0;
    for (std::size_t i = 0; i < expected.rgb.size(); ++i) {
        const int apart = std::abs(int{expected.rgb[i]} - int{shifted.rgb[i]});
        changed += apart > 0 ? 1 : 0;
        most = std::max(most, apart);
    }
    return {changed, most};
}

// Where somebody stands, all samples are coloured where they lie; without, those of edges side by
// side.
TEST(WorldLayer, EdgesAreTheSameSideBySideAndAmongAllSamples) {
    for (const int factor : {2, 3}) {
        View view = standing_view(0.0, 0.0);
        view.image.supersampling = factor;
        Snapshot bed = repeated_dunes(420, 400);
        bed.scale.in_metres = true;
        const Image side_by_side = picture(view, bed);
        view.persons.push_back({.at = {100.0, 100.0}});  // behind the camera
        EXPECT_TRUE(picture(view, bed).rgb == side_by_side.rgb) << factor;
    }
}

TEST(WorldLayer, ABedShiftedWithTheCameraLooksTheSame) {
    const std::pair<std::size_t, int> none{0, 0};
    const View high = bare(standing_view(0, 0));
    const Snapshot wide = repeated_dunes(420, 400);
    EXPECT_EQ(changed_by_shift(picture(high, wide), high, wide, 37, 290), none);
    View low = high;
    low.image.width = 160;
    low.image.height = 90;
    low.sun.elevation = 3.0;
    low.sun.azimuth = 70.0;
    Snapshot narrow = repeated_dunes(150, 211);
    narrow.winds = {{0.6, 0.8, 1.0}};
    narrow.scale.dx = 0.7;
    narrow.scale.height_unit = 0.3;  // no slip faces, whose tongues stay where they are
    const Image expected = picture(low, narrow);
    for (const auto& [east, north] : {std::pair(1, 0), {0, 17}, {-33, 250}})
        EXPECT_EQ(changed_by_shift(expected, low, narrow, east, north), none)
            << east << ' ' << north;
}

/// What is far away takes its ground from other places than the bed's own repetition would, by
/// where the first picture's camera stands: a picture is the same whether others were drawn before
/// it.
TEST(WorldLayer, FarCopiesAreUnlikeEachOtherAndStayWhereTheyAre) {
    View view = standing_view(0, 0);
    view.image.width = 160;
    view.image.height = 90;
    view.camera.at.clear();
    view.camera.look_at.clear();
    view.camera.elevation = 6.0;
    view.camera.turn = 120.0;
    const Snapshot bed = repeated_dunes(60, 50);
    Snapshot later = repeated_dunes(60, 50, 2, 1);
    later.step = 50;
    const std::vector<Image> drawn = pictures(view, {bed, later});
    {
        const auto context = gl::Context::create(gl::Backend::automatic);
        WorkerPool pool(2);
        Renderer resumed(*context, view, bed, 100, pool);
        EXPECT_EQ(drawn[1], resumed.render(later));
    }
    view.look.far_copies = FarGround::alike;
    const Image alike = picture(view, bed);
    const auto differing = [&](int from, int to) {  // of the rows between
        int count = 0;
        for (int y = from; y < to; ++y)
            count += std::equal(alike.row(y), alike.row(y) + 3 * 160, drawn[0].row(y)) ? 0 : 1;
        return count;
    };
    EXPECT_GT(differing(0, 90), 20);
    view.camera.elevation = 89.0;
    view.camera.turn = 0.0;
    const Image from_above = picture(view, bed);
    view.look.far_copies = FarGround::varied;
    EXPECT_EQ(colour_at(picture(view, bed), 0.5, 0.5), colour_at(from_above, 0.5, 0.5));
}

/// Across the crests, the sun low at one side.
View golden_hour() {
    View view = standing_view(0, 0);
    view.sun.elevation = 9.0;
    view.sun.azimuth = 75.0;
    view.camera.at = {200.0, 150.0, 12.0};
    view.camera.look_at = {260.0, 220.0, 3.0};
    return view;
}

TEST(WorldLayer, ShadowsOfAGoldenHourAreTheSkys) {
    View view = golden_hour();
    view.sun.azimuth = 100.0;  // aside: haze veils what stands before a low sun
    const Image image = picture(view, repeated_dunes(420, 400));
    const auto [shadow, light] = photograph::light_and_shadow(image);
    EXPECT_LE(shadow.saturation, 0.6 * light.saturation);
    EXPECT_GT(light.degrees, 20.0) << "sand";
    EXPECT_LT(light.degrees, 45.0);
    EXPECT_GE(photograph::lightness_span(image), 50.0);
    EXPECT_LT(photograph::share_at_ends(image), 0.001);
}

/// Toward the sun the sky is bright, but for the disc and what is close to it not burnt out.
TEST(WorldLayer, TowardALowSunTheSkyIsNotBurntOut) {
    View view = golden_hour();
    view.camera.look_at = {260.0, 220.0, 17.0};
    for (const double azimuth : {40.6, 55.0}) {  // in the middle, and aside
        view.sun.azimuth = azimuth;
        const Image image = picture(view, repeated_dunes(420, 400));
        EXPECT_LT(photograph::share_at_ends(image), 0.001) << azimuth;
        EXPECT_GE(photograph::lightness_span(image), 50.0) << azimuth;
    }
}

TEST(WorldLayer, ALowSunGetsMoreContrastAndLessLight) {
    View view = golden_hour();
    view.image.width = 64;
    view.image.height = 36;
    const Snapshot bed = repeated_dunes(60, 50);
    const auto developed = [&](double contrast, double stops) {
        View other = view;
        other.look.contrast = {"", contrast};
        other.look.exposure = stops;
        return picture(other, bed);
    };
    const Image with_toe = picture(view, bed);
    view.look.contrast.word = "auto-0.2";
    EXPECT_EQ(picture(view, bed), developed(1.8, -0.5));
    const Image without_toe = picture(view, bed);
    int brighter = 0;
    for (std::size_t i = 0; i < with_toe.rgb.size(); i += 3) {
        int more = 0;
        for (std::size_t band = i; band < i + 3; ++band)
            more += with_toe.rgb[band] - without_toe.rgb[band];
        EXPECT_GE(more, -3) << i;
        brighter += more > 9 ? 1 : 0;
    }
    EXPECT_GT(brighter, 0) << "in shade";
    view.sun.elevation = 40.0;
    EXPECT_EQ(picture(view, bed), developed(1.35, 0.0));
    view.sun.elevation = 9.0;
    view.sun.source = LightSource::moon;
    view.look.contrast.word = "auto";
    EXPECT_EQ(picture(view, bed), developed(1.35, 0.0));
}

TEST(WorldLayer, LowLevelGroundIsGreyerThanSand) {
    const Snapshot bed = repeated_dunes(420, 400);
    const auto saturation_over = [&](std::size_t site) {
        const double x = static_cast<double>(site % 420) + 0.5;
        const double y = static_cast<double>(site / 420) + 0.5;
        View view = standing_view(0, 0);
        view.image.width = 64;
        view.image.height = 36;
        view.sun.elevation = 60.0;
        view.look.ripples = 0.0;
        view.camera.at = {x, y, 4.0};
        view.camera.look_at = {x + 0.5, y, 0.0};
        const auto colour = colour_at(picture(view, bed), 0.5, 0.5);
        return 1.0 - static_cast<double>(colour[2]) / colour[0];
    };
    const auto heights = bed.bed.values();
    const auto lowest = std::ranges::min_element(heights) - heights.begin();
    const auto highest = std::ranges::max_element(heights) - heights.begin();
    EXPECT_LT(saturation_over(static_cast<std::size_t>(lowest)),
              saturation_over(static_cast<std::size_t>(highest)))
        << "sand alone is paler on crests";
}

TEST(WorldLayer, FarGroundMeetsTheSkyWithoutACrease) {
    View view = golden_hour();
    view.air.visibility = 4.0;
    view.image.width = 64;
    view.image.height = 360;
    view.camera.look_at.clear();
    view.camera.elevation = 1.0;
    for (const double azimuth : {75.0, 255.0}) {  // away from the sun and toward it
        view.camera.azimuth = azimuth;
        const Image image = picture(view, repeated_dunes(420, 400));
        const std::vector<double> rows = photograph::rows_of_luminance(image);
        double most = 0.0;
        for (std::size_t row = 120; row < 230; ++row)
            most = std::max(most, std::abs(rows[row + 1] / rows[row] - 1.0));
        EXPECT_LT(most, 0.05) << azimuth;
        if (azimuth == 255.0) continue;  // the sun stands there
        for (std::size_t row = 0; row < 90; row += 10)
            EXPECT_LT(rows[row], rows[row + 10]) << "darkens upward";
    }
}

/// Ground in the haze ends in the very light of the sky above it, in every direction.
TEST(WorldLayer, GroundAndSkyJoinWithinOneLevel) {
    View view = golden_hour();
    view.air.visibility = 0.5;  // of some kilometres to the horizon
    view.image.width = 96;
    view.image.height = 216;
    view.camera.look_at.clear();
    view.camera.elevation = 0.0;
    for (const double azimuth : {30.0, 120.0, 210.0, 300.0}) {
        view.camera.azimuth = azimuth;
        const Image image = picture(view, repeated_dunes(420, 400));
        for (const double x : {0.1, 0.5, 0.9}) {
            const auto above = colour_at(image, x, 0.49);
            const auto below = colour_at(image, x, 0.505);
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(above[channel], below[channel], 1.0) << azimuth << ' ' << x;
        }
    }
}

/// The camera moves on by less than a third of a pixel of the nearest ground: what fine detail
/// makes of that is flicker.
TEST(WorldLayer, DetailDoesNotFlickerInASlowDolly) {
    View view = golden_hour();
    view.camera.at = {200.0, 150.0, 2.0};
    view.camera.look_at = {260.0, 220.0, 0.0};
    const Image before = picture(view, repeated_dunes(420, 400));
    view.camera.at = {200.002, 150.002, 2.0};
    const Image after = picture(view, repeated_dunes(420, 400));
    const TileSimilarity similar = tile_similarity(before, after);
    EXPECT_GE(similar.smallest, 0.98) << similar.x << ' ' << similar.y;
    view.look.ripples = 0.0;
    EXPECT_LT(tile_similarity(before, picture(view, repeated_dunes(420, 400))).smallest, 0.9)
        << "there are ripples";
}

TEST(WorldLayer, RipplesMoveWithTheRun) {
    const Snapshot bed = repeated_dunes(420, 400);
    Snapshot later = bed;
    later.step = 25;
    View view = golden_hour();
    view.camera.at = {200.0, 150.0, 2.0};
    const std::vector<Image> rippled = pictures(view, {bed, later});
    EXPECT_NE(rippled[0], rippled[1]);
    view.look.ripples = 0.0;
    const std::vector<Image> smooth = pictures(view, {bed, later});
    EXPECT_EQ(smooth[0], smooth[1]);
}

TEST(WorldLayer, RipplesStandInBareSandAlone) {
    Snapshot sand = repeated_dunes(420, 400);
    sand.fields = {{"sand", "", "m", Grid(sand.bed.nx(), sand.bed.ny(), 1.0)}};
    Snapshot rock = sand;
    rock.fields = {{"sand", "", "m", Grid(sand.bed.nx(), sand.bed.ny(), 0.0)}};
    View view = golden_hour();
    view.camera.at = {200.0, 150.0, 2.0};
    view.look.mark = Marking::ground;
    const std::vector<Image> rippled = pictures(view, {sand, rock});
    view.look.ripples = 0.0;
    const std::vector<Image> smooth = pictures(view, {sand, rock});
    EXPECT_NE(rippled[0], smooth[0]) << "sand";
    EXPECT_EQ(rippled[1], smooth[1]) << "rock";
}

/// Known visibility takes the place of sun.haze around a block on a table.
TEST(WorldLayer, ABlockInClearAirHasNoHaze) {
    View view = small_view();
    const Snapshot bed = wavy_bed(40, 30);
    view.sun.haze = 0.0;
    const Image bare = picture(view, bed);
    view.sun.haze = 0.9;
    view.air.visibility = 1e5;
    const Image clear = picture(view, bed);
    int most = 0;
    for (std::size_t i = 0; i < bare.rgb.size(); ++i)
        most = std::max(most, std::abs(int{bare.rgb[i]} - int{clear.rgb[i]}));
    EXPECT_LE(most, 1);
    view.air.visibility = 1.0;
    EXPECT_NE(picture(view, bed), clear);
}

TEST(WorldLayer, HazeGrowsWithDistance) {
    View view = golden_hour();
    const auto horizon = [&](double kilometres) {
        view.air.visibility = kilometres;
        const Image image = picture(view, repeated_dunes(420, 400));
        return photograph::lightness_span(image);
    };
    EXPECT_LT(horizon(0.5), horizon(20.0));
}

TEST(WorldLayer, ReachesTheHorizonUnderASkyThatDarkensUpward) {
    View view = standing_view(0, 0);
    view.camera.look_at = {260.0, 220.0, 5.0};
    view.image.height = 240;
    const Image image = picture(view, repeated_dunes(420, 400));
    const auto luminance = [&](double x, double y) {
        const auto colour = colour_at(image, x, y);
        return 0.21 * colour[0] + 0.72 * colour[1] + 0.07 * colour[2];
    };
    for (const double x : {0.1, 0.5, 0.9}) {
        EXPECT_LT(luminance(x, 0.01), luminance(x, 0.25)) << x;
        const auto top = colour_at(image, x, 0.01);
        const auto ground = colour_at(image, x, 0.95);
        EXPECT_GT(top[2], top[0]) << "a blue sky";
        EXPECT_GT(ground[0], ground[2]) << "sand";
    }
}

TEST(WorldLayer, IsTheSameForAnyNumberOfThreads) {
    const Snapshot bed = repeated_dunes(60, 50);
    const Image expected = picture(standing_view(0, 0), bed, 1);
    EXPECT_EQ(picture(standing_view(0, 0), bed, 3), expected);
    for (const char* raster_threads : {"0", "2"}) {
        setenv("LP_NUM_THREADS", raster_threads, 1);
        EXPECT_EQ(picture(standing_view(0, 0), bed), expected) << raster_threads;
    }
    unsetenv("LP_NUM_THREADS");
}

/// What is behind the ground is kept while the camera stands still.
TEST(WorldLayer, TheSkyIsSeenWhereDunesWere) {
    View view = standing_view(0, 0);
    view.image.width = 160;
    view.image.height = 90;
    view.camera.at.clear();  // whose camera would rise and sink with the bed
    view.camera.look_at.clear();
    view.camera.elevation = 1.0;
    const Snapshot bed = repeated_dunes(60, 50);
    const Snapshot moved = repeated_dunes(60, 50, 6, 0);
    const std::vector<Image> drawn = pictures(view, {bed, bed, moved, bed});
    EXPECT_EQ(drawn[1], drawn[0]);
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer fresh(*context, view, bed, 100, pool);
    EXPECT_EQ(drawn[2], fresh.render(moved));
    EXPECT_EQ(drawn[3], drawn[0]);
}

std::string refusal(const View& view, const Snapshot& bed) {
    try {
        picture(view, bed);
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "drawn";
}

TEST(WorldLayer, RefusesWhatCannotGoOn) {
    const View view = standing_view(0, 0);
    EXPECT_EQ(refusal(view, wavy_bed(40, 1)),
              "look.ground = \"endless\" is for beds of more than one row; "
              "\"table\" draws this one");
    const Snapshot dunes = repeated_dunes(40, 30);
    View from_above = view;
    from_above.camera.projection = Projection::map;
    EXPECT_NE(refusal(from_above, dunes).find("perspective camera"), std::string::npos);
    View figure = view;
    figure.look.mode = ViewMode::figure;
    EXPECT_NE(refusal(figure, dunes).find("scenic"), std::string::npos);
}

/// Two cells from the western edge of a bed that ends there.
View view_over_an_edge() {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.exaggeration = {"", 1.0};
    view.camera.at = {30.0, 15.0, 8.0};
    view.camera.look_at = {0.0, 18.0, 2.0};
    return view;
}

double mean_difference(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
    return sum / static_cast<double>(a.rgb.size());
}

TEST(WorldLayer, ABedThatEndsGoesOnAsAPlain) {
    const Snapshot ends = wavy_bed(40, 30);
    Snapshot repeats = ends;
    repeats.periodic = true;
    const View view = view_over_an_edge();
    EXPECT_GT(mean_difference(picture(view, ends), picture(view, repeats)), 0.5);
}

TEST(WorldLayer, ACameraBesideABedStandsOnItsPlain) {
    View view = view_over_an_edge();
    Snapshot masked = masked_bed(40, 30);
    view.camera.at = {1.0, 1.0, 3.0};  // where no cell is, at a height of -9999
    view.camera.look_at = {20.0, 15.0, 2.0};
    const Image image = picture(view, masked);
    // The sky is above, and ground below.
    const auto pixel = [&](int row) {
        return image.rgb.data() +
               3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(image.width) / 2);
    };
    EXPECT_GT(int{pixel(2)[2]}, int{pixel(2)[0]}) << "blue";
    EXPECT_LT(int{pixel(image.height - 3)[2]}, int{pixel(image.height - 3)[0]}) << "sand";
}

}  // namespace
}  // namespace fumon
