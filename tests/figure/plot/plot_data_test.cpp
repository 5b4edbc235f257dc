#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "figure/plot/plot_drawing.h"
#include "support/figure_panels.h"

namespace fumon {
namespace {

constexpr CanvasBox plot_frame{60.0, 20.0, 400.0, 300.0};

/// Green of the pixel there.
int green_at(const Image& image, const CanvasPoint& at) {
    return image.row(static_cast<int>(at.y))[3 * static_cast<int>(at.x) + 1];
}

Image drawn_plot(const Plot& plot) {
    Canvas canvas(500, 360, 20.0);
    PlotPanel(plot).draw(canvas, plot_frame);
    return canvas.image();
}

CanvasPoint place_of_values(const Plot& plot, double x, double y) {
    const Canvas canvas(500, 360, 20.0);
    return PlotAxes(canvas, plot, plot_frame).at(x, y);
}

Plot five_points() {
    Plot plot;
    plot.x = {.low = 0.0, .high = 6.0};
    plot.y = {.low = 0.0, .high = 6.0};
    PlotSeries points;
    points.kind = SeriesKind::points;
    points.x = {1.0, 2.0, 3.0, 4.0, 5.0};
    points.y = points.x;
    points.ink = Ink{0.0, 0.0, 1.0};
    points.y_error.assign(5, 0.5);
    plot.series.push_back(points);
    return plot;
}

TEST(PlotData, AFitLiesBehindPointsAndBarsAndHidesNothingOfThem) {
    const Plot bare = five_points();
    Plot fitted = bare;
    PlotSeries fit;
    fit.kind = SeriesKind::fit;
    fit.x = {0.0, 6.0};
    fit.y = {0.0, 6.0};
    fit.ink = Ink{1.0, 0.0, 0.0};
    fitted.series.push_back(fit);
    const Image without = drawn_plot(bare);
    const Image with = drawn_plot(fitted);
    int red = 0;
    for (int y = 0; y < without.height; ++y) {
        for (int x = 0; x < without.width; ++x) {
            const std::uint8_t* before = without.row(y) + 3 * x;
            const std::uint8_t* after = with.row(y) + 3 * x;
            red += after[0] > 200 && after[1] < 60 ? 1 : 0;
            if (before[0] < 5 && before[2] > 250) {
                EXPECT_EQ(after[0], before[0]) << x << " " << y;
                EXPECT_EQ(after[2], before[2]) << x << " " << y;
            }
        }
    }
    EXPECT_GT(red, 200) << "the fit is there";
}

TEST(PlotData, APointOfFewerRunsIsHollow) {
    Plot plot = five_points();
    plot.series[0].y_error.clear();
    plot.series[0].hollow = {true, false, false, false, false};
    for (const Marker marker : {Marker::circle, Marker::square, Marker::triangle, Marker::diamond,
                                Marker::triangle_down}) {
        plot.series[0].marker = marker;
        const Image image = drawn_plot(plot);
        EXPECT_GT(green_at(image, place_of_values(plot, 1.0, 1.0)), 250)
            << static_cast<int>(marker);
        EXPECT_LT(green_at(image, place_of_values(plot, 2.0, 2.0)), 5) << static_cast<int>(marker);
    }
}

TEST(PlotData, ABarThatLeavesTheFrameEndsThereInAnArrow) {
    Plot plot;
    plot.x = {.low = 0.0, .high = 2.0};
    plot.y = {.logarithmic = true, .low = 0.1, .high = 100.0};
    PlotSeries points;
    points.kind = SeriesKind::points;
    points.x = {1.0};
    points.y = {10.0};
    points.y_error = {50.0};
    points.ink = Ink{0.0, 0.0, 0.0};
    plot.series.push_back(points);
    const auto dark_in_row = [&](const Image& image, double y) {
        int dark = 0;
        for (int x = 200; x < 320; ++x)
            dark += green_at(image, {static_cast<double>(x), y}) < 128 ? 1 : 0;
        return dark;
    };
    const Image image = drawn_plot(plot);
    const int shaft = dark_in_row(image, plot_frame.bottom() - 60.0);
    EXPECT_GT(shaft, 0);
    EXPECT_GT(dark_in_row(image, plot_frame.bottom() - 9.0), 2 * shaft) << "the head";
    EXPECT_LE(dark_in_row(image, plot_frame.bottom() - 2.5), shaft + 2) << "and its tip";
    const CanvasPoint top = place_of_values(plot, 1.0, 60.0);
    EXPECT_GT(dark_in_row(image, top.y), 2 * shaft) << "the cap of the other half";
}

}  // namespace
}  // namespace fumon
