#include "film/joined_film.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "film/card_backdrop.h"
#include "film/film_read.h"
#include "picture/movie.h"
#include "support/program.h"

namespace fumon {
namespace {

using test::Ended;
using test::fumon;
using test::read_text;
using test::ScratchFolder;
using test::write_text;

constexpr const char* joined =
    "[film]\nwidth = 64\nheight = 48\nrate = 5\nsupersampling = 1\ncap_height = 90\n"
    "[[excerpt]]\nfilm = \"one.toml\"\nrun = 2\nfrom = 0.4\nto = 1.4\n"
    "[[excerpt]]\nfilm = \"two.toml\"\ntransition = \"cross-fade\"\ntransition_seconds = 0.4\n"
    "[[caption]]\nfrom = 0.2\nto = 1\ntext = \"all\"\n";

/// Two runs of different grids, a film of each, and a film of pieces of both.
const ScratchFolder& joined_films() {
    static const ScratchFolder folder;
    static const bool made = [] {
        write_text(folder / "scene.toml", test::small_scene());
        write_text(folder / "one.toml",
                   "[film]\ntitle = \"first\"\n[[shot]]\nseconds = 2\nmove = \"orbit\"\n[[card]]\n"
                   "ground = \"dark\"\n[[caption]]\ntext = \"unseen\"\n");
        write_text(folder / "two.toml", "[[shot]]\nseconds = 1\nfrom = 8\nto = 8\n");
        write_text(folder / "joined.toml", joined);
        for (const char* run : {"a", "b"}) {
            const bool is_b = *run == 'b';
            if (fumon({"run", "scene.toml", "-o", run, "--set", "look.ground=table", "--set",
                       "output.frames=false", "--set", "output.movie=false", "--set",
                       is_b ? "output.bed_every=4" : "output.fields_every=4", "--set",
                       is_b ? "grid.nx=30" : "grid.nx=24"},
                      folder.path())
                    .status != 0)
                return false;
        }
        return true;
    }();
    EXPECT_TRUE(made);
    return folder;
}

std::string fault_of(const std::string& text, std::size_t runs = 2) {
    const ScratchFolder& folder = joined_films();
    try {
        const Film film = parse_film(text, (folder / "j.toml").string());
        std::vector<std::string> folders{(folder / "a").string(), (folder / "b").string()};
        folders.resize(runs);
        const FilmRuns shown(folders, 1, arrangement_of(film));
        WorkerPool pool(1);
        const JoinedFilm frames(film, shown, film_size(film), {}, gl::Backend::automatic, pool);
    } catch (const InputError& fault) {
        std::string said = fault.what();
        return said.substr(said.find("j.toml"));
    }
    return "";
}

TEST(JoinedFilm, ShowsPiecesOfOtherFilmsEachOfItsRun) {
    const ScratchFolder& folder = joined_films();
    const Film film = parse_film(joined, (folder / "joined.toml").string());
    const FilmRuns runs({(folder / "a").string(), (folder / "b").string()}, 1,
                        arrangement_of(film));
    WorkerPool pool(1);
    JoinedFilm frames(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
    EXPECT_EQ(frames.frames(), 5 + 5 - 2);
    Film one = *film.excerpts[0].read;
    one.settings = film.settings;
    const FilmRuns second = runs.only(1);
    FilmPainter alone(one, second, film_size(film), {}, gl::Backend::automatic, pool);
    EXPECT_EQ(frames.paint(0), alone.paint(2)) << "no caption of its own, and from 0.4 s on";
    EXPECT_NE(frames.paint(2), alone.paint(4)) << "the film's caption is over it";
    const Image last = frames.paint(frames.frames() - 1);
    EXPECT_NE(last, frames.paint(3));
    EXPECT_EQ(frames.paint(0), alone.paint(2)) << "any frame at any time";
    EXPECT_EQ(frames.paint(frames.frames() - 1), last);
}

TEST(JoinedFilm, ComesBackToAPieceThatItLetGo) {
    const ScratchFolder& folder = joined_films();
    const std::string other = "[[excerpt]]\nfilm = \"two.toml\"\nto = 0.4\n";
    const Film film = parse_film(joined + other + other +
                                     "[[excerpt]]\nfilm = \"one.toml\"\nrun = 2\nfrom = 1\n"
                                     "[[excerpt]]\nfilm = \"one.toml\"\nrun = 1\nfrom = 1\n",
                                 (folder / "joined.toml").string());
    const FilmRuns runs({(folder / "a").string(), (folder / "b").string()}, 1,
                        arrangement_of(film));
    WorkerPool pool(1);
    JoinedFilm frames(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
    std::vector<Image> shown;
    for (std::int64_t i = 0; i < frames.frames(); ++i) shown.push_back(frames.paint(i));
    Film one = *film.excerpts[0].read;
    one.settings = film.settings;
    const FilmRuns second = runs.only(1);
    FilmPainter alone(one, second, film_size(film), {}, gl::Backend::automatic, pool);
    EXPECT_EQ(shown.front(), alone.paint(2));
    EXPECT_EQ(shown[shown.size() - 6], alone.paint(alone.frames() - 1));
    const FilmRuns first = runs.only(0);
    FilmPainter other_run(one, first, film_size(film), {}, gl::Backend::automatic, pool);
    EXPECT_EQ(shown.back(), other_run.paint(other_run.frames() - 1)) << "its own run's";
}

TEST(JoinedFilm, ABlurredCardStandsOnTheLastPicture) {
    const ScratchFolder& folder = joined_films();
    const std::string place = (folder / "joined.toml").string();
    const Film film = parse_film(joined, place);
    const std::string card =
        "[[card]]\nplace = \"end\"\nground = \"blurred\"\ntitle = \".\"\nseconds = 1\n";
    const Film longer = parse_film(joined + card, place);
    const FilmRuns runs({(folder / "a").string(), (folder / "b").string()}, 1,
                        arrangement_of(film));
    WorkerPool pool(1);
    JoinedFilm frames(longer, runs, film_size(longer), {}, gl::Backend::automatic, pool);
    const Image shown = frames.paint(frames.frames() - 1);
    JoinedFilm pieces(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
    const Image ground = card_backdrop(pieces.paint(pieces.frames() - 1));
    for (const int y : {0, 1, shown.height - 1})  // above and below the letters
        EXPECT_TRUE(std::equal(shown.row(y), shown.row(y) + 3 * shown.width, ground.row(y))) << y;
    EXPECT_NE(shown, ground);
}

TEST(JoinedFilm, IsMadeAgainFromItsFileAlone) {
    const ScratchFolder& folder = joined_films();
    const Ended ended =
        fumon({"film", "a", "b", "joined.toml", "-o", "j.mp4", "--force"}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(ended.errors.find("j.mp4: 8 frames"), std::string::npos) << ended.errors;
    std::filesystem::create_directory(folder / "apart");
    write_text(folder / "apart/j.mp4", read_text(folder / "j.mp4"));
    const Ended again = fumon({"again", "j.mp4", "--force"}, folder / "apart");
    EXPECT_TRUE(again.errors.ends_with("j-again.mp4: the same bytes as j.mp4\n")) << again.errors;
}

TEST(JoinedFilm, SaysWhatDoesNotFit) {
    EXPECT_EQ(fault_of("[[excerpt]]\nfilm = \"no.toml\"\n"),
              "j.toml:2:8: excerpt.0.film: there is no film \"no.toml\"");
    EXPECT_EQ(fault_of("[[excerpt]]\nfilm = \"one.toml\"\nfrom = 1\nto = 3\n"),
              "j.toml:4:6: excerpt.0: from 1 to 3 s is not within that film, whose shots last 2 s");
    EXPECT_EQ(fault_of("[[excerpt]]\nfilm = \"one.toml\"\nrun = 2\n", 1),
              "j.toml:3:7: excerpt.0.run = 2, and 1 run is given");
    EXPECT_EQ(fault_of("[[excerpt]]\nfilm = \"one.toml\"\n[[shot]]\n"),
              "j.toml:1:1: a film has [[shot]] or [[excerpt]], not both; cut the shots from a "
              "film of their own");
    EXPECT_THROW(parse_film("[[excerpt]]\nfilm = \"/etc/hostname\"\n", "j.toml", {}, false),
                 InputError)
        << "a film from anyone reads no files";
}

}  // namespace
}  // namespace fumon
