#include "render/world_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "base/error.h"
#include "support/drawn_picture.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

/// Dunes of a periodic bed, shifted by whole cells.
Snapshot periodic_dunes(int nx, int ny, int east, int north) {
    Snapshot snapshot;
    snapshot.periodic = true;
    snapshot.bed = Grid(nx, ny);
    const double turn = 2.0 * std::numbers::pi;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double u = turn * ((x - east + nx) % nx) / nx;
            const double v = turn * ((y - north + ny) % ny) / ny;
            snapshot.bed(x, y) =
                3.0 * std::sin(5.0 * u + std::sin(2.0 * v)) + std::sin(3.0 * v - u);
        }
    }
    return snapshot;
}

View standing_view(double east, double north) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.exaggeration = {"", 1.0};
    view.camera.at = {200.0 + east, 150.0 + north, 6.0};
    view.camera.look_at = {260.0 + east, 220.0 + north, 0.0};
    return view;
}

TEST(WorldLayer, ABedShiftedWithTheCameraLooksTheSame) {
    const auto drawn = [](int east, int north) {
        View view = standing_view(east, north);
        view.look.grain = 0.0;  // which stays where it is
        view.look.ripples = 0.0;
        return picture(view, periodic_dunes(420, 400, east, north));
    };
    const Image expected = drawn(0, 0);
    const Image shifted = drawn(37, 290);
    int most = 0;
    double beyond_rounding = 0.0;  // share of the values: of shadows whose margins end elsewhere
    for (std::size_t i = 0; i < expected.rgb.size(); ++i) {
        const int off = std::abs(int{expected.rgb[i]} - int{shifted.rgb[i]});
        most = std::max(most, off);
        if (off > 1) beyond_rounding += 1.0 / static_cast<double>(expected.rgb.size());
    }
    EXPECT_LE(most, 12);
    EXPECT_LE(beyond_rounding, 0.005);
}

TEST(WorldLayer, ReachesTheHorizonUnderASkyThatDarkensUpward) {
    View view = standing_view(0, 0);
    view.camera.look_at = {260.0, 220.0, 5.0};
    view.image.height = 240;
    const Image image = picture(view, periodic_dunes(420, 400, 0, 0));
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
    const Snapshot bed = periodic_dunes(60, 50, 0, 0);
    const Image expected = picture(standing_view(0, 0), bed, 1);
    EXPECT_EQ(picture(standing_view(0, 0), bed, 3), expected);
    for (const char* raster_threads : {"0", "2"}) {
        setenv("LP_NUM_THREADS", raster_threads, 1);
        EXPECT_EQ(picture(standing_view(0, 0), bed), expected) << raster_threads;
    }
    unsetenv("LP_NUM_THREADS");
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
    EXPECT_EQ(refusal(view, wavy_bed(40, 30)),
              "look.ground = \"endless\" needs a whole periodic bed, as the sand models have; "
              "\"table\" draws this one");
    const Snapshot dunes = periodic_dunes(40, 30, 0, 0);
    View from_above = view;
    from_above.camera.projection = Projection::map;
    EXPECT_NE(refusal(from_above, dunes).find("perspective camera"), std::string::npos);
    View figure = view;
    figure.look.mode = ViewMode::figure;
    EXPECT_NE(refusal(figure, dunes).find("scenic"), std::string::npos);
    Snapshot masked = masked_bed(40, 30);
    masked.periodic = true;
    EXPECT_NE(refusal(view, masked).find("whole periodic bed"), std::string::npos);
}

}  // namespace
}  // namespace fumon
