#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "figure/charts/heat_map.h"
#include "support/figure_of_runs.h"

namespace fumon::test {
namespace {

/// Charts of a table, and of small runs.
class FigureChartsTest : public FigureTest {
  protected:
    Ended chart_of(const std::string& points, const std::string& panel, const std::string& curve,
                   const std::string& more = "") {
        write_text(folder_ / "points.csv", points);
        write_text(folder_ / "chart.toml",
                   "[figure]\nformats = [\"svg\"]\nsvg_text = \"text\"\n[[figure.panel]]\n" +
                       panel + "[[figure.panel.curve]]\ntable = \"file\"\nfile = \"points.csv\"\n" +
                       curve + more);
        return figure("chart.toml");
    }

    [[nodiscard]] std::string caption() const { return text("out/chart.caption.txt"); }
    [[nodiscard]] std::string drawn() const { return text("out/chart.svg"); }

    void expect_reported(const std::string& part) const {
        EXPECT_NE(caption().find(part), std::string::npos) << part << "\n" << caption();
    }
};

using Cells = std::vector<std::vector<std::string>>;

/// Of a band's area: a property of its style, or an attribute (Cairo 1.18).
bool has_translucent_area(const std::string& svg) {
    return svg.find("fill-opacity:0.25") != std::string::npos ||
           svg.find("fill-opacity=\"0.25\"") != std::string::npos;
}

const std::string pairs = "x,y\n1,2\n1,4\n2,3\n2,4\n2,5\n3,7\n3,8\n3,9\n";

TEST_F(FigureChartsTest, ABandStandsInPlaceOfBars) {
    const std::string curve = "x = \"x\"\ny = \"y\"\nspread = \"deviation\"\n";
    ASSERT_EQ(chart_of(pairs, "", curve).status, 0);
    const std::string with_bars = drawn();
    const Ended ended = chart_of(pairs, "", curve + "bars = \"band\"\n");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(drawn(), with_bars);
    EXPECT_TRUE(has_translucent_area(drawn()));
    EXPECT_FALSE(has_translucent_area(with_bars));
    expect_reported("Bands are standard deviations, n = 2 at x = 1, else 3");
    ASSERT_EQ(chart_of("x,y\n1,1\n1,90\n2,10\n2,11\n", "y_logarithmic = true\n",
                       curve + "bars = \"band\"\n")
                  .status,
              0);
    expect_reported("The band reaches below zero.");
}

TEST_F(FigureChartsTest, AFormulaStandsBesideData) {
    const Ended ended =
        chart_of(pairs, "", "x = \"x\"\ny = \"y\"\n",
                 "[[figure.panel.curve]]\ntable = \"expression\"\nname = \"theory\"\nexpression = "
                 "\"a * x^2 + 1\"\nconstants = [\"a = 0.5\"]\n");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    expect_reported("Curve 2: y = a * x² + 1, a = 0.5.");
    EXPECT_NE(text("out/chart-a-2.csv").find("# y = a * x^2 + 1; a = 0.5\n"), std::string::npos);
    const Cells cells = cells_of(text("out/chart-a-2.csv"));
    ASSERT_EQ(cells.size(), 402U);
    EXPECT_EQ(cells[0], (std::vector<std::string>{"x", "y"}));
    EXPECT_EQ(cells[1], (std::vector<std::string>{"1", "1.5"})) << "where the data begin";
    EXPECT_EQ(cells[201], (std::vector<std::string>{"2", "3"}));
    EXPECT_EQ(cells[401], (std::vector<std::string>{"3", "5.5"}));
    EXPECT_NE(drawn().find("theory"), std::string::npos);

    const Ended wrong =
        chart_of(pairs, "", "x = \"x\"\ny = \"y\"\n",
                 "[[figure.panel.curve]]\ntable = \"expression\"\nexpression = \"1 + b * x\"\n");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_NE(wrong.errors.find("chart.toml:12:14: figure.panel.0.curve.1.expression: column 5: "
                                "\"b\" is neither x nor one of the constants"),
              std::string::npos)
        << wrong.errors;
}

TEST_F(FigureChartsTest, AHeatMapHasTheMeansOfItsRunsAndTheirNumber) {
    const std::string table =
        "a,b,z\n1,0.1,1\n1,0.1,3\n2,0.1,4\n4,0.1,5\n1,10,6\n2,10,7\n2,10,8\n2,10,9\n";
    const std::string curve = "x = \"a\"\ny = \"b\"\nz = \"z\"\n";
    const Ended ended =
        chart_of(table, "kind = \"heat-map\"\ncell_text = \"value-and-n\"\n", curve);
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(cells_of(text("out/chart-a-1.csv")), (Cells{{"a", "b", "z", "runs"},
                                                          {"1", "0.1", "2", "2"},
                                                          {"2", "0.1", "4", "1"},
                                                          {"4", "0.1", "5", "1"},
                                                          {"1", "10", "6", "1"},
                                                          {"2", "10", "8", "3"},
                                                          {"4", "10", "", "0"}}));
    expect_reported("Curve 1: z over a and b");
    expect_reported("Colours from 2 to 8.");
    expect_reported("n = 1 to 3 in a cell; numbers are means (and n).");
    expect_reported("1 of 6 cells are without a value (crossed).");
    EXPECT_NE(drawn().find("(3)"), std::string::npos);

    ASSERT_EQ(chart_of(table,
                       "kind = \"heat-map\"\nlevels = [3.0, 6.5]\nclasses = [\"flat\", "
                       "\"ripples\", \"dunes\"]\n",
                       curve)
                  .status,
              0);
    expect_reported("Colours by z: flat below 3, ripples from 3, dunes from 6.5.");
    EXPECT_NE(drawn().find("ripples"), std::string::npos);
    ASSERT_EQ(
        chart_of(table, "kind = \"heat-map\"\nlevels = [3.0]\ncontours = 2.0\n", curve).status, 0);
    expect_reported("Lines at 3.");
    expect_reported("Lines every 2.");

    const std::string words = "a,b,z\nsand,low,1\nloess,low,3\nsand,high,4\n";
    ASSERT_EQ(chart_of(words, "kind = \"heat-map\"\n", curve).status, 0);
    EXPECT_NE(drawn().find("loess"), std::string::npos);
}

TEST_F(FigureChartsTest, AHeatMapOfASweepCountsSeeds) {
    write_scene(
        "sweep.toml",
        "[sweep]\nover = [\"model.hop_base=1,2\", \"model.creep_rate=0.1,0.3\"]\nseeds = 2\n"
        "[figure]\nformats = [\"svg\"]\n[[figure.panel]]\nkind = \"heat-map\"\n"
        "[[figure.panel.curve]]\nx = \"model.hop_base\"\ny = \"model.creep_rate\"\nz = "
        "\"standard_deviation\"\nwhere = [\"step=20\"]\n");
    const Ended ended = figure("sweep.toml");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(runs().size(), 8U);
    const Cells cells = cells_of(text("out/sweep-a-1.csv"));
    ASSERT_EQ(cells.size(), 5U);
    EXPECT_EQ(cells[0][2], "standard_deviation (heights)");
    for (std::size_t i = 1; i < cells.size(); ++i) EXPECT_EQ(cells[i][3], "2");
    EXPECT_NE(text("out/sweep.caption.txt").find("n = 2 in each cell."), std::string::npos);
}

TEST(HeatMapTest, CellsOfNumbersReachHalfwayToTheNext) {
    const HeatAxis axis = value_axis({1.0, 2.0, 4.0}, {"1", "2", "4"}, false);
    // 0.5, 1.5, 3, 5: a range of 4.5
    EXPECT_NEAR(axis.edges[1], 1.0 / 4.5, 1e-15);
    EXPECT_NEAR(axis.edges[2], 2.5 / 4.5, 1e-15);
    EXPECT_NEAR(axis.middles[2], 3.5 / 4.5, 1e-15);
    const HeatAxis decades = value_axis({0.1, 1.0, 10.0}, {"a", "b", "c"}, true);
    EXPECT_NEAR(decades.edges[1], 1.0 / 3.0, 1e-15);
    EXPECT_NEAR(decades.middles[0], 1.0 / 6.0, 1e-15);
    EXPECT_EQ(even_axis({"a", "b"}).middles, (std::vector<double>{0.25, 0.75}));
}

TEST(HeatMapTest, LinesLieBetweenTheMiddlesOfCells) {
    Grid values(3, 2);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 3; ++x) values(x, y) = x;
    }
    const std::vector<ContourLine> lines = cell_lines(values, 1.25);
    ASSERT_EQ(lines.size(), 1U);
    std::set<double> ends;
    for (const glm::dvec2& point : lines[0].points) {
        EXPECT_NEAR(point.x, 1.25, 1e-12);
        ends.insert(point.y);
    }
    EXPECT_EQ(*ends.begin(), -0.5) << "to the frame";
    EXPECT_EQ(*ends.rbegin(), 1.5);
    HeatMap map;
    map.bounds = {3.0, 6.5};
    EXPECT_EQ(map.class_of(2.9), 0U);
    EXPECT_EQ(map.class_of(3.0), 1U);
    EXPECT_EQ(map.class_of(7.0), 2U);
}

