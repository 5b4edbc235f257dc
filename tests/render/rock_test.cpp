#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/snapshot.h"
#include "support/drawn_picture.h"
#include "support/water_beds.h"

namespace fumon {
namespace {

/// A wall of bare rock, 16 m high, that faces west and falls by 2 to 1, and what stands before it.
Snapshot wall() {
    Snapshot bed;
    bed.bed = Grid(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            bed.bed(x, y) = std::clamp(2.0 * (x - 20), 0.0, 16.0) * (x < 50 ? 1.0 : 0.0);
    }
    bed.scale = {1.0, 1.0, 1.0, true, {}};
    bed.periodic = true;
    bed.fields = {{"sand", "", "m", Grid(64, 64, 0.0)}};
    return bed;
}

View from(std::vector<double> at, std::vector<double> look_at) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.mark = Marking::ground;
    view.look.exaggeration = {"", 1.0};
    view.camera.at = std::move(at);
    view.camera.look_at = std::move(look_at);
    return view;
}

/// Of means along one way over a part of the picture, what they differ by from one to the next.
double steps_between(const Image& image, bool of_rows) {
    constexpr int left = 110;
    constexpr int top = 110;
    constexpr int side = 60;
    double sum = 0.0;
    double before = 0.0;
    for (int line = 0; line < side; ++line) {
        double mean = 0.0;
        for (int i = 0; i < side; ++i) {
            const int x = left + (of_rows ? i : line);
            const int y = top + (of_rows ? line : i);
            mean += image.row(y)[3 * x + 1] / static_cast<double>(side);
        }
        if (line > 0) sum += std::abs(mean - before);
        before = mean;
    }
    return sum / (side - 1);
}

// Texture laid out over the plan would be drawn out down the wall, and its columns would differ the
// most.
TEST(Rock, LiesInBedsOnAWall) {
    View view = from({2.0, 32.0, 9.0}, {24.0, 32.0, 8.0});
    view.sun.azimuth = 250.0;
    view.sun.elevation = 35.0;
    const Image image = picture(view, wall());
    EXPECT_GT(steps_between(image, true), 2.0 * steps_between(image, false));
    EXPECT_GT(steps_between(image, true), 1.0);
}

// A survey says nothing of beds.
TEST(Rock, HasNoBedsOnSurveyedMountainsUnlessAsked) {
    View view = from({20.0, 320.0, 90.0}, {240.0, 320.0, 80.0});
    view.sun.azimuth = 250.0;
    view.sun.elevation = 35.0;
    view.look.mark = Marking::none;
    Snapshot mountain = wall();
    for (double& height : mountain.bed.values()) height *= 40.0;
    mountain.scale.dx = mountain.scale.dy = 10.0;
    mountain.periodic = false;
    mountain.fields.clear();
    mountain.landform = Landform::terrain;
    const Image bare = picture(view, mountain);
    view.look.strata = true;
    const Image bedded = picture(view, mountain);
    EXPECT_GT(steps_between(bedded, true), 1.5 * steps_between(bare, true));
}

// The ratio by which rough ground throws light back grows without bound as sun and eye come along
// it.
TEST(Rock, DoesNotSparkleInASunAlongIt) {
    View view = from({14.0, 2.0, 9.0}, {24.0, 40.0, 8.0});
    view.sun.azimuth = 188.0;
    view.sun.elevation = 20.0;
    const Image image = picture(view, wall());
    double sum = 0.0;
    int brightest = 0;
    for (int y = 110; y < 180; ++y) {
        for (int x = 180; x < 320; ++x) {
            const int green = image.row(y)[3 * static_cast<std::size_t>(x) + 1];
            sum += green;
            brightest = std::max(brightest, green);
        }
    }
    EXPECT_LT(brightest, 1.55 * sum / (70.0 * 140.0));
}

/// A table of rock, 12 m high, one of whose walls runs oblique to the cells by 20 degrees through
/// (40, 40) and faces south, and a floor before it. `block`: a rock at (28, 20) that is 9 m high.
Snapshot table(bool block) {
    Snapshot bed;
    bed.bed = Grid(96, 96);
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) {
            const double across = 0.940 * (y - 40) - 0.342 * (x - 40);
            const bool on_block = block && x > 15 && x < 40 && std::abs(y - 20) < 3;
            const bool inside = x > 6 && x < 90;
            bed.bed(x, y) = inside && across > 0.3 && across < 30.0 ? 12.0 : on_block ? 9.0 : 0.0;
        }
    }
    bed.scale = {1.0, 1.0, 1.0, true, {}};
    bed.periodic = true;
    bed.fields = {{"sand", "", "m", Grid(96, 96, 0.0)}};
    return bed;
}

