#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "base/error.h"
#include "figure/plot/plot_drawing.h"
#include "figure/plot/ticks.h"
#include "support/figure_panels.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::series_of;

constexpr CanvasBox frame{60.0, 20.0, 200.0, 130.0};

Canvas& sheet() {
    static Canvas canvas(PageFormat::pdf, 400.0, 300.0, 72.0, 8.0);
    return canvas;
}

double random_share(std::mt19937& random) {
    return static_cast<double>(random()) / 4294967295.0;
}

TEST(PlotScale, EndsAtRoundNumbersAroundTheValues) {
    std::mt19937 random(1);
    for (int n = 0; n < 2000; ++n) {
        const double size = std::pow(10.0, -9.0 + 18.0 * random_share(random));
        const double a = size * (2.0 * random_share(random) - 1.0);
        const double b = a + size * random_share(random);
        const PlotScale scale = plot_scale({}, {a, b}, room_along_y_share);
        EXPECT_LE(scale.low, a);
        EXPECT_GE(scale.high, b);
        const bool from_zero = scale.low == 0.0 || scale.high == 0.0;
        EXPECT_LT(scale.high - scale.low, (from_zero ? 2.2 : 1.35) * (b - a)) << a << " " << b;
        const PlotTicks ticks = plot_ticks(scale, 6);
        ASSERT_GE(ticks.values.size(), 2U);
        const double step = (ticks.values[1] - ticks.values[0]) / 20.0;
        for (const double end : {scale.low, scale.high})
            EXPECT_NEAR(end / step, std::round(end / step), 1e-6 * std::abs(end / step) + 1e-6);
    }
}

TEST(PlotScale, OfALogarithmicAxisHoldsItsValues) {
    std::mt19937 random(2);
    for (int n = 0; n < 2000; ++n) {
        const double a = std::pow(10.0, -12.0 + 20.0 * random_share(random));
        const double b = a * std::pow(10.0, 6.0 * random_share(random));
        const PlotScale scale = plot_scale({.logarithmic = true}, {a, b}, room_along_y_share);
        EXPECT_GT(scale.low, 0.0);
        EXPECT_LE(scale.low, a);
        EXPECT_GE(scale.high, b);
        EXPECT_LT(std::log10(scale.high / scale.low), 1.1 * std::log10(b / a) + 0.9);
    }
}

TEST(PlotScale, TakesWhatTheAxisSays) {
    const PlotScale scale = plot_scale({.low = 3.0, .high = 17.5}, {0.0, 100.0}, 0.1);
    EXPECT_EQ(scale.low, 3.0);
    EXPECT_EQ(scale.high, 17.5);
    EXPECT_EQ(plot_scale({.low = 3.0}, {5.0, 100.0}, 0.0).low, 3.0);
    EXPECT_GE(plot_scale({.low = 3.0}, {1.0, 2.0}, 0.0).high, 3.0);
    EXPECT_EQ(plot_scale({}, {1.0, 100.0}, 0.03).low, 0.0);
}

TEST(PlotScale, HasARangeWithoutValues) {
    for (const bool logarithmic : {false, true}) {
        for (const ValueRange& range : {ValueRange{}, ValueRange{5.0, 5.0}}) {
            const PlotScale scale = plot_scale({.logarithmic = logarithmic}, range, 0.03);
            EXPECT_LT(scale.low, scale.high);
            EXPECT_GE(plot_ticks(scale, 6).values.size(), 2U);
        }
    }
}

TEST(PlotTicks, StandWithinTheRangeAndAreFew) {
    std::mt19937 random(3);
    for (int n = 0; n < 3000; ++n) {
        const bool logarithmic = n % 2 == 1;
        const double low = std::pow(10.0, -6.0 + 12.0 * random_share(random));
        const double high =
            logarithmic
                ? low * std::pow(10.0, 0.02 + 15.0 * random_share(random) * random_share(random))
                : low * (1.0 + 1e-3 + 10.0 * random_share(random));
        const int most = 2 + n % 7;
        const PlotTicks ticks = plot_ticks({low, high, logarithmic}, most);
        EXPECT_GE(ticks.values.size(), 1U) << low << " " << high;
        EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(most)) << low << " " << high;
        EXPECT_EQ(ticks.labels.size(), ticks.values.size());
        EXPECT_EQ(std::set(ticks.labels.begin(), ticks.labels.end()).size(), ticks.labels.size());
        for (const auto& values : {ticks.values, ticks.minor}) {
            for (const double value : values) {
                EXPECT_GE(value, low * (1.0 - 1e-6));
                EXPECT_LE(value, high * (1.0 + 1e-6));
            }
        }
    }
}