TEST_F(FigureChartsTest, AScatterPlotHasTheColoursOfAThirdNumber) {
    const Ended ended = chart_of("a,b,z\n1,2,10\n2,3,20\n3,,30\n4,1,40\n", "kind = \"scatter\"\n",
                                 "x = \"a\"\ny = \"b\"\nz = \"z\"\n");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(cells_of(text("out/chart-a-1.csv")),
              (Cells{{"a", "b", "z"}, {"1", "2", "10"}, {"2", "3", "20"}, {"4", "1", "40"}}));
    expect_reported("Colours from 10 to 40.");
    expect_reported("3 points, one for each row.");
}

TEST_F(FigureChartsTest, AHistogramHasNumpysBins) {
    const std::string table = "v\n3\n1\n4\n1.5\n9\n2.6\n5.3\n5.8\n-7\n25\n";
    const Ended ended = chart_of(table, "kind = \"histogram\"\nbins = 4\n", "y = \"v\"\n");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(cells_of(text("out/chart-a-1.csv")), (Cells{{"v from", "v to", "count"},
                                                          {"-7", "1", "1"},
                                                          {"1", "9", "7"},
                                                          {"9", "17", "1"},
                                                          {"17", "25", "1"}}));
    expect_reported("Curve 1: values of v");
    expect_reported("4 bins from -7 to 25.");
    expect_reported("n = 10.");
    ASSERT_EQ(chart_of(table,
                       "kind = \"histogram\"\nbins = 5\nbin_low = 0.0\nbin_high = 10.0\n"
                       "bar_height = \"density\"\n",
                       "y = \"v\"\n")
                  .status,
              0);
    const Cells cells = cells_of(text("out/chart-a-1.csv"));
    ASSERT_EQ(cells.size(), 6U);
    const std::vector<double> densities{0.125, 0.125, 0.1875, 0.0, 0.0625};
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(std::stod(cells[i + 1][3]), densities[i], 1e-15);
    expect_reported("n = 8 (2 more lie outside of the bins).");
}

