#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "picture/png.h"
#include "support/foreign_film.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// Figures and galleries of another model's results.
class ForeignFigure : public ForeignFilm {};

TEST_F(ForeignFigure, APanelOfAFigureTakesAFileInPlaceOfAScene) {
    const auto figure = [&](const std::string& panels) {
        write_text(
            folder_ / "page.toml",
            "title = \"A flood\"\n[figure]\nwidth = \"single\"\nformats = [\"svg\"]\n" + panels);
        return run({"figure", "page.toml", "-o", "out", "--force"});
    };
    const std::string map = "[[figure.panel]]\nkind = \"map\"\nscene = \"flood.nc\"\n";
    const Ended made =
        figure(map + "steps = [1]\nfield = \"water_depth\"\n" + map + "field = \"hmax\"\n");
    ASSERT_EQ(made.status, 0) << made.errors;
    const std::string depths = read_text(folder_ / "out/page-a.asc");
    EXPECT_NE(depths.find("\n-9999 -9999 -9999 3\n"), std::string::npos) << depths;
    EXPECT_NE(read_text(folder_ / "out/page-b.asc").find("\n20 21 22 23\n"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "out/runs"));
    const Ended again = run({"again", "out/page.svg", "-o", "again.svg"});
    EXPECT_EQ(again.errors, "again.svg: the same bytes as out/page.svg\n");
    const auto refused = [&](const std::string& panels) {
        const Ended ended = figure(panels);
        EXPECT_EQ(ended.status, 2);
        return ended.errors;
    };
    EXPECT_EQ(refused(map + "steps = [9]\n"),
              "page.toml:8:9: step 9 is after the run's end at 2\n");
    EXPECT_EQ(refused(map + "field = \"hmaxx\"\n"),
              "page.toml:7:9: flood.nc: has no map \"hmaxx\" to colour by; did you mean "
              "\"hmax\"?\n");
    EXPECT_EQ(refused("[[figure.panel]]\nkind = \"map\"\nscene = \"none.nc\"\n"),
              "page.toml:7:9: none.nc: there is no such file of results\n");
    EXPECT_EQ(refused("[[figure.panel]]\nkind = \"section\"\nscene = \"flood.nc\"\n"),
              "page.toml:6:8: a section needs a model with one (airflow), not static; heights "
              "along a row are a profile\n");
}

TEST_F(ForeignFigure, ACurveTakesAFileInPlaceOfAScene) {
    const auto figure = [&](const std::string& curve) {
        write_text(folder_ / "page.toml",
                   "title = \"A flood\"\n[figure]\nwidth = \"single\"\nformats = "
                   "[\"svg\"]\n[[figure.panel]]\n[[figure.panel.curve]]\nscene = "
                   "\"flood.nc\"\n" +
                       curve);
        return run({"figure", "page.toml", "-o", "out", "--force"});
    };
    const Ended made = figure("x = \"time\"\ny = \"mean_depth\"\n");
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_EQ(read_text(folder_ / "out/page-a-1.csv"),
              "time (min),mean_depth (m),rows\n0,0.5,1\n30,0.75,1\n60,1,1\n");
    const Ended again = run({"again", "out/page.svg", "-o", "again.svg"});
    EXPECT_EQ(again.errors, "again.svg: the same bytes as out/page.svg\n");
    const Ended profile = figure("table = \"profile\"\nstep = 1\nx = \"x\"\ny = \"water_level\"\n");
    EXPECT_EQ(profile.status, 0) << profile.errors;
    const std::string caption = read_text(folder_ / "out/page.caption.txt");
    EXPECT_TRUE(contains(caption, "; step 1; from flood.nc.")) << caption;
    EXPECT_EQ(figure("table = \"avalanches\"\nx = \"size\"\ny = \"size\"\n").errors,
              "page.toml:8:9: results of other models have measurements and profiles alone\n");
    EXPECT_EQ(figure("seeds = 2\nx = \"time\"\ny = \"mean_depth\"\n").errors,
              "page.toml:8:9: results of other models are one run; leave it out\n");
    EXPECT_EQ(figure("table = \"profile\"\nstep = 9\nx = \"x\"\ny = \"height\"\n").errors,
              "page.toml:9:8: flood.nc: has no record of step 9; its 3 records are of steps 0 to "
              "2\n");
}

/// Adds a number for each record to a file.
void add_series(const fs::path& file, const char* name, const std::vector<double>& values) {
    int id = 0;
    int time = 0;
    int series = 0;
    must(nc_open(file.c_str(), NC_WRITE, &id));
    must(nc_redef(id));
    must(nc_inq_dimid(id, "time", &time));
    must(nc_def_var(id, name, NC_DOUBLE, 1, &time, &series));
    must(nc_put_att_text(id, series, "units", 2, "m3"));
    must(nc_enddef(id));
    must(nc_put_var_double(id, series, values.data()));
    must(nc_close(id));
}

TEST_F(ForeignFigure, AGalleryShowsTheFilesOfAFolder) {
    add_series(folder_ / "flood.nc", "water_volume", {10, 30, 20});
    add_series(folder_ / "flood.nc", "constant", {1, 1, 1});
    for (const char* known : {"step", "globaltime"})
        add_series(folder_ / "flood.nc", known, {0, 1, 2});
    fs::create_directory(folder_ / "results");
    fs::rename(folder_ / "flood.nc", folder_ / "results/flood.nc");
    write_text(folder_ / "results/bad.nc", "mine");
    const Ended made = run({"gallery", "results", "-o", "site"});
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_TRUE(made.errors.starts_with("results/bad.nc: cannot be read as NetCDF")) << made.errors;
    EXPECT_EQ(read_png(folder_ / "site/files/flood.png").width, 1280);
    const std::string page = read_text(folder_ / "site/index.html");
    for (const char* told :
         {"of SFINCS", "fumon still flood.nc --step 2 -o flood.png",
          "Plot of the water volume over time: between 10 and 30, at the end 20"})
        EXPECT_NE(page.find(told), std::string::npos) << told;
    EXPECT_TRUE(fs::exists(folder_ / "site/files/flood-plot-1.svg"));
    EXPECT_FALSE(fs::exists(folder_ / "site/files/flood-plot-2.svg"));
    const Ended bad = run({"gallery", "results/bad.nc", "-o", "other"});
    EXPECT_EQ(bad.status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "other"));
}

}  // namespace
}  // namespace fumon::test
