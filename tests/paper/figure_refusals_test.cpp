#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/figure_of_runs.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

class FigureRefusalsTest : public FigureTest {
  protected:
    /// The one line with which a figure is refused.
    std::string refusal(const std::string& more) {
        write_scene("bad.toml", more);
        const Ended ended = figure("bad.toml", {}, "bad");
        EXPECT_EQ(ended.status, 2) << more;
        EXPECT_EQ(count_of(ended.errors, "\n"), 1U) << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "bad"));
        return ended.errors;
    }
};

TEST_F(FigureRefusalsTest, FilesOfOthersAndWhatItReadsAreNotReplaced) {
    const std::string of_a_file =
        "[figure]\nformats = [\"svg\"]\n[[figure.panel]]\nx_label = \"x\"\n"
        "[[figure.panel.curve]]\ntable = \"file\"\nfile = \"FILE\"\nx = \"x\"\ny = \"y\"\n";
    const auto page_of = [&](const std::string& file) {
        std::string page = of_a_file;
        write_text(folder_ / "page.toml", page.replace(page.find("FILE"), 4, file));
    };
    const std::string points = "x,y\n1,2\n2,4.5\n3,6\n";
    write_text(folder_ / "points.csv", points);
    page_of("points.csv");
    for (const char* name : {"page.svg", "page.caption.txt", "page-a-1.csv", "page-a-7.csv"}) {
        fs::create_directories(folder_ / "out");
        write_text(folder_ / "out" / name, points);
        const Ended ended = figure("page.toml");
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.errors, "out/" + std::string(name) +
                                    ": already exists and was not made by fumon; name another "
                                    "output, or replace it with --force\n");
        EXPECT_EQ(text("out/" + std::string(name)), points);
        fs::remove_all(folder_ / "out");
    }
    fs::create_directories(folder_ / "out");
    for (const char* name : {"page-notes.csv", "page-a-1.txt", "pages-a-1.csv", "page.csv"})
        write_text(folder_ / "out" / name, points);
    ASSERT_EQ(figure("page.toml").status, 0) << "files of other names are in nobody's way";
    ASSERT_EQ(figure("page.toml").status, 0) << "and its own are replaced";
    EXPECT_EQ(text("out/page-notes.csv"), points);

    fs::copy_file(folder_ / "points.csv", folder_ / "out/page-a-1.csv",
                  fs::copy_options::overwrite_existing);
    page_of("out/page-a-1.csv");
    const Ended reads = figure("page.toml", {"--force"});
    EXPECT_EQ(reads.status, 2);
    EXPECT_EQ(reads.errors,
              "out/page-a-1.csv is an input and would be replaced; write to another file\n");
    EXPECT_EQ(text("out/page-a-1.csv"), points);
}

TEST_F(FigureRefusalsTest, AFigureOfAChangedTerrainIsRefused) {
    ASSERT_EQ(fumon({"run", "-q", "-o", "run", "small.toml", "--set", "output.bed_at=[20]"},
                    (write_scene("small.toml", ""), folder_.path()))
                  .status,
              0);
    const std::string bed = "run/beds/bed_00000020.asc";
    ASSERT_TRUE(fs::exists(folder_ / bed));
    write_text(folder_ / "terrain.toml",
               "[model]\nname = \"static\"\n[bed]\nkind = \"file\"\nfile = \"" + bed +
                   "\"\n[figure]\nwidth = \"single\"\nformats = "
                   "[\"svg\"]\n[[figure.panel]]\nkind = \"map\"\n");
    const Ended made = figure("terrain.toml");
    ASSERT_EQ(made.status, 0) << made.errors;
    ASSERT_EQ(fumon({"again", "out/terrain.svg", "-o", "a.svg"}, folder_.path()).status, 0);
    EXPECT_EQ(text("a.svg"), text("out/terrain.svg"));
    write_text(folder_ / bed, text(bed) + "\n");
    const Ended changed = fumon({"again", "out/terrain.svg", "-o", "b.svg"}, folder_.path());
    EXPECT_EQ(changed.status, 2);
    EXPECT_NE(changed.errors.find("as it was when the figure was made"), std::string::npos)
        << changed.errors;
    EXPECT_FALSE(fs::exists(folder_ / "b.svg"));
}

