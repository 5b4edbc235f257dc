#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/image.h"
#include "base/quantity_text.h"
#include "files/hash.h"
#include "picture/png.h"
#include "support/command.h"
#include "support/figure_of_runs.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

TEST_F(FigureTest, CurvesHaveTheDataOfTheSweep) {
    write_scene("plots.toml", curves);
    const Ended ended = figure("plots.toml");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(runs().size(), 6U);
    ASSERT_EQ(fumon({"sweep", "plots.toml", "-q", "-o", "sweep"}, folder_.path()).status, 0);
    const auto table = cells_of(text("sweep/sweep.csv"));  // run, hop_base, seed, step, time …
    const auto column = static_cast<std::size_t>(
        std::find(table[0].begin(), table[0].end(), "standard_deviation") - table[0].begin());
    for (int base = 1; base <= 3; ++base) {
        const auto points = cells_of(text("out/plots-a-" + std::to_string(base) + ".csv"));
        ASSERT_EQ(points.size(), 1U + 5);
        EXPECT_EQ(points[0], (std::vector<std::string>{"step", "standard_deviation (heights)",
                                                       "spread", "rows"}));
        for (std::size_t p = 1; p < points.size(); ++p) {
            std::vector<double> values;
            for (const auto& row : table) {
                if (row[1] == std::to_string(base) && row[3] == points[p][0])
                    values.push_back(std::stod(row[column]));
            }
            ASSERT_EQ(values.size(), 2U);
            EXPECT_DOUBLE_EQ(std::stod(points[p][1]), (values[0] + values[1]) / 2.0);
            EXPECT_NEAR(std::stod(points[p][2]), std::abs(values[0] - values[1]) / std::sqrt(2.0),
                        1e-15);
            EXPECT_EQ(points[p][3], "2");
        }
    }
    EXPECT_FALSE(fs::exists(folder_ / "out/plots-a-4.csv"));
    const std::string last = text("out/plots-b-1.csv");
    EXPECT_EQ(cells_of(last).size(), 1U + 3);
    EXPECT_NE(last.find("# b = "), std::string::npos);
    const std::string caption = text("out/plots.caption.txt");
    for (const char* part :
         {"What is tested.", "(a)", "(b)", "model.hop_base = 1, 2, 3", "seeds 5 to 6",
          "grid.nx = 24", "elsewhere: Somebody 1999", "fumon 0."})
        EXPECT_NE(caption.find(part), std::string::npos) << part << "\n" << caption;
}

TEST_F(FigureTest, CaptionsTellWhatTheItemsOfAModelsListsSay) {
    write_text(folder_ / "water.toml",
               "[model]\nname = \"water\"\n[grid]\nnx = 12\nny = 8\n[run]\nsteps = 1\n"
               "[[water]]\ndepth = 2\n[figure]\ndots_per_inch = 60\nformats = [\"png\"]\n"
               "[[figure.panel]]\nkind = \"map\"\nfield = \"water_depth\"\n");
    const Ended ended = fumon({"figure", "water.toml", "-q", "-o", "out"}, folder_.path());
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const std::string caption = text("out/water.caption.txt");
    EXPECT_NE(caption.find("water.0.depth = 2"), std::string::npos) << caption;
    EXPECT_EQ(caption.find("water.0.level"), std::string::npos) << caption;
}

TEST_F(FigureTest, MapsShowTheCrestsOfARunsWinds) {
    const auto picture = [&](const std::string& panel) {
        write_text(folder_ / "winds.toml",
                   "[model]\nname = \"dunes\"\n[[wind]]\nfrom = 270\n[[wind]]\nfrom = 180\n"
                   "[grid]\nnx = 24\nny = 16\n[run]\nsteps = 2\n[figure]\ndots_per_inch = 60\n"
                   "formats = [\"png\"]\n[[figure.panel]]\nkind = \"map\"\n" +
                       panel);
        const Ended ended = figure("winds.toml");
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return hex(pixel_hash(read_png(folder_ / "out/winds.png")));
    };
    const std::string plain = picture("");
    const std::string with_crests = picture("crests = true\n");
    EXPECT_NE(with_crests, plain);
    EXPECT_NE(picture("crests = true\nset = [\"wind.0.duration=2\"]\nflux_ratio = 0\n"),
              picture("crests = true\nset = [\"wind.0.duration=2\"]\nflux_ratio = 5\n"))
        << "with other predictions";
}