TEST(PlotTicks, OfALogarithmicAxisAreDecadesWithMinorOnes) {
    const PlotTicks ticks = plot_ticks({0.05, 20.0, true}, 6);
    EXPECT_EQ(ticks.labels, (std::vector<std::string>{"10⁻¹", "10⁰", "10¹"}));
    ASSERT_EQ(ticks.minor.size(), 5U + 8U + 8U + 1U);
    EXPECT_NEAR(ticks.minor.front(), 0.05, 1e-12);
    EXPECT_NEAR(ticks.minor[5], 0.2, 1e-12);
    EXPECT_NEAR(ticks.minor.back(), 20.0, 1e-9);
}

TEST(PlotTicks, OfLessThanTwoDecadesAreOneTwoFive) {
    EXPECT_EQ(plot_ticks({3.0, 60.0, true}, 6).labels,
              (std::vector<std::string>{"5", "10", "20", "50"}));
    EXPECT_EQ(plot_ticks({2e-7, 1e-6, true}, 6).labels,
              (std::vector<std::string>{"2×10⁻⁷", "5×10⁻⁷", "10⁻⁶"}));
}

TEST(PlotTicks, TakeAPowerOutOfLargeAndSmallNumbers) {
    EXPECT_EQ(plot_ticks({0.0, 99999.0, false}, 3).power, 0);
    const PlotTicks large = plot_ticks({0.0, 4e5, false}, 5);
    EXPECT_EQ(large.power, 5);
    EXPECT_EQ(large.labels, (std::vector<std::string>{"0", "1", "2", "3", "4"}));
    const PlotTicks small = plot_ticks({0.0, 2.5e-4, false}, 6);
    EXPECT_EQ(small.power, -4);
    EXPECT_EQ(small.labels.back(), "2.5");
}

std::vector<std::string> texts_of(const Plot& plot) {
    Canvas canvas(PageFormat::pdf, 400.0, 300.0, 72.0, 8.0);
    PlotPanel(plot).draw(canvas, frame);
    std::vector<std::string> texts;
    for (const PlacedText& text : canvas.texts()) texts.push_back(text.text);
    return texts;
}

bool holds(const std::vector<std::string>& texts, const std::string& text) {
    return std::find(texts.begin(), texts.end(), text) != texts.end();
}

TEST(Plot, PutsThePowerIntoTheUnit) {
    Plot plot;
    plot.x.label = "grains";
    plot.y.label = "stress (Pa)";
    plot.series = {series_of("", 9, [](double x) { return 3e-5 * x; })};
    for (double& x : plot.series[0].x) x *= 1e6;
    const auto texts = texts_of(plot);
    EXPECT_TRUE(holds(texts, "stress (10⁻⁵ Pa)"));
    EXPECT_TRUE(holds(texts, "grains (×10⁶)"));
}

/// Whether points or pieces of curves lie in a box.
bool covers_values(const Plot& plot, const PlotAxes& axes, const CanvasBox& box) {
    for (const PlotSeries& series : plot.series) {
        for (std::size_t i = 1; i < series.x.size(); ++i) {
            constexpr int pieces = 20;
            for (int k = 0; k <= pieces; ++k) {
                const double t = static_cast<double>(k) / pieces;
                const CanvasPoint at = axes.at(std::lerp(series.x[i - 1], series.x[i], t),
                                               std::lerp(series.y[i - 1], series.y[i], t));
                if (within(at, box)) return true;
            }
        }
    }
    return false;
}

TEST(Legend, NeverCoversValues) {
    std::mt19937 random(4);
    int inside = 0;
    constexpr int plots = 150;
    for (int n = 0; n < plots; ++n) {
        Plot plot;
        const int count = 1 + n % 4;
        for (int k = 0; k < count; ++k) {
            const double level = random_share(random);
            const double waves = 8.0 * random_share(random);
            const double slope = 4.0 * random_share(random) - 2.0;
            plot.series.push_back(series_of("series " + std::to_string(k), 40, [&](double x) {
                return level + slope * x + 0.4 * std::sin(waves * x);
            }));
        }
        const PlotDrawing drawing = plot_drawing(sheet(), plot, frame);
        ASSERT_TRUE(drawing.legend);
        if (!drawing.legend->inside) continue;
        ++inside;
        EXPECT_TRUE(within(drawing.legend->box, frame, 1e-9));
        EXPECT_FALSE(covers_values(plot, drawing.axes, drawing.legend->box)) << n;
    }
    EXPECT_GT(inside, plots * 9 / 10);
}

