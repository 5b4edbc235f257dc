#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <optional>
#include <sstream>
#include <thread>

#include "base/image.h"
#include "files/folder_lock.h"
#include "files/hash.h"
#include "picture/png.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

std::vector<std::vector<std::string>> cells_of(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with('#')) continue;
        std::vector<std::string> cells;
        std::istringstream parts(line);
        for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
        rows.push_back(std::move(cells));
    }
    return rows;
}

const std::string curves = R"(
[sweep]
over = ["model.hop_base=1,2,3"]
seeds = 2
[figure]
width = "single"
columns = 1
dots_per_inch = 60
caption = "What is tested."
[[figure.panel]]
title = "over time"
[[figure.panel.curve]]
name = "L0 = {model.hop_base}"
x = "step"
y = "standard_deviation"
group_by = "model.hop_base"
spread = "deviation"
[[figure.panel]]
title = "at the end"
[[figure.panel.curve]]
x = "model.hop_base"
y = "standard_deviation"
where = ["step=20"]
fit = "line"
[[figure.panel.box]]
label = "elsewhere"
source = "Somebody 1999"
x_low = 1.5
x_high = 2.5
y_low = 0.1
y_high = 0.2
)";

const std::string pictures = R"(
[figure]
width = "double"
columns = 3
dots_per_inch = 60
[[figure.panel]]
kind = "map"
title = "step {step}"
steps = [5, 20]
[[figure.panel]]
kind = "view"
title = "creep {model.creep_rate}"
steps = [20]
)";

class FigureTest : public ::testing::Test {
  protected:
    Ended figure(const std::string& scene, const std::vector<std::string>& more = {},
                 const std::string& output = "out") {
        std::vector<std::string> arguments{"figure", scene, "-o", output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return fumon(arguments, folder_.path());
    }

    void write_scene(const std::string& name, const std::string& more) const {
        write_text(folder_ / name, small_scene() + more);
    }

    [[nodiscard]] std::string text(const std::string& name) const {
        return read_text(folder_ / name);
    }

    [[nodiscard]] std::vector<std::string> runs(const std::string& output = "out/runs") const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_ / output))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    /// The one line with which a figure is refused.
    std::string refusal(const std::string& more) {
        write_scene("bad.toml", more);
        const Ended ended = figure("bad.toml", {}, "bad");
        EXPECT_EQ(ended.status, 2) << more;
        EXPECT_EQ(count_of(ended.errors, "\n"), 1U) << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "bad"));
        return ended.errors;
    }

    ScratchFolder folder_;
};

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

TEST_F(FigureTest, TheSecondTimeNothingIsSimulatedAndTheBytesAreTheSame) {
    write_scene("plots.toml", curves);
    write_scene("pictures.toml", pictures);
    ASSERT_EQ(figure("plots.toml", {"pictures.toml"}).status, 0);
    std::vector<fs::file_time_type> times;
    for (const std::string& run : runs())
        times.push_back(fs::last_write_time(folder_ / "out/runs" / run));
    const Ended again = figure("plots.toml", {"pictures.toml", "--runs", "out/runs"}, "second");
    ASSERT_EQ(again.status, 0) << again.errors;
    std::size_t k = 0;
    for (const std::string& run : runs())
        EXPECT_EQ(fs::last_write_time(folder_ / "out/runs" / run), times[k++]);
    for (const auto& entry : fs::directory_iterator(folder_ / "out")) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory()) continue;
        EXPECT_EQ(text("second/" + name), text("out/" + name)) << name;
    }
}

TEST_F(FigureTest, FilesOfOthersAndWhatItReadsAreNotReplaced) {
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
                                    ": is there already, and nothing says that fumon made it; name "
                                    "another output, or --force replaces it\n");
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
              "out/page-a-1.csv is read, and would be replaced; write to another file\n");
    EXPECT_EQ(text("out/page-a-1.csv"), points);
}

