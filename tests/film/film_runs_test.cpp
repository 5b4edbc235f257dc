#include "film/beds/film_runs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "film/film_painter.h"
#include "film/film_read.h"
#include "support/program.h"

namespace fumon {
namespace {

using test::Ended;
using test::fumon;
using test::ScratchFolder;

constexpr const char* pane_film =
    "[film]\nwidth = 96\nheight = 64\nrate = 5\nsupersampling = 1\ncap_height = 110\n";

/// Runs of the small scene, made once: "a" and "b" differ in a key, "short" stored other beds,
/// "large" has another grid; "sweep" has four runs.
const ScratchFolder& pane_runs() {
    static const ScratchFolder folder;
    static const bool made = [] {
        test::write_text(folder / "scene.toml", test::small_scene());
        const auto run = [&](const std::string& name, const std::vector<std::string>& settings) {
            std::vector<std::string> arguments{
                "run",   "scene.toml",         "-o",    name,
                "--set", "look.ground=table",  "--set", "output.frames=false",
                "--set", "output.movie=false", "--set", "output.fields_every=2"};
            for (const std::string& setting : settings)
                arguments.insert(arguments.end(), {"--set", setting});
            return fumon(arguments, folder.path()).status == 0;
        };
        return run("a", {"model.creep_rate=0.1"}) && run("b", {"model.creep_rate=0.4"}) &&
               run("short", {"output.fields_every=5"}) && run("large", {"grid.nx=30"}) &&
               fumon({"sweep", "scene.toml", "--over", "model.creep_rate=0.1,0.4", "--over",
                      "model.hop_base=3,6", "-o", "sweep", "--set", "output.fields_every=2",
                      "--set", "look.ground=table"},
                     folder.path())
                       .status == 0;
    }();
    EXPECT_TRUE(made);
    return folder;
}

std::vector<std::string> in_runs(const std::vector<std::string>& names) {
    std::vector<std::string> folders;
    folders.reserve(names.size());
    for (const std::string& name : names) folders.push_back((pane_runs() / name).string());
    return folders;
}

std::string fault_of(const std::vector<std::string>& names, const std::string& film = "") {
    try {
        const FilmRuns runs(in_runs(names), 1);
        const Film read = parse_film(pane_film + film + "[[shot]]\nseconds = 1\n", "f.toml");
        WorkerPool pool(1);
        const FilmPainter painter(read, runs, film_size(read), {}, gl::Backend::automatic, pool);
    } catch (const InputError& fault) {
        std::string text = fault.what();
        const std::string folder = pane_runs().path().string() + "/";
        for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
            text.erase(at, folder.size());
        return text;
    }
    return "";
}

/// A film's first frame, of some runs.
Image frame_of(const std::vector<std::string>& names, const std::string& film,
               std::int64_t number = 0) {
    const FilmRuns runs(in_runs(names), 1);
    const Film read = parse_film(
        pane_film + film + "[[shot]]\nseconds = 1\nfrom = 20\nto = 20\nazimuth = 200\n", "f.toml");
    WorkerPool pool(1);
    FilmPainter painter(read, runs, film_size(read), {}, gl::Backend::automatic, pool);
    return painter.paint(number);
}

/// Part of an image.
Image cut(const Image& image, const PaneBox& box) {
    Image part(box.width, box.height);
    for (int y = 0; y < box.height; ++y)
        std::copy_n(image.row(box.y + y) + std::ptrdiff_t{3} * box.x, 3 * box.width, part.row(y));
    return part;
}

TEST(FilmRuns, SayWhatDiffersAndFillAGrid) {
    const FilmRuns two(in_runs({"a", "b"}), 1);
    const Film film = parse_film("[[shot]]\n", "f.toml");
    EXPECT_EQ(two.label(film, 0), "creep rate 0.1");
    EXPECT_EQ(two.label(film, 1), "creep rate 0.4");
    EXPECT_EQ(two.values(), (std::vector<double>{0.1, 0.4}));
    EXPECT_EQ(two.grid_columns(), std::nullopt);
    EXPECT_EQ(
        two.label(
            parse_film("[panes]\nlabel = \"{seed}: {model.creep_rate}\"\n[[shot]]\n", "f.toml"), 1),
        "5: 0.4");
    const FilmRuns sweep(in_runs({"sweep"}), 1);
    ASSERT_EQ(sweep.size(), 4U);
    EXPECT_EQ(sweep.grid_columns(), 2);
    EXPECT_EQ(sweep.label(film, 1).find("creep rate 0.1, hop base 6 sites"), 0U)
        << sweep.label(film, 1);
    EXPECT_EQ(sweep.beds(2).scene().view.look.ground, Ground::table) << "its look is kept";
    EXPECT_EQ(sweep.beds(2).beds().size(), 11U);
    EXPECT_EQ(sweep.beds(3).measurements({"step"}).back().find("step")->values.size(), 5U);
}

TEST(FilmRuns, OneLineForWhatDoesNotFit) {
    EXPECT_EQ(fault_of({"a", "large"}),
              "large: its bed has 30 x 20 cells, that of a 24 x 20; runs side by side need the "
              "same grid");
    EXPECT_EQ(fault_of({"a", "short"}),
              "short: stored no bed of step 4, but a did; store the same steps in all runs "
              "(output.fields_every), or synchronise the runs by time (shot.clock = \"time\")");
    EXPECT_EQ(fault_of({"a", "b", "sweep", "sweep"}),
              "10 runs; a film shows at most 9 (3 x 3) side by side");
    EXPECT_EQ(fault_of({"sweep"}, "[panes]\nshow = \"wipe\"\n"),
              "f.toml:8:8: panes.show = \"wipe\" takes two runs, not 4");
    EXPECT_EQ(fault_of({"a", "b"}), "");
}

TEST(FilmRuns, StandWhereThePanesAre) {
    const Film film = parse_film(std::string(pane_film) + "[[shot]]\n", "f.toml");
    const FilmRuns runs(in_runs({"a", "b"}), 1);
    const Panes panes(film, runs, film_size(film));
    ASSERT_EQ(panes.boxes().size(), 2U);
    const Image both = frame_of({"a", "b"}, "");
    const Image twice = frame_of({"a", "a"}, "");
    EXPECT_EQ(cut(both, panes.boxes()[0]), cut(twice, panes.boxes()[0]));
    EXPECT_EQ(cut(twice, panes.boxes()[0]), cut(twice, panes.boxes()[1]));
    EXPECT_NE(cut(both, panes.boxes()[0]), cut(both, panes.boxes()[1]));
    EXPECT_EQ(pane_columns(2, {1920, 1080}), 2);
    EXPECT_EQ(pane_columns(2, {1080, 1920}), 1);
    EXPECT_EQ(pane_columns(9, {1920, 1080}), 3);
    EXPECT_EQ(pane_columns(4, {1920, 1080}), 2);
    EXPECT_EQ(pane_columns(3, {1080, 1920}), 1);
}

TEST(FilmRuns, WipeAndDifference) {
    const Film film =
        parse_film(std::string(pane_film) + "[panes]\nshow = \"wipe\"\n[[shot]]\n", "f.toml");
    const Panes panes(film, FilmRuns(in_runs({"a", "b"}), 1), film_size(film));
    const PaneBox box = panes.boxes().front();
    const std::string wipe = "[panes]\nshow = \"wipe\"\nwipe_places = [0.5, 0.5]\n";
    const Image wiped = frame_of({"a", "b"}, wipe);
    const Image left = frame_of({"a", "a"}, wipe);
    const Image right = frame_of({"b", "b"}, wipe);
    const PaneBox one{box.x, box.y, box.width / 2 - 1, box.height};
    const PaneBox two{box.x + box.width / 2 + 1, box.y, box.width / 2 - 1, box.height};
    EXPECT_EQ(cut(wiped, one), cut(left, one));
    EXPECT_EQ(cut(wiped, two), cut(right, two));
    EXPECT_NE(cut(wiped, two), cut(left, two));
    // Of two equal runs nothing is coloured: the middle of the palette, which is grey.
    const auto colourful = [](const Image& image) {
        double sum = 0.0;
        for (std::size_t i = 0; i < image.rgb.size(); i += 3)
            sum += std::max(0, image.rgb[i + 2] - image.rgb[i]);  // blue
        return sum;
    };
    const std::string difference = "[panes]\nshow = \"difference\"\n";
    EXPECT_GT(colourful(cut(frame_of({"a", "b"}, difference), box)),
              2.0 * colourful(cut(frame_of({"a", "a"}, difference), box)));
}

TEST(FilmRuns, TheCommandTakesSeveralFolders) {
    test::write_text(pane_runs() / "film.toml",
                     std::string(pane_film) + "[[shot]]\nseconds = 0.4\n");
    const Ended ended = fumon({"film", "a", "b", "film.toml", "-o", "two.mp4"}, pane_runs().path());
    EXPECT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(fumon({"film", "sweep", "film.toml", "-o", "p.png"}, pane_runs().path()).status, 0);
    const Ended ruled = fumon({"film", "a", "b", "--print"}, pane_runs().path());
    EXPECT_EQ(ruled.status, 0) << ruled.errors;
    EXPECT_NE(ruled.output.find("[[shot]]"), std::string::npos) << "no film: one by rule";
}

TEST(FilmRuns, BlendOtherRunsBetweenTheirOwnBeds) {
    const FilmRuns runs(in_runs({"a", "short"}), 1);  // every 2 and every 5 steps
    EXPECT_EQ(runs.in_step(1, RecordPlace{1, 3, 0.5}, FilmClock::time), (RecordPlace{0, 1, 0.8}));
    EXPECT_EQ(runs.in_step(1, RecordPlace{2, 3, 0.5}, FilmClock::time), (RecordPlace{1, 1, 0.0}));
    EXPECT_EQ(runs.in_step(0, RecordPlace{1, 3, 0.5}, FilmClock::time), (RecordPlace{1, 3, 0.5}));
}

}  // namespace
}  // namespace fumon