/// How far rows found in columns of a picture stray from the straight line that fits them best.
double strays_from_line(const std::vector<double>& rows) {
    const auto count = static_cast<double>(rows.size());
    double mean = 0.0;
    double lean = 0.0;
    double spread = 0.0;
    for (const double row : rows) mean += row / count;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double along = static_cast<double>(i) - 0.5 * (count - 1.0);
        lean += along * rows[i];
        spread += along * along;
    }
    double most = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double along = static_cast<double>(i) - 0.5 * (count - 1.0);
        most = std::max(most, std::abs(rows[i] - mean - lean / spread * along));
    }
    return most;
}

/// In each of some columns the first row, between two, at which a measure of pixels is above 0.
template <class Measure>
std::vector<double> rows_above(const Image& image, int first, int last, int from,
                               const Measure& measure) {
    std::vector<double> rows;
    for (int x = first; x < last; ++x) {
        const auto of = [&](int y) {
            return static_cast<double>(measure(image.row(y) + 3 * static_cast<std::size_t>(x)));
        };
        int y = from;
        while (y + 1 < image.height && of(y) <= 0.0) ++y;
        rows.push_back(y - of(y) / (of(y) - of(y - 1)));
    }
    return rows;
}

// The cells know on which side of a wall they lie, and no more.
TEST(Rock, HasAStraightRimWhereItRunsObliqueToTheCells) {
    View view = from({40.0, 2.0, 4.0}, {40.0, 40.0, 11.0});
    view.sun.azimuth = 150.0;
    view.sun.elevation = 40.0;
    const Image image = picture(view, table(false));
    const auto not_sky = [](const std::uint8_t* pixel) { return pixel[0] - pixel[2]; };
    EXPECT_LT(strays_from_line(rows_above(image, 20, 300, 5, not_sky)), 0.8);
}

TEST(Rock, HasNoTeethInTheEdgeOfAShadowThatClimbsIt) {
    View view = from({52.0, 6.0, 9.0}, {34.0, 38.0, 5.0});
    view.sun.azimuth = 190.0;
    view.sun.elevation = 12.0;
    const Image image = picture(view, table(true));
    const auto in_shadow = [](const std::uint8_t* pixel) { return 85 - pixel[1]; };
    EXPECT_LT(strays_from_line(rows_above(image, 120, 230, 90, in_shadow)), 2.4);
}

/// Ridges of 40 m across the sun's way.
Snapshot covered_ridges(double height = 20.0) {
    Snapshot land;
    land.landform = Landform::terrain;
    land.bed = Grid(24, 24);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) land.bed(x, y) = height * std::sin(0.8 * x) + 0.5 * y;
    land.scale.dx = land.scale.dy = 10.0;
    land.scale.in_metres = true;
    return land;
}

/// Blue over red of the darkest tenth of what lies below the horizon.
double blueness_of_shade(const Image& image) {
    std::vector<std::array<int, 3>> pixels;
    for (int y = image.height / 2; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto* pixel = &image.row(y)[3 * static_cast<std::ptrdiff_t>(x)];
            pixels.push_back({pixel[0] + pixel[1] + pixel[2], pixel[0], pixel[2]});
        }
    }
    std::ranges::sort(pixels);
    double red = 0.0;
    double blue = 0.0;
    for (std::size_t i = 0; i < pixels.size() / 10; ++i) {
        red += pixels[i][1];
        blue += pixels[i][2];
    }
    return blue / red;
}

/// Of ridges with land cover, the sun along their slopes.
View view_of_cover(double sun_elevation) {
    View view = small_view(96, 54);
    view.image.supersampling = 1;
    view.look.ground = Ground::endless;
    view.look.cover = LandCover::automatic;
    view.look.exaggeration = {"", 1.0};
    view.sun.azimuth = 270.0;
    view.sun.elevation = sun_elevation;
    view.camera.azimuth = 160.0;
    return view;
}

TEST(CoveredLand, IsNotBlueInShade) {
    EXPECT_LT(blueness_of_shade(picture(view_of_cover(20.0), covered_ridges())), 1.1);
}

// Its rills that turn away from a sun along the slope see those across, not the sky alone.
TEST(CoveredLand, UnderAFilmOfRainHasNoBlueRills) {
    Snapshot land = covered_ridges(7.0);
    add_field(land, "water_depth", Grid(24, 24, 1e-4));
    add_field(land, "velocity_x", Grid(24, 24));
    add_field(land, "velocity_y", Grid(24, 24));
    EXPECT_LT(blueness_of_shade(picture(view_of_cover(30.0), land)), 0.97);
}

}  // namespace
}  // namespace fumon