TEST_F(FigureRefusalsTest, WhatIsWrongIsOneLocatedLine) {
    const std::string plot = "[[figure.panel]]\n";
    const std::string curve = plot + "[[figure.panel.curve]]\ny = \"mean_height\"\n";
    const std::string map = "[[figure.panel]]\nkind = \"map\"\n";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "bad.toml: describes no figure"},
        {plot + "title = \"a\"\n", "the plot shows nothing"},
        {plot + "[[figure.panel.curve]]\nx = \"step\"\n", ".y: is missing"},
        {"[figure]\nformats = [\"pdf\", \"gif\"]\n" + curve, "unknown format \"gif\""},
        {plot + "x_low = 2.0\nx_high = 1.0\n" + curve.substr(plot.size()),
         "bad.toml:17:10: figure.panel.0.x_high: 1 must be above the low end 2"},
        {plot + "y_logarithmic = true\ny_low = 0.0\n" + curve.substr(plot.size()),
         "a logarithmic axis takes only values above 0"},
        {plot + "inset = \"upper-left\"\n" + curve.substr(plot.size()), "this is the first"},
        {plot + "steps = [3]\n" + curve.substr(plot.size()),
         "belongs to map, view, profile, section and difference panels; a plot panel would not "
         "show it"},
        {map + "x_logarithmic = true\n",
         "bad.toml:17:17: figure.panel.0.x_logarithmic: belongs to plot, heat-map, scatter and "
         "histogram panels; a map panel would not show it"},
        {"[[figure.panel]]\nkind = \"profile\"\ny_low = 0.0\n",
         "belongs to plot, scatter, histogram and box-plot panels"},
        {"[[figure.panel]]\nkind = \"view\"\naxes = false\n",
         "belongs to map and difference panels"},
        {map + "colours = \"height\"\n", "belongs to view panels; a map panel would not show it"},
        {plot + "coordinates = true\n" + curve.substr(plot.size()),
         "belongs to map and view panels"},
        {plot + "palette = \"grey\"\n" + curve.substr(plot.size()), "a plot panel would not show"},
        {map + "steps = [21]\n", "step 21 is after the run's end at 20"},
        {map + "field = \"water_depth\"\n", "the model sand has no field \"water_depth\""},
        {map + "title = \"{stepp}\"\n", "{stepp} is not a placeholder here"},
        {map + "title = \"{step\"\n", "has an unmatched brace"},
        {map + "title = \"{time:weeks}\"\n", "{time:weeks} is not a placeholder here"},
        {map + "x_label = \"along ({units})\"\n",
         "bad.toml:17:11: figure.panel.0.x_label: {units} is not a placeholder here; {unit} stands "
         "for the unit"},
        {map + "palette = \"virids\"\n",
         "bad.toml:17:11: figure.panel.0.palette: unknown palette \"virids\"; did you mean "
         "\"viridis\"?"},
        {"[[figure.panel]]\nkind = \"profile\"\narrow = \"north\"\n", "a profile has no north"},
        {"[[figure.panel]]\nkind = \"view\"\nlow = \"least\"\n", "figure.panel.0.low"},
        {curve + "average = false\nleast = 2\n", "needs averages"},
        {map + "set = [\"model.creep_rat=1\"]\n", "did you mean \"model.creep_rate\"?"},
        {map + "scene = \"other.toml\"\n", "other.toml"},
        {"[[figure.panel]]\nkind = \"section\"\n", "needs a model with one (airflow), not sand"},
        {curve + "x = \"stpe\"\n", "there is no column \"stpe\"; did you mean \"step\"?"},
        {curve + "where = [\"stop=1\"]\n", "there is no column \"stop\""},
        {curve + "where = [\"~1\"]\n", "there is no column \"~1\""},
        {curve + "table = \"section\"\n", "needs a model with a section (airflow), not sand"},
        {curve + "table = \"avalanches\"\n", "needs a model with avalanches (sandpile), not sand"},
        {curve + "table = \"file\"\n", ".file: is missing"},
        {curve + "table = \"file\"\nfile = \"none.csv\"\n", "none.csv"},
        {curve + "name = \"{colour}\"\n", "{colour} is not a placeholder here"},
        {curve + "spread = \"dev\"\n",
         "curve.0.spread is \"dev\"; it takes one of \"none\", \"deviation\", "
         "\"standard-error\"\n"},
        {curve + "scale_y = 2.0\n", "the column's unit no longer applies"},
        {curve + "over = [\"model.creep_rte=1,2\"]\n", "did you mean \"model.creep_rate\"?"},
        {curve + "[[figure.panel.box]]\nlabel = \"a\"\n", ".source: is missing"},
    };
    for (const auto& [scene, line] : cases) {
        const std::string said = refusal(scene);
        EXPECT_NE(said.find(line), std::string::npos) << scene << said;
        EXPECT_TRUE(said.starts_with("bad.toml:")) << said;
        if (scene.empty()) continue;
        const Ended checked = fumon({"check", "bad.toml"}, folder_.path());
        EXPECT_EQ(checked.status, 2) << scene;
        EXPECT_EQ(checked.errors, said);
    }
}

TEST_F(FigureRefusalsTest, APanelThatIsNotThereIsCounted) {
    write_scene("bad.toml", "[[figure.panel]]\nkind = \"map\"\n");
    const Ended ended = figure("bad.toml", {"--set", "figure.panel.9.title=a"}, "bad");
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.errors.find("there is no figure.panel.9: the scene has 1 [[figure.panel]], and "
                                "they are counted from 0"),
              std::string::npos)
        << ended.errors;
}

}  // namespace
}  // namespace fumon::test
