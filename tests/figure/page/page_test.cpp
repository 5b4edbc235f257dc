#include "figure/page/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.h"
#include "support/figure_panels.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::panel_of;
using test::PlainPanel;
using test::series_of;

/// Numbers that are the same with every standard library.
class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    int whole(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
    }
    double real(double low, double high) {
        return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
    }

  private:
    std::mt19937 random_;
};

Plot random_plot(Dice& dice) {
    Plot plot;
    plot.x.label = "distance from the crest (m)";
    plot.y.label = dice.whole(0, 1) == 1 ? "shear stress (Pa)" : "number of grains that have moved";
    plot.y.logarithmic = dice.whole(0, 3) == 0;
    if (dice.whole(0, 3) == 0) plot.right = PlotAxis{.label = "height (mm)"};
    const double size = std::pow(10.0, dice.real(-8.0, 8.0));
    const int count = dice.whole(1, 5);
    for (int n = 0; n < count; ++n) {
        const double level = dice.real(-2.0, 2.0);
        const double waves = dice.real(0.1, 20.0);
        plot.series.push_back(
            series_of("run " + std::to_string(n), dice.whole(2, 80),
                      [&](double x) { return size * (level + std::sin(waves * x)); }));
        plot.series.back().kind = dice.whole(0, 1) == 1 ? SeriesKind::line : SeriesKind::points;
        plot.series.back().on_right = plot.right.has_value() && n % 2 == 1;
    }
    return plot;
}

Page random_page(unsigned seed) {
    Dice dice(seed);
    Page page;
    page.width = dice.whole(0, 1) == 1 ? 241.0 : 496.0;
    page.columns = dice.whole(1, 3);
    page.font_size = dice.real(6.0, 9.0);
    page.letters = dice.whole(0, 2) > 0;
    if (dice.whole(0, 1) == 1) page.title = "Ripples and dunes";
    if (dice.whole(0, 2) == 0) page.height = dice.real(300.0, 700.0);
    const int count = dice.whole(1, 6);
    for (int n = 0; n < count; ++n) {
        PagePanel panel = panel_of(random_plot(dice), dice.whole(0, 1) == 1 ? "Step 100" : "");
        if (dice.whole(0, 1) == 1)
            panel.content = std::make_unique<PlainPanel>(
                dice.whole(0, 2) == 0 ? 0.0 : dice.real(0.5, 4.0),
                PanelMargins{dice.real(0.0, 20.0), dice.real(0.0, 40.0), 0.0,
                             dice.real(0.0, 20.0)});
        if (page.columns > 1 && dice.whole(0, 4) == 0) panel.columns = 2;
        page.panels.push_back(std::move(panel));
    }
    return page;
}

CanvasBox with_margins(const CanvasBox& frame, const PanelMargins& margins) {
    return {frame.x - margins.left, frame.y - margins.above,
            frame.width + margins.left + margins.right,
            frame.height + margins.above + margins.below};
}

void expect_in_order(const Page& page, const PageLayout& layout) {
    constexpr double slack = 1e-6;  // points
    const CanvasBox sheet{0.0, 0.0, layout.width, layout.height};
    for (std::size_t n = 0; n < layout.frames.size(); ++n) {
        const CanvasBox whole = with_margins(layout.frames[n], layout.margins[n]);
        EXPECT_TRUE(within(whole, sheet, slack)) << "panel " << n;
        const double aspect = page.panels[n].content->aspect();
        if (aspect > 0.0) {
            EXPECT_NEAR(layout.frames[n].width / layout.frames[n].height, aspect, 1e-9 * aspect);
        }
        for (std::size_t m = 0; m < n; ++m)
            EXPECT_FALSE(overlap(whole, with_margins(layout.frames[m], layout.margins[m]), slack))
                << "panels " << m << " and " << n;
    }
}

void expect_apart(const std::vector<PlacedText>& texts, const CanvasBox& sheet) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_TRUE(within(texts[i].box, sheet, 1e-6)) << texts[i].text;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(overlap(texts[i].box, texts[j].box, 0.05))
                << texts[i].text << " and " << texts[j].text;
    }
}