TEST_F(FigureTest, FilesOfOthersInAStoredRunStopItFromBeingMadeAnew) {
    write_scene("pictures.toml", pictures);
    ASSERT_EQ(figure("pictures.toml").status, 0);
    const std::string notes = "out/runs/" + runs()[0] + "/notes.txt";
    write_text(folder_ / notes, "mine");
    write_scene("pictures.toml", pictures + "[[figure.panel]]\nkind = \"map\"\nsteps = [7]\n");
    const Ended ended = figure("pictures.toml");
    EXPECT_NE(ended.status, 0);
    EXPECT_NE(ended.errors.find(notes + ": is no file of a stored run"), std::string::npos)
        << ended.errors;
    EXPECT_EQ(text(notes), "mine");
    fs::remove(folder_ / notes);
    EXPECT_EQ(figure("pictures.toml").status, 0);
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

TEST_F(FigureTest, AFigureOfAChangedTerrainIsRefused) {
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

TEST_F(FigureTest, OneRunServesAllStepsOfAllPanels) {
    write_scene("pictures.toml", pictures);
    ASSERT_EQ(figure("pictures.toml").status, 0);
    ASSERT_EQ(runs().size(), 1U);
    const auto job = nlohmann::json::parse(text("out/runs/" + runs()[0] + "/job.json"));
    EXPECT_EQ(job["fields_at"], (std::vector<int>{0, 5, 20}));
    write_scene("more.toml", pictures + "[[figure.panel]]\nkind = \"map\"\nsteps = [7]\n");
    ASSERT_EQ(figure("more.toml").status, 0);
    ASSERT_EQ(runs().size(), 1U);
    const auto more = nlohmann::json::parse(text("out/runs/" + runs()[0] + "/job.json"));
    EXPECT_EQ(more["fields_at"], (std::vector<int>{0, 5, 7, 20}));
    EXPECT_EQ(more["state_sha256"], job["state_sha256"]);
    EXPECT_TRUE(fs::exists(folder_ / "out/more-c.asc"));
    EXPECT_TRUE(fs::exists(folder_ / "out/more-d.asc"));
    EXPECT_FALSE(fs::exists(folder_ / "out/more-e.asc"));
}

TEST_F(FigureTest, WhatAFinishedRunsSnapshotsLookLikeIsKnownFromItsFolder) {
    write_scene("time.toml",
                "[figure]\nwidth = \"single\"\n[[figure.panel]]\n[[figure.panel.curve]]\nx = "
                "\"time\"\ny = \"mean_height\"\n[[figure.panel]]\n[[figure.panel.curve]]\ntable = "
                "\"profile\"\nx = \"x\"\ny = \"height\"\n");
    const auto first_columns = [&] {
        const Ended ended = figure("time.toml");
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return std::vector<std::string>{cells_of(text("out/time-a-1.csv"))[0][0],
                                        cells_of(text("out/time-b-1.csv"))[0][0]};
    };
    const auto own = first_columns();
    ASSERT_EQ(runs().size(), 1U);
    const std::string file = "out/runs/" + runs()[0] + "/job.json";
    const auto change = [&](const auto& changing) {
        auto job = nlohmann::ordered_json::parse(text(file));
        changing(job);
        write_text(folder_ / file, job.dump());
    };
    change([](auto& job) {
        job["snapshots"]["time_unit"] = "weeks";
        job["snapshots"]["scale"]["in_metres"] = !job["snapshots"]["scale"]["in_metres"];
    });
    const auto told = first_columns();
    EXPECT_EQ(told[0], "time (weeks)") << "a model would have said steps";
    EXPECT_NE(told[1], own[1]);
    const std::vector<void (*)(nlohmann::ordered_json&)> damages{
        [](nlohmann::ordered_json& job) { job.erase("snapshots"); },
        [](nlohmann::ordered_json& job) { job["snapshots"].erase("scale"); },
        [](nlohmann::ordered_json& job) { job["snapshots"]["fields"] = 3; },
        [](nlohmann::ordered_json& job) { job["snapshots"]["nx"] = 0; },
        [](nlohmann::ordered_json& job) { job["snapshots"]["ny"] = 1LL << 40; }};
    for (std::size_t k = 0; k < damages.size(); ++k) {
        change(damages[k]);
        EXPECT_EQ(first_columns(), own) << "damage " << k << ": the run is made again";
    }
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

TEST_F(FigureTest, KilledOrInterruptedItGoesOn) {
    write_scene("plots.toml", curves);
    const std::vector<std::string> longer{"--set", "run.steps=1500", "--threads", "1"};
    std::vector<std::string> arguments{"figure", "plots.toml", "-o", "out"};
    arguments.insert(arguments.end(), longer.begin(), longer.end());
    for (const int signal : {SIGKILL, SIGINT}) {
        const auto finished = [&] {
            std::size_t count = 0;
            if (!fs::exists(folder_ / "out/runs")) return count;
            for (const std::string& name : runs()) count += name.size() == 16 ? 1U : 0U;
            return count;
        };
        const std::size_t before = finished();
        Program program(arguments, folder_.path());
        for (int tries = 0; tries < 3000 && finished() <= before; ++tries)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        program.send(signal);
        const Ended ended = program.wait();
        EXPECT_EQ(ended.status, signal == SIGINT ? 130 : 128 + SIGKILL) << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "out/plots.pdf"));
        EXPECT_LT(finished(), 6U);
    }
    const Ended ended = figure("plots.toml", longer);
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(ended.errors.find("of 6 runs were there already"), std::string::npos);
    EXPECT_EQ(runs().size(), 6U) << "no locks, no parts";
    ASSERT_EQ(figure("plots.toml", longer, "fresh").status, 0);
    EXPECT_EQ(text("out/plots.svg"), text("fresh/plots.svg"));
}

TEST_F(FigureTest, TwoAtOnceShareTheRuns) {
    write_scene("plots.toml", curves);
    const std::vector<std::string> arguments{"figure", "plots.toml",    "-o", "out",
                                             "--set",  "run.steps=300", "-v"};
    Program one(arguments, folder_.path());
    Program other(arguments, folder_.path());
    const Ended first = one.wait();
    const Ended second = other.wait();
    ASSERT_EQ(first.status, 0) << first.errors;
    ASSERT_EQ(second.status, 0) << second.errors;
    EXPECT_EQ(runs().size(), 6U);
    ASSERT_EQ(figure("plots.toml", {"--set", "run.steps=300"}, "fresh").status, 0);
    EXPECT_EQ(text("out/plots.pdf"), text("fresh/plots.pdf"));
}

TEST_F(FigureTest, OthersThatArePuttingTheirFilesThereAreWaitedFor) {
    write_scene("plots.toml", curves);
    ASSERT_EQ(figure("plots.toml", {}).status, 0);
    for (const char* end : {".pdf", ".svg", ".png"})
        fs::rename(folder_ / ("out/plots" + std::string(end)),
                   folder_ / ("kept" + std::string(end)));
    write_text(folder_ / "out/plots.pdf.part", "half of");
    std::optional<FolderLock> lock(folder_ / "out");
    Program program({"figure", "plots.toml", "-o", "out"}, folder_.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    fs::remove(folder_ / "out/plots.pdf.part");
    for (const char* end : {".pdf", ".svg", ".png"})
        fs::rename(folder_ / ("kept" + std::string(end)),
                   folder_ / ("out/plots" + std::string(end)));
    lock.reset();
    const Ended ended = program.wait();
    EXPECT_EQ(ended.status, 0) << ended.errors;
}

TEST_F(FigureTest, ARunThatFailsIsNamedAndOtherFiguresAreMade) {
    write_scene("plots.toml", curves);
    write_text(
        folder_ / "wild.toml",
        "[model]\nname = \"gully\"\ntime_step = 50.0\nslope = 1.0\n[grid]\nnx = 8\nny = 8\n[run]\n"
        "steps = 50\n[figure]\nwidth = \"single\"\n[[figure.panel]]\n"
        "[[figure.panel.curve]]\ny = \"mean_depth\"\n");
    const Ended ended = figure("wild.toml", {"plots.toml"});
    EXPECT_EQ(ended.status, 1) << ended.errors;
    EXPECT_NE(ended.errors.find("wild.toml: seed 1 failed: "), std::string::npos) << ended.errors;
    EXPECT_NE(ended.errors.find("wild.toml: is not made"), std::string::npos) << ended.errors;
    EXPECT_TRUE(fs::exists(folder_ / "out/plots.pdf"));
    EXPECT_FALSE(fs::exists(folder_ / "out/wild.pdf"));
}

TEST_F(FigureTest, WhatIsWrongIsOneLocatedLine) {
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
         "a logarithmic axis lies above 0"},
        {plot + "inset = \"upper-left\"\n" + curve.substr(plot.size()), "this is the first"},
        {plot + "steps = [3]\n" + curve.substr(plot.size()),
         "belongs to map, view, profile and section panels; a plot panel would not show it"},
        {map + "x_label = \"x\"\n",
         "bad.toml:17:11: figure.panel.0.x_label: belongs to plot panels; a map panel would not "
         "show it"},
        {"[[figure.panel]]\nkind = \"profile\"\ny_low = 0.0\n", "belongs to plot panels"},
        {"[[figure.panel]]\nkind = \"view\"\naxes = false\n", "belongs to map panels"},
        {plot + "palette = \"grey\"\n" + curve.substr(plot.size()), "a plot panel would not show"},
        {map + "steps = [21]\n", "step 21 is after the run's end at 20"},
        {map + "field = \"water_depth\"\n", "the model sand has no field \"water_depth\""},
        {map + "title = \"{stepp}\"\n", "{stepp} stands for nothing here"},
        {map + "title = \"{step\"\n", "has a brace alone"},
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
        {curve + "name = \"{colour}\"\n", "{colour} stands for nothing here"},
        {curve + "scale_y = 2.0\n", "the column's unit holds no more"},
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

}  // namespace
}  // namespace fumon::test
