#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "figure/panels/map_picture.h"
#include "figure/panels/step_text.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

/// A slope of 1000 cells with one peak and one pit, beyond both percentiles.
Snapshot bed_with_peak_and_pit() {
    Snapshot snapshot;
    snapshot.bed = Grid(40, 25);
    for (std::size_t i = 0; i < snapshot.bed.size(); ++i)
        snapshot.bed.values()[i] = 1.0 + static_cast<double>(i % 40) / 40.0;
    snapshot.bed(7, 3) = 2.985;
    snapshot.bed(20, 11) = 0.02;
    snapshot.scale = {1.0, 1.0, 1.0, true};
    return snapshot;
}

std::vector<std::string> texts_of_bar(const ColourScale& colours) {
    Canvas canvas(200, 300, 12.0);
    draw_colour_bar(canvas, {20.0, 20.0, 12.0, 240.0}, colours, BarDirection::upright);
    std::vector<std::string> texts;
    for (const PlacedText& text : canvas.texts()) texts.push_back(text.text);
    return texts;
}

TEST(ColourEnds, WithoutTailsAreThoseOfAllValues) {
    const Snapshot snapshot = bed_with_peak_and_pit();
    LookSettings look;
    look.colour_by = Colouring::height;
    const MapPicture whole = map_picture(look, snapshot, snapshot, {0.0, 0.0});
    EXPECT_NEAR(whole.colours.low, 0.02, 1e-6);
    EXPECT_NEAR(whole.colours.high, 2.985, 1e-6);
    const MapPicture previous = map_picture(look, snapshot, snapshot);
    EXPECT_NEAR(previous.colours.high, 1.975, 1e-6);
    const auto values = values_of(previous);
    ASSERT_TRUE(values);
    EXPECT_NEAR(values->second, 2.985, 1e-6);
}

TEST(ColourEnds, HaveTicksWhereTheBarSaysSo) {
    ColourScale colours{read_palette("batlow"), 0.02, 2.987, "height (m)"};
    EXPECT_EQ(texts_of_bar(colours).back(), "height (m)");
    EXPECT_EQ(std::ranges::count(texts_of_bar(colours), "2.99"), 0);
    colours.ends_labelled = true;
    const std::vector<std::string> texts = texts_of_bar(colours);
    EXPECT_EQ(std::ranges::count(texts, "0.02"), 1);
    EXPECT_EQ(std::ranges::count(texts, "2.99"), 1);
    EXPECT_EQ(std::ranges::count(texts, "1.5"), 1);
    colours.low = 0.0;
    colours.high = 3.0;
    EXPECT_EQ(texts_of_bar(colours), (std::vector<std::string>{"0.0", "0.5", "1.0", "1.5", "2.0",
                                                               "2.5", "3.0", "height (m)"}));
}

TEST(ColourEnds, ATriangleHasItsRoomBesideTheFrame) {
    const Canvas canvas(400, 400, 12.0);
    ColourScale colours{read_palette("batlow"), 0.0, 1.0, ""};
    const PanelMargins plain =
        with_colour_bar(canvas, {}, BarPosition::right, colours, 200.0, 200.0);
    colours.values_above = true;
    const PanelMargins above =
        with_colour_bar(canvas, {}, BarPosition::right, colours, 200.0, 200.0);
    EXPECT_GT(above.above, plain.above + 5.0);
    EXPECT_EQ(above.below, plain.below);
}

TEST(NaturalTime, HasTheUnitThatSuitsIt) {
    for (const auto& [time, unit, text] :
         std::vector<std::tuple<double, std::string, std::string>>{{3600.0, "s", "1 h"},
                                                                   {5400.0, "s", "1.5 h"},
                                                                   {1200.0, "s", "20 min"},
                                                                   {90.0, "s", "90 s"},
                                                                   {0.0025, "s", "2.5 ms"},
                                                                   {12.5, "s", "12.5 s"},
                                                                   {0.0, "s", "0 s"},
                                                                   {259200.0, "s", "3 d"},
                                                                   {2.0, "yr", "2 yr"},
                                                                   {0.25, "yr", "0.25 yr"},
                                                                   {0.02, "yr", "7.305 d"},
                                                                   {7.0, "days", "7 days"}}) {
        EXPECT_EQ(natural_time(time, unit), text);
    }
    EXPECT_EQ(time_in(1800.0, "s", "h"), "0.5 h");
    EXPECT_EQ(time_in(2.0, "yr", "d"), "730.5 d");
    EXPECT_FALSE(time_in(1.0, "s", "hours"));
    EXPECT_FALSE(time_in(1.0, "steps", "h"));
}

}  // namespace
}  // namespace fumon