TEST_F(FigureChartsTest, ABoxPlotHasNumpysQuartiles) {
    const std::string table =
        "x,y\n10,3\n10,1\n10,4\n10,1.5\n10,9\n10,2.6\n10,5.3\n10,5.8\n10,-7\n10,25\n9,1\n9,2\n";
    const Ended ended = chart_of(table, "kind = \"box-plot\"\n", "x = \"x\"\ny = \"y\"\n");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const Cells cells = cells_of(text("out/chart-a-1.csv"));
    ASSERT_EQ(cells.size(), 3U);
    EXPECT_EQ(cells[1][0], "9") << "in the order of numbers";
    EXPECT_EQ(cells[2][0], "10");
    EXPECT_EQ(cells[2][1], "10");
    const std::vector<double> numbers{5.02, 1.0, 1.775, 3.5, 5.675, 9.0};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        EXPECT_NEAR(std::stod(cells[2][i + 2]), numbers[i], 1e-14);
    EXPECT_EQ(cells[2][8], "2") << "beyond the whiskers: -7 and 25";
    EXPECT_EQ(cells_of(text("out/chart-a-1-values.csv")).size(), 13U);
    expect_reported("quartile (linear between values)");
    expect_reported("whiskers to the farthest values within 1.5 times the box's length");
    expect_reported("n = 2 to 10 for each.");

    ASSERT_EQ(chart_of(table, "kind = \"box-plot\"\nshape = \"violin\"\nshow_values = true\n",
                       "x = \"x\"\ny = \"y\"\n")
                  .status,
              0);
    EXPECT_EQ(cells_of(text("out/chart-a-1-density.csv")).size(), 201U);
    expect_reported("Scott's rule");
}

