#include "film/script/film_looks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "base/error.h"
#include "film/film_of_looks.h"
#include "film/film_read.h"
#include "film/joined_film.h"
#include "numerics/contour_lines.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::fumon;
using test::message_of;
using test::ScratchFolder;

std::string looks_refusal(const std::string& text, const std::vector<std::string>& settings = {}) {
    return message_of<InputError>([&] { parse_film(text, "f.toml", settings); });
}

TEST(FilmLooks, AreWrittenAsInAScene) {
    const Film film = parse_film(
        "[film]\ntitle = \"[[shot]]\"\n[look]\npalette = \"oslo\"\n[[shot]]\nsun.elevation = 8\n"
        "[[shot]]\n[shot.look]\nground = \"endless\"\n[[shot.person]]\nat = [1, 2]\n"
        "[[shot.person]]\nat = [3, 4]\nfacing = 90\n[[card]]\ntitle = \"a\"\n",
        "f.toml", {"look.palette=vik", "shot.0.look.exposure=1"});
    ASSERT_EQ(film.looks.size(), 1U);
    EXPECT_EQ(film.looks[0].path, "look.palette");
    EXPECT_EQ(film.looks[0].value, "\"vik\"");
    ASSERT_EQ(film.shots[0].looks.size(), 2U);
    EXPECT_EQ(film.shots[0].looks[0].path, "look.exposure");
    ASSERT_EQ(film.shots[1].looks.size(), 4U);
    EXPECT_EQ(film.shots[1].looks[3].path, "person.1.facing");
    const Film again = parse_film(film_toml(film), "again");
    EXPECT_EQ(film_toml(again), film_toml(film));
    EXPECT_EQ(again.shots[1].looks.size(), 4U);
    EXPECT_EQ(again.cards.size(), 1U);
    EXPECT_EQ(again.looks.size(), 1U);
}

TEST(FilmLooks, RefusesWhatNoSceneCouldHave) {
    EXPECT_EQ(looks_refusal("[[shot]]\n[shot.look]\npalete = \"oslo\"\n"),
              "f.toml:3:1: unknown key look.palete; did you mean \"look.palette\"?");
    EXPECT_TRUE(looks_refusal("[sun]\nelevation = 95\n[[shot]]\n").starts_with("f.toml:2:13: "));
    EXPECT_EQ(looks_refusal("[[shot]]\n[look]\ndrape = \"a.png\"\n"),
              "f.toml:3:1: look.drape cannot be changed in a film: a drape is one of the run's own "
              "files; give it to the run's scene");
    EXPECT_EQ(looks_refusal("[[shot]]\n", {"shot.2.look.exposure=1"}),
              "--set 1: shot.2.look.exposure: the film has 1 shots, counted from 0");
    EXPECT_EQ(looks_refusal("[[shot]]\n", {"camera.roll=20"}),
              "--set 1:1: camera.roll cannot be changed in a film: its shots say where the camera "
              "stands, by [[shot]] move, distance, subject and [[shot.key]]");
}

FilmRuns run_of(const ScratchFolder& folder, int steps) {
    test::write_text(folder / "scene.toml", test::small_scene());
    fumon({"run", "scene.toml", "-o", "out", "--quiet", "--set", fmt::format("run.steps={}", steps),
           "--set", fmt::format("output.fields_every={}", steps / 4), "--set", "look.ground=table",
           "--set", "look.light=sun", "--set", "sun.elevation=30", "--set", "output.frames=false",
           "--set", "output.movie=false"},
          folder.path());
    return FilmRuns({(folder / "out").string()}, 1);
}

/// A run of the small scene that stored some beds, made once.
const FilmRuns& looked_runs() {
    static const ScratchFolder folder;
    static const FilmRuns runs = run_of(folder, 20);
    return runs;
}

Image frame_of_film(const std::string& shots, std::int64_t frame,
                    const FilmRuns& runs = looked_runs()) {
    const Film film = parse_film(
        "[film]\nwidth = 64\nheight = 48\nrate = 5\nsupersampling = 1\n" + shots, "f.toml");
    WorkerPool pool(1);
    return film_frames(film, runs, {}, gl::Backend::automatic, pool)->paint(frame);
}

TEST(FilmLooks, ShotsAreDrawnAsAWholeFilmOfThatLook) {
    const std::string plain = "[[shot]]\nseconds = 1\n[[shot]]\nseconds = 1\n";
    const std::string low = "sun.elevation = 8\n";
    EXPECT_EQ(frame_of_film(plain + low, 2), frame_of_film(plain, 2)) << "the first shot";
    EXPECT_NE(frame_of_film(plain + low, 7), frame_of_film(plain, 7));
    EXPECT_EQ(frame_of_film(plain + low, 7), frame_of_film("[sun]\nelevation = 8\n" + plain, 7));
    EXPECT_EQ(frame_of_film(plain + low, 7), frame_of_film(plain + "sun_elevation = 8\n", 7))
        << "the shot's own key for it";
}