TEST_F(FigureTest, AProfileHasEveryFieldAndAPanelsPaletteRunsItsOwnWay) {
    const auto water = [](const std::string& look, const std::string& panel) {
        return "[model]\nname = \"gully\"\n[grid]\nnx = 12\nny = 8\n[run]\nsteps = 2\n[look]\n" +
               look +
               "[figure]\ndots_per_inch = 60\nformats = [\"png\"]\n[[figure.panel]]\nkind = "
               "\"map\"\n"
               "field = \"water_depth\"\n" +
               panel +
               "[[figure.panel]]\n[[figure.panel.curve]]\ntable = \"profile\"\nx = \"x\"\n"
               "y = \"water_depth\"\n";
    };
    const auto picture = [&](const std::string& look, const std::string& panel) {
        write_text(folder_ / "water.toml", water(look, panel));
        const Ended ended = figure("water.toml");
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return hex(pixel_hash(read_png(folder_ / "out/water.png")));
    };
    const std::string own = "palette = \"grey\"\n";
    const std::string turned = "palette_reversed = true\n";
    const std::string plain = picture("", own);
    const auto points = cells_of(text("out/water-b-1.csv"));
    ASSERT_EQ(points.size(), 1U + 12);
    EXPECT_EQ(points[0][1], "water_depth (m)");
    EXPECT_NEAR(std::stod(points[1][1]), 0.01, 1e-3) << "the film that it starts with";
    EXPECT_EQ(picture(turned, own), plain) << "the scene's palette is another";
    EXPECT_NE(picture("", own + turned), plain);
    EXPECT_EQ(picture(own + turned, turned), plain) << "turned twice";
}

TEST_F(FigureTest, AProfileOfWaterHasItsLevel) {
    write_text(folder_ / "level.toml",
               "[model]\nname = \"gully\"\nchannel_depth = 0.02\ninitial_water = \"film\"\n[grid]\n"
               "nx = 12\nny = 8\n[run]\nsteps = 2\n[figure]\n[[figure.panel]]\n"
               "[[figure.panel.curve]]\ntable = \"profile\"\nx = \"height\"\n"
               "y = \"water_level\"\n[[figure.panel.curve]]\ntable = \"profile\"\n"
               "x = \"height\"\ny = \"water_depth\"\n");
    const Ended ended = figure("level.toml");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const auto levels = cells_of(text("out/level-a-1.csv"));
    const auto depths = cells_of(text("out/level-a-2.csv"));
    ASSERT_EQ(levels.size(), 1U + 12);
    ASSERT_EQ(depths.size(), levels.size());
    EXPECT_EQ(levels[0][1], "water_level (m)");
    for (std::size_t i = 1; i < levels.size(); ++i) {
        EXPECT_NEAR(std::stod(levels[i][1]), std::stod(levels[i][0]) + std::stod(depths[i][1]),
                    1e-9);
    }
}

TEST_F(FigureTest, AxesOfPicturesAreNamedAsTheSceneSays) {
    const auto words = [&](const std::string& name, const std::string& labels) {
        write_scene(name + ".toml",
                    "[figure]\nformats = [\"pdf\"]\n"
                    "[[figure.panel]]\nkind = \"map\"\nsteps = [5]\n" +
                        labels + "[[figure.panel]]\nkind = \"profile\"\nsteps = [5]\n" +
                        (labels.empty() ? "" : "x_label = \"along ({unit})\"\n"));
        EXPECT_EQ(figure(name + ".toml").status, 0);
        return run_command("pdftotext -layout " + (folder_ / "out" / (name + ".pdf")).string() +
                           " -")
            .words;
    };
    const std::string usual = words("usual", "");
    EXPECT_NE(usual.find("x (sites)"), std::string::npos) << usual;
    const std::string own = words(
        "own", "x_label = \"east\"\ny_label = \"{unit} north\"\nbar_label = \"H in {unit}\"\n");
    for (const char* word : {"east", "along (sites)"})
        EXPECT_NE(own.find(word), std::string::npos) << word << "\n" << own;
    EXPECT_EQ(own.find("x (sites)"), std::string::npos) << own;
}

TEST(LabelOr, PutsTheUnitInItsPlace) {
    EXPECT_EQ(label_or("", "x (m)"), "x (m)");
    EXPECT_EQ(label_or("東 ({unit})", "x (m)"), "東 (m)");
    EXPECT_EQ(label_or("height / {unit}", "height (mean) (model heights)"),
              "height / model heights");
    EXPECT_EQ(label_or("wave ({unit})", "step"), "wave") << "which has none";
    EXPECT_EQ(label_or("wave / {unit}", "step"), "wave / 1");
    EXPECT_EQ(label_or("{{a}} in {unit}, {unit}", "x (m)"), "{a} in m, m");
    EXPECT_EQ(label_or("distance", "x (m)"), "distance");
}