/// Nothing is cut off where the outermost pixels are white.
void expect_white_edge(const Image& image) {
    const auto white = [&image](int x, int y) {
        const std::uint8_t* at = image.row(y) + std::ptrdiff_t{3} * x;
        return at[0] == 255 && at[1] == 255 && at[2] == 255;
    };
    bool all = true;
    for (int x = 0; x < image.width; ++x) all = all && white(x, 0) && white(x, image.height - 1);
    for (int y = 0; y < image.height; ++y) all = all && white(0, y) && white(image.width - 1, y);
    EXPECT_TRUE(all);
}

TEST(Page, OfAnyPanelsKeepsThemApartAndOnTheSheet) {
    int drawn = 0;
    constexpr int pages = 60;
    for (int seed = 0; seed < pages; ++seed) {
        SCOPED_TRACE(seed);
        const Page page = random_page(static_cast<unsigned>(seed));
        PageLayout layout;
        const std::string refused = message_of<InputError>([&] { layout = lay_out(page); });
        if (!refused.empty()) {
            EXPECT_NE(refused.find("too small for its panels"), std::string::npos) << refused;
            continue;
        }
        ++drawn;
        expect_in_order(page, layout);
        Canvas canvas(PageFormat::png, layout.width, layout.height, 72.0, page.font_size);
        draw_page(page, layout, canvas);
        expect_apart(canvas.texts(), {0.0, 0.0, layout.width, layout.height});
        expect_white_edge(canvas.image());
    }
    EXPECT_GT(drawn, pages / 2);
}

Page page_of(std::vector<double> aspects, int columns) {
    Page page;
    page.width = 400.0;
    page.columns = columns;
    for (const double aspect : aspects) {
        PagePanel panel;
        panel.content = std::make_unique<PlainPanel>(aspect, PanelMargins{10, 5, 0, 12});
        page.panels.push_back(std::move(panel));
    }
    return page;
}

TEST(Page, GivesPanelsOfARowOneHeight) {
    const PageLayout layout = lay_out(page_of({1.0, 2.0, 1.5}, 3));
    for (const CanvasBox& frame : layout.frames) {
        EXPECT_NEAR(frame.y, layout.frames[0].y, 1e-9);
        EXPECT_NEAR(frame.height, layout.frames[0].height, 1e-6);
    }
    EXPECT_NEAR(layout.frames[2].right(), 400.0 - 4.0 - 5.0, 1e-6);
}