Plot crowded() {
    Plot plot;
    plot.y.high = 1.0;
    plot.y.low = -1.0;
    for (int k = 0; k < 6; ++k)
        plot.series.push_back(series_of("curve " + std::to_string(k), 400,
                                        [k](double x) { return std::sin(200.0 * x + k); }));
    return plot;
}

TEST(Legend, StandsOutsideAFullFrame) {
    Plot plot = crowded();
    const auto margins_and_box = [&] {
        const PlotDrawing drawing = plot_drawing(sheet(), plot, frame);
        EXPECT_FALSE(drawing.legend->inside);
        return std::pair{drawing.margins, drawing.legend->box};
    };
    const auto [beside, box] = margins_and_box();
    EXPECT_GE(box.x, frame.right());
    EXPECT_GE(beside.right, box.right() - frame.right());
    plot.series[2].label = "a label that is far too long to stand beside the frame";
    const auto [below, lower] = margins_and_box();
    EXPECT_GE(lower.y, frame.bottom() + 10.0);
    EXPECT_GE(below.below, lower.bottom() - frame.bottom());
}

TEST(Legend, StandsWhereItIsTold) {
    Plot plot = crowded();
    plot.legend = LegendPosition::lower_left;
    const CanvasBox box = plot_drawing(sheet(), plot, frame).legend->box;
    EXPECT_LT(box.middle().x, frame.middle().x);
    EXPECT_GT(box.middle().y, frame.middle().y);
    EXPECT_TRUE(within(box, frame));
    plot.legend = LegendPosition::none;
    EXPECT_FALSE(plot_drawing(sheet(), plot, frame).legend);
}

TEST(Legend, LeavesAnInsetItsCorner) {
    Plot plot;
    plot.series = {series_of("low", 9, [](double x) { return x * x * x; })};
    plot.y.high = 1.0;
    const CanvasBox free = plot_drawing(sheet(), plot, frame).legend->box;
    EXPECT_LT(free.middle().x, frame.middle().x);
    plot.taken = {{0.0, 0.0, 0.6, 0.6}};
    const CanvasBox box = plot_drawing(sheet(), plot, frame).legend->box;
    EXPECT_FALSE(overlap(box, {frame.x, frame.y, 0.6 * frame.width, 0.6 * frame.height}));
}

TEST(Plot, KeepsLabelsOfBoxesApart) {
    Plot plot;
    plot.x.logarithmic = plot.y.logarithmic = true;
    plot.boxes = {{"wind ripples", 0.1, 1, 0.002, 0.05},
                  {"barchans", 100, 1000, 5, 50},
                  {"simple dunes", 50, 500, 1, 20}};
    plot.lines = {{true, 1.0, "one metre"}, {false, 1.0, "high"}};
    const PlotDrawing drawing = plot_drawing(sheet(), plot, frame);
    ASSERT_EQ(drawing.labels.size(), 5U);
    std::vector<CanvasBox> boxes;
    for (const PlotLabel& label : drawing.labels) {
        const auto [width, height] = sheet().text_size(label.text, tick_text_size_em);
        boxes.push_back({label.at.x, label.at.y, width, height});
        EXPECT_TRUE(within(boxes.back(), frame, 1e-9)) << label.text;
        for (std::size_t i = 0; i + 1 < boxes.size(); ++i)
            EXPECT_FALSE(overlap(boxes[i], boxes.back())) << label.text;
    }
}

TEST(Plot, SharesAxes) {
    std::array<Plot, 4> plots;
    for (std::size_t n = 0; n < 4; ++n) {
        plots[n].x.label = "x (m)";
        plots[n].y.label = "h (m)";
        const double size = 1.0 + static_cast<double>(n);
        plots[n].series = {series_of("", 9, [size](double x) { return size * x; })};
        for (double& x : plots[n].series[0].x) x *= size;
    }
    share_axes(plots, 2, true, true);
    EXPECT_EQ(plots[0].x.high, 3.0);
    EXPECT_EQ(plots[2].x.high, 3.0);
    EXPECT_EQ(plots[1].x.high, 4.0);
    EXPECT_EQ(plots[0].y.high, plots[1].y.high);
    EXPECT_GE(*plots[0].y.high, 2.0);
    EXPECT_EQ(texts_of(plots[1]), std::vector<std::string>{});
    EXPECT_TRUE(holds(texts_of(plots[0]), "h (m)"));
    EXPECT_FALSE(holds(texts_of(plots[0]), "x (m)"));
    EXPECT_TRUE(holds(texts_of(plots[3]), "x (m)"));
    EXPECT_FALSE(holds(texts_of(plots[3]), "h (m)"));
}