TEST_F(FigureChartsTest, ADifferenceNamesBothBedsAndPartsAtZero) {
    write_scene("differ.toml",
                "[figure]\nformats = [\"svg\"]\nsvg_text = \"text\"\n[[figure.panel]]\nkind = "
                "\"difference\"\nset = [\"model.hop_base=3\"]\nminus_set = "
                "[\"model.hop_base=1\"]\n[[figure.panel]]\nkind = "
                "\"difference\"\nminus_step = 0\n");
    const Ended ended = figure("differ.toml");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const std::string told = text("out/differ.caption.txt");
    EXPECT_NE(told.find("Height of model.hop_base=3 minus that of model.hop_base=1."),
              std::string::npos)
        << told;
    EXPECT_NE(told.find("Height of step 20 minus that of step 0."), std::string::npos) << told;
    EXPECT_NE(told.find("Minus step 0; seed"), std::string::npos) << told;
    EXPECT_NE(text("out/differ.svg").find("step\u00a020\u00a0\u2212\u00a0step\u00a00"),
              std::string::npos);
    // As far below 0 as above.
    const std::size_t at = told.find("Colours from \u2212");
    ASSERT_NE(at, std::string::npos) << told;
    const std::string low = told.substr(at + 16, told.find(" to ", at) - at - 16);
    EXPECT_EQ(told.find(low, told.find(" to ", at)), told.find(" to ", at) + 4) << told;

    write_scene(
        "bad.toml",
        "[figure]\n[[figure.panel]]\nkind = \"difference\"\nminus_set = [\"grid.nx=20\"]\n");
    EXPECT_NE(figure("bad.toml").errors.find("the two beds differ in size"), std::string::npos);
    write_scene("bad.toml", "[figure]\n[[figure.panel]]\nkind = \"difference\"\n");
    EXPECT_NE(figure("bad.toml").errors.find("name what is subtracted"), std::string::npos);
}

TEST_F(FigureChartsTest, SeveralMapsShareOneRangeAndOneBar) {
    const std::string map =
        "[[figure.panel]]\nkind = \"map\"\nshare_colours = true\nshare_axes = true\n";
    write_scene("maps.toml", "[figure]\nformats = [\"svg\"]\nsvg_text = \"text\"\n" + map +
                                 "set = [\"model.hop_base=1\"]\n" + map);
    const Ended ended = figure("maps.toml");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const std::string told = text("out/maps.caption.txt");
    EXPECT_EQ(count_of(told, "one range for all panels"), 2U) << told;
    EXPECT_EQ(count_of(text("out/maps.svg"), ">height (model"), 1U) << "one bar";
    EXPECT_EQ(count_of(text("out/maps.svg"), ">x (sites)"), 2U);
    EXPECT_EQ(count_of(text("out/maps.svg"), ">y (sites)"), 1U) << "the left one's";
    ASSERT_EQ(figure("maps.toml", {"--set", "figure.columns=1"}, "column").status, 0);
    EXPECT_EQ(count_of(text("column/maps.svg"), ">x (sites)"), 1U) << "the lower one's";
    EXPECT_EQ(count_of(text("column/maps.svg"), ">y (sites)"), 2U);
}

TEST_F(FigureChartsTest, WrongChartsAreOneLocatedLine) {
    const std::string xyz = "x = \"x\"\ny = \"y\"\nz = \"y\"\n";
    struct Case {
        std::string panel, curve, said;
    };
    const std::vector<Case> cases{
        {"kind = \"heat-map\"\n", "x = \"x\"\ny = \"y\"\n", ".z: is missing; name the column"},
        {"", xyz, ".z: is the column of colours in heat-map and scatter panels"},
        {"kind = \"heat-map\"\nlevels = [2.0, 1.0]\n", xyz, ".levels: must rise"},
        {"kind = \"heat-map\"\nlevels = [1.0]\nclasses = [\"a\"]\n", xyz,
         ".classes: there are 1 between 1 levels; give 2"},
        {"kind = \"scatter\"\nbins = 3\n", xyz, ".bins: belongs to histogram panels"},
        {"kind = \"histogram\"\nbin_low = 2.0\nbin_high = 1.0\n", "y = \"y\"\n",
         ".bin_high: must be above bin_low"},
        {"", "x = \"x\"\ny = \"y\"\nbars = \"band\"\n", ".bars: there is no spread to draw"},
        {"", "x = \"x\"\ny = \"y\"\nexpression = \"x\"\n", ".expression: is given but not read"},
        {"kind = \"heat-map\"\nx_logarithmic = true\n", "x = \"q\"\ny = \"y\"\nz = \"y\"\n",
         "there is no column \"q\""},
        {"kind = \"box-plot\"\n", "x = \"x\"\ny = \"y\"\nfit = \"line\"\n",
         ".fit: belongs to plot panels"},
    };
    for (const Case& one : cases) {
        const Ended ended = chart_of(pairs, one.panel, one.curve);
        EXPECT_EQ(ended.status, 2) << one.panel << one.curve;
        EXPECT_NE(ended.errors.find(one.said), std::string::npos) << ended.errors;
        EXPECT_TRUE(ended.errors.starts_with("chart.toml:")) << ended.errors;
    }
}

}  // namespace
}  // namespace fumon::test