TEST(FilmLooks, ACrossFadeMixesBoth) {
    const std::string first = "[[shot]]\nseconds = 2\n";
    const std::string second = "[[shot]]\nseconds = 2\ntransition = \"cross-fade\"\n";
    const std::string low = "sun.elevation = 8\n";
    const std::int64_t middle = 7;  // of the frames 5 to 9, in which both go on
    const Image faded = frame_of_film(first + second + low, middle);
    const Image one = frame_of_film(first + second, middle);
    const Image other = frame_of_film("[sun]\nelevation = 8\n" + first + second, middle);
    EXPECT_NE(faded, one);
    EXPECT_NE(faded, other);
    for (std::size_t i = 0; i < faded.rgb.size(); ++i) {
        const int most = std::max(one.rgb[i], other.rgb[i]) + 20;
        const int least = std::min(one.rgb[i], other.rgb[i]) - 20;
        ASSERT_TRUE(faded.rgb[i] <= most && faded.rgb[i] >= least) << i;
    }
}

TEST(FilmLooks, ALensIsThatOfTheFilmOrOfAShot) {
    const std::string wide = "camera.field_of_view = 60\n";
    const std::string shots = "[[shot]]\nseconds = 1\n[[shot]]\nseconds = 1\n";
    const Image plain = frame_of_film(shots, 7);
    const Image of_shot = frame_of_film(shots + wide, 7);
    EXPECT_EQ(frame_of_film(shots + wide, 2), frame_of_film(shots, 2)) << "the first shot";
    EXPECT_NE(of_shot, plain);
    EXPECT_EQ(of_shot, frame_of_film("[camera]\nfield_of_view = 60\n" + shots, 7));
    EXPECT_EQ(frame_of_film(shots + "focal_length = 50\n", 7),
              frame_of_film(shots + "focal_length = 50\n" + wide, 7))
        << "the shot's own key for it";
}

TEST(FilmLooks, LayersAreDrawnOverTheGroundInAFilmOrAShot) {
    const std::string shots = "[[shot]]\nseconds = 1\n[[shot]]\nseconds = 1\n";
    const std::string lines = "data = \"contours\"\ncolour = \"#ff0000\"\nhidden = \"show\"\n";
    const Image plain = frame_of_film(shots, 7);
    const Image drawn = frame_of_film("[[layer]]\n" + lines + shots, 7);
    EXPECT_NE(drawn, plain);
    EXPECT_EQ(frame_of_film(shots + "[[shot.layer]]\n" + lines, 7), drawn);
    EXPECT_EQ(frame_of_film(shots + "[[shot.layer]]\n" + lines, 2), frame_of_film(shots, 2));
    EXPECT_EQ(message_of<InputError>([&] {
                  frame_of_film("[[layer]]\ndata = \"contours\"\nlabel = \"name\"\n" + shots, 0);
              }),
              "f.toml:8:9: layer.0.label is \"name\"; this layer has the label \"height\" alone");
}

TEST(FilmLooks, ALayersFileLiesBesideTheFilm) {
    const auto refusal = [](const std::string& source) {
        const Film film = parse_film("[[layer]]\nfile = \"none.geojson\"\n[[shot]]\n", source);
        return message_of<InputError>(
            [&] { make_stage(film, looked_runs().first(), film_size(film)); });
    };
    EXPECT_NE(refusal("/films/f.toml").find("/films/none.geojson"), std::string::npos)
        << refusal("/films/f.toml");
    EXPECT_EQ(refusal("/films/f.mp4"),
              "/films/f.mp4:2: layer.0.file: a film within a movie or picture reads no files; "
              "write it to a film file of your own");
}

TEST(FilmLooks, ContoursHoldOneIntervalOverAFilm) {
    const ScratchFolder folder;
    const FilmRuns runs = run_of(folder, 100);
    const StoredBeds& beds = runs.first();
    const auto range_of = [](const Grid& bed) {
        return std::pair(std::ranges::min(bed.values()), std::ranges::max(bed.values()));
    };
    auto [low, high] = range_of(beds.first().bed);
    const double of_first = contour_interval(low, high);
    for (std::size_t number = 0; number < beds.beds().size(); ++number) {
        const auto [least, most] = range_of(beds.snapshot(number)->bed);
        low = std::min(low, least);
        high = std::max(high, most);
    }
    const double of_all = contour_interval(low, high);
    ASSERT_NE(of_first, of_all);
    const auto first_frame = [&](const std::string& interval) {
        return frame_of_film(
            "[[shot]]\nfrom = \"start\"\nto = \"end\"\nseconds = 2\n[[layer]]\n"
            "data = \"contours\"\nhidden = \"show\"\ninterval = " +
                interval + "\n",
            0, runs);
    };
    EXPECT_EQ(first_frame("\"auto\""), first_frame(fmt::format("{}", of_all)));
    EXPECT_NE(first_frame("\"auto\""), first_frame(fmt::format("{}", of_first)));
}

TEST(FilmLooks, FitTheRun) {
    const auto look_of = [](const std::string& text) {
        const Film film = parse_film(text, "f.toml");
        return make_stage(film, looked_runs().first(), film_size(film)).scene.view;
    };
    EXPECT_EQ(look_of("[look]\npreset = \"gypsum\"\nexposure = 1\n[[shot]]\n").look.exposure, 1.0);
    EXPECT_EQ(look_of("[[person]]\nat = [2, 2]\n[[shot]]\n").persons.size(), 1U);
    EXPECT_EQ(message_of<InputError>([&] { look_of("[sun]\nhours = 3\n[[shot]]\n"); }),
              "f.toml:2:9: sun.hours needs sun.place and sun.time");
}

}  // namespace
}  // namespace fumon