TEST(Plot, RefusesWhatItCannotShow) {
    const auto refusal = [](const Plot& plot) {
        return message_of<InputError>([&] { const PlotPanel panel(plot); });
    };
    Plot plot;
    plot.series = {series_of("height", 5, [](double x) { return x; })};
    EXPECT_EQ(refusal(plot), "");
    plot.series[0].y.pop_back();
    EXPECT_EQ(refusal(plot), "the series \"height\" has 5 values of x, but 4 of y");
    plot.series[0].y.push_back(1.0);
    plot.series[0].y_error = {1.0};
    EXPECT_EQ(refusal(plot), "the series \"height\" has 5 values of x, but 1 of y_error");
    plot.series[0].y_error.clear();
    plot.y = {.label = "h (m)", .logarithmic = true, .low = 0.0};
    EXPECT_EQ(refusal(plot), "the logarithmic axis \"h (m)\" has the limit 0; it must be above 0");
    plot.y = {.label = "h (m)", .low = 2.0, .high = 2.0};
    EXPECT_EQ(refusal(plot), "the axis \"h (m)\" has the empty range 2 to 2");
    plot.y = {.label = "h (m)", .low = NAN};
    EXPECT_EQ(refusal(plot), "the axis \"h (m)\" has a limit that is not a number");
}

TEST(Plot, DrawsNothingOutsideItsMargins) {
    for (const bool logarithmic : {false, true}) {
        Plot plot;
        plot.x = {.label = "x (m)", .logarithmic = logarithmic, .low = 0.2, .high = 0.8};
        plot.y = {.label = "y (m)", .logarithmic = logarithmic, .low = 0.1, .high = 0.3};
        for (const SeriesKind kind :
             {SeriesKind::line, SeriesKind::points, SeriesKind::line_and_points, SeriesKind::step,
              SeriesKind::band, SeriesKind::fit}) {
            plot.series.push_back(series_of("", 30, [](double x) { return std::tan(3.0 * x); }));
            plot.series.back().kind = kind;
            plot.series.back().x_error.assign(30, 0.3);
            plot.series.back().y_error.assign(30, 1e30);
            plot.series.back().y_low.assign(30, -1e300);
            plot.series.back().y[7] = NAN;
        }
        plot.boxes = {{"", 0.1, 0.5, 0.2, 9.0}};
        plot.lines = {{true, 0.5, ""}, {false, 0.2, ""}};
        Canvas canvas(400, 300, 8.0);
        const PlotPanel panel(plot);
        const PanelMargins room = panel.margins(canvas, frame.width, frame.height);
        panel.draw(canvas, frame);
        const Image image = canvas.image();
        int inked = 0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                if (image.row(y)[3 * x] == 255) continue;
                ++inked;
                EXPECT_TRUE(x + 1 >= frame.x - room.left && x <= frame.right() + room.right &&
                            y + 1 >= frame.y - room.above && y <= frame.bottom() + room.below)
                    << x << " " << y;
            }
        }
        EXPECT_GT(inked, 1000);
    }
}

TEST(Plot, TellsItsSeriesApart) {
    Plot plot;
    for (int n = 0; n < 9; ++n) plot.series.push_back(series_of("", 2, [](double x) { return x; }));
    plot.series[1].ink = Ink{0.0, 114.0 / 255.0, 178.0 / 255.0};
    const auto looks = series_looks(plot);
    for (std::size_t i = 0; i < looks.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const auto apart = std::abs(looks[i].ink.red - looks[j].ink.red) +
                               std::abs(looks[i].ink.green - looks[j].ink.green) +
                               std::abs(looks[i].ink.blue - looks[j].ink.blue);
            EXPECT_TRUE(apart > 0.2 || looks[i].dashes != looks[j].dashes) << i << " " << j;
            EXPECT_TRUE(apart > 0.2 || looks[i].marker != looks[j].marker) << i << " " << j;
        }
    }
}

}  // namespace
}  // namespace fumon
