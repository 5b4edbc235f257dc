#include "figure/overlays/overlay_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "figure/overlays/frame_overlays.h"
#include "figure/overlays/overlay_text.h"
#include "support/overlay_scenes.h"

namespace fumon {
namespace {

TEST(LivePlot, ShowsTheRowsSoFarOverTheWholeRun) {
    OverlaySettings settings;
    settings.kind = OverlayKind::plot;
    for (const int count : {0, 1, 7, 90}) {
        const MeasuredRows rows = rows_up_to(count);
        const Plot plot = live_plot(settings, rows, 1200.0);
        ASSERT_EQ(plot.series.size(), 2U);
        EXPECT_EQ(plot.series[0].x, rows.columns[1].values.copied());
        EXPECT_EQ(plot.series[0].y, rows.columns[2].values.copied());
        EXPECT_EQ(plot.x.low, 0.0);
        EXPECT_EQ(plot.x.high, 1200.0);
        EXPECT_EQ(plot.x.label, "step");
        if (count == 0) continue;
        EXPECT_EQ(plot.series[1].y, std::vector{rows.columns[2].values.back()});
        EXPECT_EQ(plot.y.low, 0.0);
        EXPECT_GE(*plot.y.high, rows.columns[2].values.back());
    }
    settings.low = {"", 2.0};
    settings.high = {"", 9.0};
    const Plot fixed = live_plot(settings, rows_up_to(90), 1200.0);
    EXPECT_EQ(fixed.y.low, 2.0);
    EXPECT_EQ(fixed.y.high, 9.0);
}

TEST(LivePlot, IsDrawnAgainForEveryNewRowAndOnlyThen) {
    const Snapshot first = overlay_bed(60, 40, 0.0);
    const Scene scene = scene_of(overlay("plot", "lower-right"), 640, 360);
    FrameOverlays over(scene, first);
    const auto drawn = [&](int rows) {
        Image image = grey(640, 360);
        over.draw(image, {first, rows_up_to(rows), {}});
        return image;
    };
    const Image seven = drawn(7);
    EXPECT_NE(drawn(8), seven);
    EXPECT_EQ(drawn(7), seven) << "whatever was drawn before";
}

TEST(LivePlot, OfYearsGoesUpToTheLastFrameOrGrows) {
    Snapshot first = overlay_bed(60, 40, 0.0);
    first.time_unit = "yr";  // the scene does not say how many a step takes
    EXPECT_FALSE(time_text_of(scene_of("", 64, 48), first).end);
    const Scene scene = scene_of(overlay("plot", "lower-right", "size = 0.9"), 640, 360);
    const auto curve_end = [&](const OverlayStyle& style) {
        FrameOverlays over(scene, first, style);
        MeasuredRows rows = rows_up_to(0);
        for (int i = 0; i < 10; ++i) {
            rows.columns[1].values.push_back(i);
            rows.columns[2].values.push_back(3.0 + i);
        }
        Image image = grey(640, 360);
        over.draw(image, {first, rows, {}});
        int right = 0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const std::uint8_t* pixel = image.row(y) + std::ptrdiff_t{3} * x;
                if (pixel[2] > pixel[0] + 60) right = std::max(right, x);
            }
        }
        return right;
    };
    const int grown = curve_end({});
    EXPECT_GT(grown, 500) << "up to 10 years, not to 1,200";
    EXPECT_NEAR(curve_end({false, false, 0.0, 18.0}), 0.5 * grown, 80);
}

TEST(GrowingRange, HoldsAllValuesAndChangesSeldom) {
    std::vector<double> values;
    int changes = 0;
    auto before = growing_range(values);
    EXPECT_EQ(before, (std::pair{0.0, 1.0}));
    for (int i = 0; i < 1000; ++i) {
        values.push_back(4.0 + 0.03 * i);
        const auto range = growing_range(values);
        EXPECT_LE(range.first, 4.0);
        EXPECT_GE(range.second, values.back());
        if (range != before) ++changes;
        before = range;
    }
    EXPECT_LE(changes, 12);
    EXPECT_EQ(before, (std::pair{0.0, 40.0}));
    EXPECT_EQ(growing_range(std::vector<double>{NAN, 3.0, NAN}), (std::pair{0.0, 3.0}));
    EXPECT_EQ(growing_range(std::vector{-0.7, 2.2}), (std::pair{-0.8, 3.0}));
    const auto narrow = growing_range(std::vector{1612.3, 1612.9, 1612.5});
    EXPECT_NEAR(narrow.first, 1612.0, 0.4);
    EXPECT_NEAR(narrow.second, 1613.2, 0.4);
    EXPECT_EQ(growing_range(std::vector{0.0, 0.0}), (std::pair{0.0, 1.0}));
}

TEST(TimeText, IsReadableAndAsFineAsTheSteps) {
    Scene scene = scene_of("", 640, 360);
    Snapshot first = overlay_bed(10, 10, 0.0);
    const TimeText steps = time_text_of(scene, first);
    EXPECT_EQ(filled_text("step {step}", scene, steps, 1200, 1200.0), "step 1,200");
    EXPECT_EQ(filled_text("{title}: {model.creep_rate}, seed {seed}", scene, steps, 0, 0.0),
              "Dunes of a test: 0.2, seed 1");
    EXPECT_EQ(filled_text("{model.hop_base} {camera.turn}", scene, steps, 0, 0.0), "5 0");
    EXPECT_THROW(filled_text("{speed}", scene, steps, 0, 0.0), InputError);

    scene = parse_scene("[model]\nname = \"gully\"\ntime_step = 0.25\n[run]\nsteps = 4000\n",
                        "test.toml", "");
    first.time_unit = "s";
    const TimeText seconds = time_text_of(scene, first);
    EXPECT_EQ(seconds.end, 1000.0);
    EXPECT_EQ(seconds(300.0), "300.00 s");
    EXPECT_EQ(seconds(1000.0), "1,000.00 s");
    EXPECT_EQ(filled_text("{time:h}", scene, seconds, 4000, 1000.0), "0.28 h");
    EXPECT_EQ(filled_text("t = {time:min}", scene, seconds, 4000, 7200.0), "t = 120.00 min");
    EXPECT_EQ(filled_text("{time:ms}", scene, seconds, 4000, 1000.0), "1,000,000 ms");
    EXPECT_THROW(filled_text("{time:hours}", scene, seconds, 0, 0.0), InputError);
    EXPECT_THROW(filled_text("{time:h}", scene, steps, 0, 0.0), InputError);

    scene =
        parse_scene("[model]\nname = \"sandpile\"\ngrains_per_step = 500\n[run]\nsteps = 4000\n",
                    "test.toml", "");
    first.time_unit = "grains";
    EXPECT_EQ(time_text_of(scene, first).end, 2e6) << "how wide the plate is";

    scene = parse_scene("[model]\nname = \"dunes\"\n[run]\nsteps = 4000\n", "test.toml", "");
    first.time_unit = "yr";
    const TimeText years = time_text_of(scene, first);
    EXPECT_EQ(years(0.0), "0 yr");
    EXPECT_EQ(years(0.4567), "0.46 yr");
    EXPECT_EQ(years(2.5), "2.5 yr");
    EXPECT_EQ(years(1020.6), "1,021 yr");
    EXPECT_EQ(filled_text("{time:d}", scene, years, 0, 1.0), "365 d");
}

}  // namespace
}  // namespace fumon