TEST_F(FigureTest, EveryFormatMakesTheSameBytesAgain) {
    write_scene("pictures.toml", pictures);
    write_text(folder_ / "points.csv", "x,y\n1,2\n2,4.5\n3,6\n");
    fs::create_directories(folder_ / "sub");
    write_text(
        folder_ / "sub/mixed.toml",
        "[[figure.panel]]\nx_label = \"x\"\n[[figure.panel.curve]]\ntable = \"file\"\nfile = "
        "\"../points.csv\"\nx = \"x\"\ny = \"y\"\n[[figure.panel.curve]]\nscene = "
        "\"../pictures.toml\"\ny = \"mean_height\"\n");
    ASSERT_EQ(figure("pictures.toml", {"sub/mixed.toml"}).status, 0);
    fs::remove(folder_ / "points.csv");  // the figure holds them
    fs::remove(folder_ / "pictures.toml");
    for (const std::string name :
         {"pictures.pdf", "pictures.svg", "pictures.png", "mixed.pdf", "mixed.svg", "mixed.png"}) {
        const Ended ended = fumon({"again", "out/" + name, "-o", "again-" + name}, folder_.path());
        ASSERT_EQ(ended.status, 0) << ended.errors;
        EXPECT_NE(ended.errors.find("the same bytes"), std::string::npos) << ended.errors;
        EXPECT_EQ(text("again-" + name), text("out/" + name)) << name;
    }
}

TEST_F(FigureTest, PanelsStandInTheRowsAndColumnsThatTheyName) {
    const auto page = [&](const std::string& name, const std::string& row,
                          const std::string& column) {
        write_scene(name + ".toml",
                    "[figure]\nwidth = \"double\"\ndots_per_inch = 60\nformats = [\"png\"]\n"
                    "[[figure.panel]]\nkind = \"map\"\nsteps = [5]\n"
                    "[[figure.panel]]\nkind = \"map\"\nsteps = [5]\nrow = " +
                        row + "\ncolumn = " + column + "\n");
        const Ended ended = figure(name + ".toml");
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return read_png(folder_ / "out" / (name + ".png"));
    };
    const Image beside = page("beside", "1", "2");
    const Image below = page("below", "2", "1");
    EXPECT_EQ(beside.width, below.width);
    EXPECT_GT(below.height, 2 * beside.height);
}

TEST_F(FigureTest, AProfileCurveLeavesOutCellsWithoutData) {
    write_text(folder_ / "gap.asc",
               "ncols 4\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value -9\n"
               "5 -9 7 8\n5 -9 7 9\n");
    write_text(folder_ / "gap.toml",
               "[model]\nname = \"static\"\n[bed]\nfile = \"gap.asc\"\n[figure]\nwidth = "
               "\"single\"\n[[figure.panel]]\n[[figure.panel.curve]]\ntable = \"profile\"\nx = "
               "\"x\"\ny = \"height\"\n");
    const Ended ended = figure("gap.toml");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const auto points = cells_of(text("out/gap-a-1.csv"));
    ASSERT_EQ(points.size(), 4U);
    EXPECT_EQ(points[1], (std::vector<std::string>{"1", "5", "1"}));
    EXPECT_EQ(points[2], (std::vector<std::string>{"5", "7", "1"}));
}

TEST_F(FigureTest, MissingDataBreakALineAndInfinitiesAreRefused) {
    const auto lines_of = [&](const std::string& points) {
        write_text(folder_ / "points.csv", points);
        write_text(folder_ / "gaps.toml",
                   "[figure]\nformats = [\"svg\"]\n[[figure.panel]]\nx_label = \"x\"\n"
                   "[[figure.panel.curve]]\ntable = \"file\"\nfile = \"points.csv\"\nx = \"x\"\ny "
                   "= \"y\"\n");
        return figure("gaps.toml");
    };
    const auto drawn = [&](const std::string& points) {
        const Ended ended = lines_of(points);
        EXPECT_EQ(ended.status, 0) << ended.errors;
        const std::string svg = text("out/gaps.svg");
        return count_of(svg.substr(svg.find("</metadata>")), "<path");
    };
    const std::size_t whole = drawn("x,y\n1,2\n2,4\n3,5\n4,6\n5,7\n");
    EXPECT_EQ(drawn("x,y\n1,2\n2,4\n3,\n4,6\n5,7\n"), whole) << "a line more, and a marker less";
    EXPECT_EQ(cells_of(text("out/gaps-a-1.csv")).size(), 5U) << "a header and four points";
    EXPECT_EQ(drawn("x,y\n1,2\n2,4\n3,nan\n4,6\n5,7\n"), whole);
    EXPECT_EQ(drawn("x,y\n1,2\n2,4\n3,5\n5,7\n4,\n"), whole - 1) << "none at the end";
    const Ended infinite = lines_of("x,y\n1,2\n2,-inf\n3,5\n");
    EXPECT_EQ(infinite.status, 2);
    EXPECT_NE(infinite.errors.find("points.csv:3: y is -inf; it takes a finite number, or an empty "
                                   "cell where there is none"),
              std::string::npos)
        << infinite.errors;
    const Ended none = lines_of("x,y\n1,\n2,nan\n");
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.errors.find("no row has numbers in x and y"), std::string::npos) << none.errors;
}

}  // namespace
}  // namespace fumon::test
