// Water where the sides of a block cut through it.

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "support/drawn_picture.h"
#include "support/water_views.h"

namespace fumon {
namespace {

/// Looks north, a little down, at the southern side of a square bed of 100 m.
View side_view() {
    View view = small_view(300, 200);
    view.camera.at = {50, -60, 20};
    view.camera.look_at = {50, 0, 0};
    view.look.ground = Ground::table;
    view.look.exaggeration = {"", 1.0};
    view.look.turbidity = 0.0;
    view.sun.azimuth = 180.0;
    return view;
}

/// How red a part of the picture is: 0 green alone … 1 red alone.
double redness(const Image& image, double left, double right, double top, double bottom) {
    double red = 0.0;
    double green = 0.0;
    for (double y = top; y < bottom; y += 0.01) {
        for (double x = left; x < right; x += 0.01) {
            const auto colour = colour_at(image, x, y);
            red += colour[0];
            green += colour[1];
        }
    }
    return red / (red + green);
}

/// In the middle of the picture: 8 m of water over a flat bed, cut.
double redness_of_cut(double clarity) {
    View view = side_view();
    view.look.water_clarity = {"", clarity};
    const Image image = picture(view, under_water(flat_bed(100, 100), 8.0, 0.0));
    return redness(image, 0.45, 0.55, 0.42, 0.46);
}

TEST(WaterCut, ShowsTheBedBehindItWhereTheWaterIsClear) {
    const double murky = redness_of_cut(1.0);
    const double clear = redness_of_cut(200.0);
    EXPECT_LT(murky, 0.48);          // the water's own green
    EXPECT_GT(clear, murky + 0.04);  // sand
}

/// Heights and water drawn ten times too high take as much light as they do in truth.
TEST(WaterCut, TakesLightByItsTrueDepth) {
    const auto redness_of = [](double depth, double exaggeration) {
        View view = side_view();
        view.look.water_clarity = {"", 4.0 / exaggeration};
        view.look.exaggeration = {"", exaggeration};
        view.camera.at[2] = 20.0 / exaggeration;
        const Image image = picture(view, under_water(flat_bed(100, 100), depth, 0.0));
        return redness(image, 0.45, 0.55, 0.42, 0.46);
    };
    EXPECT_NEAR(redness_of(8.0, 1.0), redness_of(0.8, 10.0), 0.01);
}

/// A film of 1 cm under a low sun, seen aslant.
View film_view(double exaggeration) {
    View view = small_view(400, 200);
    view.camera.projection = Projection::orthographic;
    view.camera.azimuth = 180.0;
    view.camera.elevation = 20.0;
    view.look.ground = Ground::table;
    view.look.grain = 0.0;
    view.look.exaggeration = {"", exaggeration};
    view.look.water_clarity = {"", 0.1};
    view.sun.elevation = 15.0;
    view.sun.azimuth = 290.0;
    return view;
}

int green(const Image& image, int x, int y) {
    return image.row(y)[3 * static_cast<std::size_t>(x) + 1];
}

/// The mean square of the differences of neighbours along rows, in the middle of the picture.
double roughness(const Image& image) {
    double sum = 0.0;
    int count = 0;
    for (int y = 2 * image.height / 5; y < image.height / 2; ++y) {
        for (int x = image.width / 3; x < 2 * image.width / 3; ++x) {
            const double difference = green(image, x + 1, y) - green(image, x, y);
            sum += difference * difference;
            ++count;
        }
    }
    return sum / count;
}

/// The same of the means over rows, which run east.
double eastward_lines(const Image& image) {
    const int left = image.width / 3;
    const int right = 2 * image.width / 3;
    const auto mean = [&](int y) {
        double sum = 0.0;
        for (int x = left; x < right; ++x) sum += green(image, x, y);
        return sum / (right - left);
    };
    double sum = 0.0;
    for (int y = 2 * image.height / 5; y < image.height / 2; ++y) {
        const double difference = mean(y + 1) - mean(y);
        sum += difference * difference;
    }
    return sum;
}

TEST(WaterFilm, IsAsSmoothAsItIsDrawnThick) {
    const Snapshot film = under_water(flat_bed(100, 100), 0.01, 0.0);
    const double thin = roughness(picture(film_view(1.0), film));
    const double thick = roughness(picture(film_view(300.0), film));
    EXPECT_LT(thick, 0.5 * thin);
}

TEST(WaterFilm, HasLinesAlongItsFlow) {
    const auto running = [](double east, double north) {
        Snapshot sheet = under_water(flat_bed(100, 100), 0.01, north);
        for (double& speed : sheet.fields[1].values.values()) speed = east;
        return eastward_lines(picture(film_view(300.0), sheet));
    };
    const double north = running(0.0, 0.6);
    const double east = running(0.6, 0.0);
    EXPECT_GT(east, 2.0 * north);
}

/// The soil below has the same colours where the water ends.
TEST(WaterCut, SoilIsOneBesideTheShore) {
    const Image image = picture(side_view(), half_wet(0.2));
    const auto mean = [&](double left, double right) {
        std::array<double, 3> sum{};
        int count = 0;
        for (double y = 0.58; y < 0.74; y += 0.008) {
            for (double x = left; x < right; x += 0.004, ++count) {
                const auto colour = colour_at(image, x, y);
                for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c];
            }
        }
        for (double& channel : sum) channel /= count;
        return sum;
    };
    const auto wet = mean(0.3, 0.5);
    const auto dry = mean(0.5, 0.7);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(wet[c], dry[c], 2.0);
}

}  // namespace
}  // namespace fumon
