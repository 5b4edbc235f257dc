#include "film/camera/kept_clear.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "film/film_painter.h"
#include "film/film_read.h"
#include "support/program.h"

namespace fumon {
namespace {

using test::fumon;
using test::ScratchFolder;

/// A run of a bed of 40 × 30 cells on a table, made once.
const std::string& run_on_table() {
    static const ScratchFolder folder;
    static const std::string run = [] {
        test::write_text(folder / "scene.toml", test::small_scene());
        fumon({"run", "scene.toml", "-o", "out", "--quiet", "--set", "grid.nx=40", "--set",
               "grid.ny=30", "--set", "run.steps=4", "--set", "look.ground=table", "--set",
               "output.frames=false", "--set", "output.movie=false", "--set",
               "output.fields_every=2"},
              folder.path());
        return (folder / "out").string();
    }();
    return run;
}

/// Whether a block is seen clear of what is written over pictures of so many runs.
void expect_clear(std::size_t panes, const std::string& size, const std::string& film_text) {
    const FilmRuns runs(std::vector<std::string>(panes, run_on_table()), 1);
    const Film film = parse_film("[film]\nsize = \"" + size + "\"\n" + film_text, "f.toml");
    WorkerPool pool(1);
    FilmPainter painter(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
    ASSERT_GE(painter.stage().kept_clear.size(), 2 * panes);
    FilmStage with_captions = painter.stage();
    with_captions.kept_clear.insert(with_captions.kept_clear.end(), with_captions.captions.begin(),
                                    with_captions.captions.end());
    for (const StagedShot& shot : painter.shots()) {
        for (const double share : {0.0, 0.25, 0.6, 1.0})
            EXPECT_FALSE(is_covered(with_captions, shot.pose_at(share)))
                << panes << " panes, " << size << ", at " << share << " of " << film_text;
    }
    EXPECT_TRUE(painter.notes().empty()) << painter.notes().front();
}

constexpr const char* plates =
    "[[overlay]]\nkind = \"scale-bar\"\ncorner = \"lower-left\"\n"
    "[[overlay]]\nkind = \"time\"\ncorner = \"upper-left\"\n";
constexpr const char* legend =
    "[[overlay]]\nkind = \"colour-bar\"\n[look]\ncolour_by = \"height\"\n";
constexpr const char* caption = "[[caption]]\nto = 2\ntext = \"Sand comes in from the west\"\n";
constexpr const char* shot = "[[shot]]\nseconds = 2\nfrom = \"end\"\n";

TEST(KeptClear, NoPaneLetsOverlaysStandOverItsBlock) {
    for (const std::size_t panes : {2UL, 4UL}) {
        for (const char* size : {"720p", "1080p", "vertical"}) {
            for (const std::string move :
                 {"azimuth = 205\nelevation = 30\n", "move = \"orbit\"\n", "elevation = 60\n"}) {
                expect_clear(panes, size, shot + move + plates + caption);
                expect_clear(panes, size, shot + move + plates + legend);
            }
        }
    }
    expect_clear(9, "1080p", std::string(shot) + plates + caption);
}

TEST(KeptClear, SaysWhereThereIsNoRoom) {
    const FilmRuns runs(std::vector<std::string>(9, run_on_table()), 1);
    const Film film = parse_film(
        std::string("[film]\nsize = \"small\"\ncap_height = 80\n") + shot + plates + legend,
        "f.toml");
    WorkerPool pool(1);
    const FilmPainter painter(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
    ASSERT_EQ(painter.notes().size(), 1U);
    EXPECT_TRUE(painter.notes().front().starts_with(
        "shot 1: what is written over several pictures covers the ground in one of them; "))
        << painter.notes().front();
}

TEST(KeptClear, SaysNothingOfACameraThatGoesOverItsBlock) {
    const FilmRuns runs(std::vector<std::string>(2, run_on_table()), 1);
    WorkerPool pool(1);
    for (const std::string move : {"fly-over", "push-in", "along-crest"}) {
        const Film film = parse_film(
            "[film]\nsize = \"small\"\n" + (shot + ("move = \"" + move + "\"\n")) + plates,
            "f.toml");
        const FilmPainter painter(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
        ASSERT_FALSE(painter.stage().kept_clear.empty());
        EXPECT_TRUE(painter.notes().empty()) << move << ": " << painter.notes().front();
    }
}

}  // namespace
}  // namespace fumon
