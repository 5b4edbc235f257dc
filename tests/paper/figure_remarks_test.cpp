#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/figure_of_runs.h"

namespace fumon::test {
namespace {

/// Figures of a table.
class FigureRemarksTest : public FigureTest {
  protected:
    Ended figure_of(const std::string& points, const std::string& panel, const std::string& curve,
                    const std::string& head = "") {
        write_text(folder_ / "points.csv", points);
        write_text(folder_ / "plot.toml",
                   "[figure]\nformats = [\"svg\"]\n" + head +
                       "[[figure.panel]]\nx_label = \"x\"\ny_label = \"y\"\n" + panel +
                       "[[figure.panel.curve]]\ntable = \"file\"\nfile = \"points.csv\"\nx = "
                       "\"x\"\ny = \"y\"\n" +
                       curve);
        return figure("plot.toml");
    }

    [[nodiscard]] std::string caption(const std::string& name = "plot") const {
        return text("out/" + name + ".caption.txt");
    }
};

TEST_F(FigureRemarksTest, TheCaptionSaysWhereTheNumberOfRunsChanges) {
    const std::string points = "x,y\n1,2\n1,4\n2,3\n2,4\n2,5\n3,7\n3,8\n3,9\n4,5\n";
    const Ended ended = figure_of(points, "", "spread = \"deviation\"\n");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(caption().find("Bars are standard deviations, n = 1 at x = 4, 2 at x = 1, else 3 "
                             "(fewer: hollow)."),
              std::string::npos)
        << caption();
    const auto cells = cells_of(text("out/plot-a-1.csv"));
    ASSERT_EQ(cells.size(), 5U);
    EXPECT_EQ(cells[4], (std::vector<std::string>{"4", "5", "", "1"})) << "no bar of one value";

    ASSERT_EQ(figure_of(points, "", "spread = \"deviation\"\nleast = 2\n").status, 0);
    EXPECT_EQ(cells_of(text("out/plot-a-1.csv")).size(), 4U);
    EXPECT_NE(caption().find("Points of fewer than 2 left out."), std::string::npos) << caption();

    ASSERT_EQ(figure_of("x,y\n1,2\n2,3\n3,7\n", "", "spread = \"deviation\"\n").status, 0);
    EXPECT_EQ(caption().find("ars are"), std::string::npos) << caption();
    EXPECT_NE(caption().find("\nn = 1."), std::string::npos) << caption();
    const Ended none = figure_of(points, "", "least = 4\n");
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.errors.find("plot.toml:10:5: no point is the mean of 4 runs or more"),
              std::string::npos)
        << none.errors;
}

TEST_F(FigureRemarksTest, TheCaptionSaysWhichBarsAreCut) {
    ASSERT_EQ(figure_of("x,y\n1,1\n1,90\n2,10\n2,11\n", "y_logarithmic = true\n",
                        "spread = \"deviation\"\n")
                  .status,
              0);
    EXPECT_NE(caption().find("Bars with an arrow reach below zero."), std::string::npos)
        << caption();
    ASSERT_EQ(
        figure_of("x,y\n1,1\n1,90\n2,10\n2,11\n", "y_high = 60.0\n", "spread = \"deviation\"\n")
            .status,
        0);
    EXPECT_NE(caption().find("Bars with an arrow go on beyond the axes."), std::string::npos)
        << caption();
}

TEST_F(FigureRemarksTest, ColoursOfARowsCourseAreThoseOfItsGroundAndNotOfItsGaps) {
    write_text(folder_ / "plot.toml",
               "[model]\nname = \"static\"\n[bed]\nfile = \"" FUMON_TERRAIN_FOLDER
               "/west_bijou_gully.asc\"\n[run]\nsteps = 2\n[figure]\nformats = [\"svg\"]\n"
               "[[figure.panel]]\nkind = \"time-space\"\nrow_of_bed = 30\n");
    ASSERT_EQ(figure("plot.toml").status, 0);
    EXPECT_NE(caption().find("Colours from 1694 to 1699 m."), std::string::npos) << caption();
    EXPECT_NE(text("out/plot-a.csv").find("\n0,1.5,\n"), std::string::npos)
        << "outside of the catchment";
}

TEST_F(FigureRemarksTest, AViewTellsItsExaggerationColoursAndContours) {
    write_text(folder_ / "plot.toml",
               "[model]\nname = \"static\"\n[bed]\nfile = \"" FUMON_TERRAIN_FOLDER
               "/west_bijou_gully.asc\"\n[figure]\nformats = [\"svg\"]\nsvg_text = \"text\"\n"
               "dots_per_inch = 60\n[[figure.panel]]\nkind = \"view\"\ncolours = \"height\"\n"
               "contours = 5.0\ncoordinates = true\nbar_label = \"elevation ({unit})\"\n"
               "set = [\"look.exaggeration=2\"]\n");
    const Ended ended = figure("plot.toml");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    for (const char* part : {"Heights × 2", "olours from 16", "ontours every 5 m"})
        EXPECT_NE(caption().find(part), std::string::npos) << part << caption();
    const std::string svg = text("out/plot.svg");
    EXPECT_NE(svg.find("elevation (m)"), std::string::npos);
    EXPECT_NE(svg.find(" m N<"), std::string::npos) << "the terrain's own coordinates";
    EXPECT_NE(text("out/plot-a.asc").find("xllcorner 559705"), std::string::npos)
        << "the data lie where the terrain lies";
}

TEST_F(FigureRemarksTest, AnOlderFigureKeepsItsViews) {
    const auto svg_of = [&](const std::string& more) {
        write_scene("view.toml",
                    "[figure]\ndots_per_inch = 60\nformats = [\"svg\"]\n[[figure.panel]]\n"
                    "kind = \"view\"\n" +
                        more);
        EXPECT_EQ(figure("view.toml").status, 0);
        return text("out/view.svg");
    };
    const auto drawing = [](const std::string& svg) { return svg.substr(svg.find("</metadata>")); };
    const std::string previous = drawing(svg_of("relief = \"scene\"\n"));
    std::string svg = svg_of("");
    EXPECT_NE(drawing(svg), previous);
    const std::string version = "fumon:version\">";
    const std::size_t at = svg.find(version) + version.size();
    svg.replace(at, svg.find('<', at) - at, "0.2.0");
    write_text(folder_ / "old.svg", svg);
    ASSERT_EQ(fumon({"again", "old.svg", "-o", "again.svg"}, folder_.path()).status, 0);
    EXPECT_EQ(drawing(text("again.svg")), previous);
}

TEST_F(FigureRemarksTest, LimitsBeyondAllDataAreRefused) {
    const std::string points = "x,y\n1,2\n2,3\n3,7\n";
    const Ended empty = figure_of(points, "x_low = 10.0\nx_high = 20.0\n", "");
    EXPECT_EQ(empty.status, 2);
    EXPECT_NE(empty.errors.find("plot.toml:6:9: figure.panel.0.x_low: nothing lies within the "
                                "axes: x is 1 to 3, y is 2 to 7"),
              std::string::npos)
        << empty.errors;
    const Ended part = figure_of(
        points, "x_high = 2.5\n",
        "[[figure.panel.curve]]\ntable = \"file\"\nname = \"late\"\nfile = \"points.csv\"\nx = "
        "\"x\"\ny = \"y\"\nwhere = [\"x=3\"]\n");
    EXPECT_EQ(part.status, 0);
    EXPECT_NE(part.errors.find("the curve \"late\" lies outside the axes"), std::string::npos)
        << part.errors;
    const Ended negative = figure_of("x,y\n1,-2\n2,-3\n3,-7\n", "y_logarithmic = true\n", "");
    EXPECT_EQ(negative.status, 2);
    EXPECT_NE(negative.errors.find("no value is above 0"), std::string::npos) << negative.errors;
}

TEST_F(FigureRemarksTest, WhatIsTooSmallForPrintIsSaid) {
    const Ended small =
        figure_of("x,y\n1,2\n2,3\n3,7\n", "", "", "font_size = 3.0\nline_width = 0.2\n");
    EXPECT_EQ(small.status, 0);
    EXPECT_NE(small.errors.find("ticks and legends are of 2.5 points"), std::string::npos)
        << small.errors;
    EXPECT_NE(small.errors.find("frames and ticks are 0.1 points wide"), std::string::npos);
    EXPECT_EQ(figure_of("x,y\n1,2\n2,3\n3,7\n", "", "").errors.find("points"), std::string::npos);
}

TEST_F(FigureRemarksTest, AGroupHasItsName) {
    write_text(folder_ / "plot.toml", "");
    ASSERT_EQ(figure_of("x,y,wind_speed\n1,2,3\n2,3,3\n1,4,5\n2,5,5\n", "",
                        "group_by = \"wind_speed\"\n", "svg_text = \"text\"\n")
                  .status,
              0);
    EXPECT_NE(text("out/plot.svg").find("wind speed = 3"), std::string::npos);
}

TEST_F(FigureRemarksTest, SharedParametersAreToldOnceAndOwnOnesByTheirSymbols) {
    write_scene("pictures.toml",
                "[figure]\ndots_per_inch = 60\nformats = [\"png\"]\n"
                "[[figure.panel]]\nkind = \"map\"\nset = [\"model.creep_rate=0.3\"]\n"
                "[[figure.panel]]\nkind = \"map\"\nlow = 2.9\nhigh = 3.0\n");
    const Ended ended = figure("pictures.toml");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const std::string told = caption("pictures");
    EXPECT_EQ(count_of(told, "grid.nx"), 1U) << told;
    EXPECT_EQ(count_of(told, "model sand"), 1U) << told;
    EXPECT_NE(told.find("(a): step 20; seed"), std::string::npos) << told;
    EXPECT_NE(told.find("D (model.creep_rate) = 0.3 share per step"), std::string::npos) << told;
    EXPECT_EQ(count_of(told, "D (model.creep_rate) ="), 2U) << "also where it is the default";
    EXPECT_NE(told.find("Colours from 2.9 to 3 model heights (values from"), std::string::npos)
        << told;
    const std::string latex = text("out/pictures.caption.tex");
    EXPECT_NE(latex.find("model.creep\\_rate"), std::string::npos) << latex;
    EXPECT_EQ(latex.find("\n\n"), std::string::npos) << "one paragraph";
    EXPECT_NE(text("out/pictures.caption.md").find("model.creep\\_rate"), std::string::npos);
    EXPECT_EQ(figure("pictures.toml").status, 0) << "captions of its own are replaced";
}

TEST_F(FigureRemarksTest, ColoursShowAllValuesButThoseOfOlderFigures) {
    std::string bed = "ncols 20\nnrows 20\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (int i = 0; i < 400; ++i)
        bed += i == 84 ? "9\n" : std::to_string(0.05 * (i % 20)) + "\n";  // one peak
    write_text(folder_ / "peak.asc", bed);
    write_text(folder_ / "peak.toml",
               "[model]\nname = \"static\"\n[bed]\nfile = \"peak.asc\"\n[figure]\nformats = "
               "[\"svg\"]\nsvg_text = \"text\"\n[[figure.panel]]\nkind = \"map\"\n");
    ASSERT_EQ(figure("peak.toml").status, 0);
    const auto labels = [](const std::string& svg) { return svg.substr(svg.find("</metadata>")); };
    std::string svg = text("out/peak.svg");
    EXPECT_NE(labels(svg).find(">9<"), std::string::npos) << "a tick at the bar's end";
    EXPECT_NE(caption("peak").find("Colours from 0 to 9 m."), std::string::npos) << caption("peak");
    const std::string version = "fumon:version\">";
    const std::size_t at = svg.find(version) + version.size();
    svg.replace(at, svg.find('<', at) - at, "0.2.0");
    write_text(folder_ / "old.svg", svg);
    ASSERT_EQ(fumon({"again", "old.svg", "-o", "again.svg"}, folder_.path()).status, 0);
    EXPECT_EQ(labels(text("again.svg")).find(">9<"), std::string::npos);
    EXPECT_NE(labels(text("again.svg")).find(">0.8<"), std::string::npos)
        << "up to the 99.5th percentile";
}

TEST_F(FigureRemarksTest, AModelInMetresSpeaksMetres) {
    write_text(folder_ / "dunes.toml",
               "[model]\nname = \"dunes\"\n[grid]\nnx = 24\nny = 16\ncell_size = 2\n[run]\nsteps = "
               "2\n[output]\nmeasure_every = 1\n[figure]\nformats = [\"svg\"]\nsvg_text = "
               "\"text\"\n[[figure.panel]]\n[[figure.panel.curve]]\ny = \"wavelength_spectrum\"\n"
               "[[figure.panel]]\n[[figure.panel.curve]]\ny = \"standard_deviation\"\n"
               "[[figure.panel]]\nkind = \"map\"\n");
    const Ended ended = figure("dunes.toml", {"--set", "bed.high=2"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const auto cells = cells_of(text("out/dunes-a-1.csv"));
    EXPECT_EQ(cells[0][1], "wavelength_spectrum (m)");
    EXPECT_EQ(cells_of(text("out/dunes-b-1.csv"))[0][1], "standard_deviation (m)");
    for (const char* word : {"sites", "heights"}) {
        EXPECT_EQ(text("out/dunes.svg").find(word, text("out/dunes.svg").find("</metadata>")),
                  std::string::npos);
        EXPECT_EQ(caption("dunes").find(word), std::string::npos) << caption("dunes");
    }
    ASSERT_EQ(fumon({"run", "dunes.toml", "-q", "-o", "run", "--set", "bed.high=2"}, folder_.path())
                  .status,
              0);
    const auto rows = cells_of(text("run/measurements.csv"));
    const auto column = static_cast<std::size_t>(
        std::find(rows[0].begin(), rows[0].end(), "wavelength_spectrum") - rows[0].begin());
    EXPECT_EQ(rows.back()[column].substr(0, 8), cells.back()[1].substr(0, 8));
    EXPECT_GT(std::stod(rows.back()[column]), 8.0) << "m, of cells of 2 m";
}

}  // namespace
}  // namespace fumon::test