TEST(Page, AlignsTheEdgesOfColumns) {
    const PageLayout layout = lay_out(page_of({1.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 2));
    for (std::size_t n = 2; n < 6; ++n) {
        EXPECT_NEAR(layout.frames[n].x, layout.frames[n - 2].x, 1e-9);
        EXPECT_NEAR(layout.frames[n].right(), layout.frames[n - 2].right(), 1e-6);
    }
}

TEST(Page, OfAGivenHeightIsFilled) {
    Page page = page_of({0.0, 0.0, 0.0, 0.0}, 2);
    page.height = 500.0;
    const PageLayout layout = lay_out(page);
    EXPECT_EQ(layout.height, 500.0);
    EXPECT_NEAR(layout.frames[3].bottom(), 500.0 - 4.0 - 12.0, 1e-6);
}

TEST(Page, LetsAPanelSpanRowsAndColumns) {
    Page page = page_of({0.0, 0.0, 0.0}, 2);
    page.panels[0].rows = 2;
    page.panels[2].row = 1;
    page.panels[2].column = 1;
    const PageLayout layout = lay_out(page);
    EXPECT_NEAR(layout.frames[0].y, layout.frames[1].y, 1e-9);
    EXPECT_NEAR(layout.frames[0].bottom(), layout.frames[2].bottom(), 1e-9);
}

TEST(Page, TooSmallForItsPanelsSaysSo) {
    Page page = page_of({1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, 8);
    page.width = 200.0;
    page.panels[0].title = "first";
    EXPECT_NE(message_of<InputError>([&] { lay_out(page); }).find("71 mm wide is too small"),
              std::string::npos);
    Page low = page_of({0.0, 0.0}, 1);
    low.height = 60.0;
    EXPECT_NE(message_of<InputError>([&] { lay_out(low); }).find("21 mm high is too small"),
              std::string::npos);
}

TEST(Page, RefusesAPlaceThatIsTakenOrOutside) {
    Page page = page_of({1.0, 1.0}, 2);
    for (PagePanel& panel : page.panels) panel.row = panel.column = 0;
    EXPECT_NE(
        message_of<InputError>([&] { lay_out(page); }).find("panel (b) overlaps another panel"),
        std::string::npos);
    page.panels[1].column = 2;
    EXPECT_NE(message_of<InputError>([&] { lay_out(page); }).find("the page's 2 columns"),
              std::string::npos);
    page.panels[1].column = -1;
    EXPECT_NE(message_of<InputError>([&] { lay_out(page); }).find("only one of row and column"),
              std::string::npos);
}

TEST(Page, RefusesATitleThatCannotBeRead) {
    Page page = page_of({1.0}, 1);
    page.title = std::string(300, 'm');
    EXPECT_NE(message_of<InputError>([&] { lay_out(page); }).find("is too long: it needs"),
              std::string::npos);
}

TEST(Page, HasTheWidthsOfJournals) {
    EXPECT_NEAR(page_size("single").width, 85.0 / 25.4 * 72.0, 1e-9);
    EXPECT_NEAR(page_size("double").width, 175.0 / 25.4 * 72.0, 1e-9);
    EXPECT_NEAR(page_size("slide").width / page_size("slide").height, 16.0 / 9.0, 1e-3);
    EXPECT_NE(message_of<InputError>([] { page_size("duoble"); }).find("did you mean \"double\"?"),
              std::string::npos);
}

TEST(Page, PutsInsetsIntoTheirCorners) {
    for (const Corner corner :
         {Corner::upper_left, Corner::upper_right, Corner::lower_left, Corner::lower_right}) {
        Page page = page_of({1.0}, 1);
        Plot plot;
        plot.x.label = "x (m)";
        plot.series = {series_of("", 20, [](double x) { return x * x; })};
        PageInset inset;
        inset.content = std::make_unique<PlotPanel>(plot);
        inset.corner = corner;
        page.panels[0].insets.push_back(std::move(inset));
        const PageLayout layout = lay_out(page);
        const CanvasBox& frame = layout.frames[0];
        const CanvasBox& small = layout.insets[0][0];
        Canvas canvas(PageFormat::png, layout.width, layout.height, 72.0, page.font_size);
        draw_page(page, layout, canvas);
        ASSERT_FALSE(canvas.texts().empty());
        for (const PlacedText& text : canvas.texts())
            EXPECT_TRUE(within(text.box, frame)) << text.text;
        const bool left = corner == Corner::upper_left || corner == Corner::lower_left;
        const bool top = corner == Corner::upper_left || corner == Corner::upper_right;
        EXPECT_EQ(small.middle().x < frame.middle().x, left);
        EXPECT_EQ(small.middle().y < frame.middle().y, top);
        EXPECT_LT(small.width, 0.4 * frame.width);
    }
}

TEST(Page, LettersItsPanels) {
    const auto texts_of = [](const Page& page) {
        const PageLayout layout = lay_out(page);
        Canvas canvas(PageFormat::svg, layout.width, layout.height, 72.0, page.font_size);
        draw_page(page, layout, canvas);
        std::vector<std::string> texts;
        for (const PlacedText& text : canvas.texts()) texts.push_back(text.text);
        return texts;
    };
    Page page = page_of(std::vector<double>(28, 1.0), 7);
    const auto letters = texts_of(page);
    ASSERT_EQ(letters.size(), 28U);
    EXPECT_EQ(letters[0], "(a)");
    EXPECT_EQ(letters[25], "(z)");
    EXPECT_EQ(letters[27], "(ab)");
    page.letters = false;
    EXPECT_TRUE(texts_of(page).empty());
    EXPECT_TRUE(texts_of(page_of({1.0}, 1)).empty());
}

TEST(PageLayout, AWidePanelIsHigherAndFlatterThanANarrowOne) {
    Page page;
    page.width = 496.0;
    page.columns = 4;
    for (int n = 0; n < 5; ++n) {
        PagePanel panel;
        panel.content = std::make_unique<PlainPanel>(0.0, PanelMargins{});
        if (n == 4) panel.columns = 4;
        page.panels.push_back(std::move(panel));
    }
    const PageLayout layout = lay_out(page);
    const CanvasBox& narrow = layout.frames[0];
    const CanvasBox& wide = layout.frames[4];
    EXPECT_NEAR(wide.height, 2.0 * narrow.height, 1e-6);
    EXPECT_GT(wide.width / wide.height, narrow.width / narrow.height);
}

}  // namespace
}  // namespace fumon
