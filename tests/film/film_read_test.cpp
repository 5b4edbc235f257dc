#include "film/film_read.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "film/cache/byte_size.h"
#include "film/film_output.h"
#include "film/script/film_sizes.h"
#include "run/inputs/scene_argument.h"
#include "scene/read.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;

std::string film_refusal(const std::string& text, const std::vector<std::string>& settings = {}) {
    return message_of<InputError>([&] { parse_film(text, "f.toml", settings); });
}

TEST(FilmRead, TakesShotsKeysCardsAndCaptions) {
    const Film film = parse_film(
        "[film]\nsize = \"vertical\"\n[[shot]]\nseconds = 3\nfrom = 100\nto = \"end\"\npace = "
        "\"change\"\nmove = \"keys\"\n[[shot.key]]\nat = [1, 2, 3]\n[[shot.key]]\nat = [4, 5, "
        "6]\nfocal_length = 85\n[[card]]\ntitle = \"風紋\"\n[[caption]]\nfrom = 1\nto = 2\ntext = "
        "\"a\"\n[[overlay]]\nkind = \"time\"\n",
        "f.toml");
    EXPECT_EQ(film_size(film).width, 1080);
    EXPECT_EQ(film_size(film).height, 1920);
    ASSERT_EQ(film.shots.size(), 1U);
    EXPECT_EQ(film.shots[0].pace, Pace::change);
    EXPECT_EQ(film.shots[0].from.value, 100.0);
    EXPECT_EQ(film.shots[0].to.word, "end");
    ASSERT_EQ(film.shots[0].keys.size(), 2U);
    EXPECT_EQ(film.shots[0].keys[1].focal_length.value, 85.0);
    EXPECT_EQ(film.cards[0].title, "風紋");
    EXPECT_EQ(film.captions[0].to, 2.0);
    EXPECT_EQ(film.overlays.size(), 1U);
    EXPECT_EQ(film_toml(parse_film(film_toml(film), "again")), film_toml(film));
}

TEST(FilmRead, TakesASizeAsItIsWritten) {
    const FilmSize size =
        film_size(parse_film("[film]\nsize = \"1200x630\"\n[[shot]]\n", "f.toml"));
    EXPECT_EQ(size.width, 1200);
    EXPECT_EQ(size.height, 630);
    EXPECT_EQ(film_refusal("[film]\nsize = \"12x9000\"\n[[shot]]\n"),
              "f.toml:2:8: film.size = \"12x9000\": a film has 16 to 8192 pixels along each side");
    EXPECT_EQ(film_size(parse_film("[film]\nsize = \"1920 x 1080\"\n[[shot]]\n", "f.toml")).height,
              1080);
    const std::string unknown = film_refusal("[film]\nsize = \"1200*630\"\n[[shot]]\n");
    EXPECT_TRUE(unknown.starts_with("f.toml:2:8: unknown film.size")) << unknown;
    EXPECT_TRUE(unknown.ends_with(", or pixels as in \"1920x1080\"")) << unknown;
}

TEST(FilmRead, RefusesTitlesThatStandOverOneAnother) {
    EXPECT_EQ(film_refusal("[[shot]]\nseconds = 9\n[[caption]]\nfrom = 1\nto = 4\ntext = \"a\"\n"
                           "[[caption]]\nfrom = 3\nto = 5\ntext = \"b\"\n"),
              "f.toml:8:8: caption.1 (from 3 to 5 s, \"b\") is shown at the same time as caption.0 "
              "(from 1 to 4 s, \"a\"); let one end where the other begins");
    EXPECT_EQ(
        film_refusal("[[shot]]\nseconds = 6\n[[card]]\nseconds = 4\n[[card]]\nplace = \"end\"\n"
                     "seconds = 4\n"),
        "f.toml:6:9: card.1 stands over card.0 for 2 s; shorten one, or write ground = \"dark\"");
    EXPECT_EQ(
        film_refusal("[[shot]]\nseconds = 9\n[[caption]]\nfrom = 4\nto = 6\n[[caption]]\nfrom = 1\n"
                     "to = 4\n[[card]]\nseconds = 5\n[[card]]\nplace = \"end\"\nseconds = 4\n"),
        "");
}

TEST(FilmRead, RefusesTitlesLongerThanTheFilm) {
    EXPECT_EQ(film_refusal("[[shot]]\nseconds = 2\n[[caption]]\nfrom = 50\nto = 53\n"),
              "f.toml:5:6: caption.0.to = 53 is after the film's end, at 2 s");
    EXPECT_EQ(
        film_refusal("[[shot]]\nseconds = 2\n[[card]]\nseconds = 30\n"),
        "f.toml:4:11: card.0.seconds = 30 is longer than the film's shots, 2 s; write less, or "
        "ground = \"dark\", which lets it stand before or after them");
    // One that stands before the shots lengthens the film.
    EXPECT_EQ(film_refusal("[[shot]]\nseconds = 2\n[[card]]\nseconds = 30\nground = \"dark\"\n"
                           "[[caption]]\nfrom = 28\nto = 31\n"),
              "");
}

TEST(FilmRead, KnowsASceneAndWordsOfOtherPrograms) {
    EXPECT_EQ(film_refusal("title = \"dunes\"\n[model]\nname = \"dunes\"\n"),
              "f.toml: is a scene, not a film; run it first (fumon run f.toml -o RUN --set "
              "output.fields_every=20), then cut a film from the run (fumon film RUN FILM)");
    // Also where the model is that of another scene, or is missing.
    EXPECT_TRUE(film_refusal("title = \"dunes\"\n[grid]\nnx = 30\n[bed]\nkind = \"noise\"\n")
                    .starts_with("f.toml: is a scene, not a film; "));
    EXPECT_TRUE(message_of<InputError>([] {
                    film_text("terada-barchans");
                }).starts_with("terada-barchans: is a scene, not a film; "));
    EXPECT_EQ(message_of<InputError>([] { scene_argument("barchans"); }),
              "barchans: is a film, not a scene; a film is cut from a run: fumon film RUN "
              "barchans");
    EXPECT_EQ(film_refusal("[film]\nfps = 25\n[[shot]]\n"),
              "f.toml:2:1: unknown key film.fps; did you mean \"film.rate\"?");
    EXPECT_EQ(message_of<InputError>([] { film_text("barchan"); }),
              "barchan: there is no such file, and no such film ships with fumon; did you mean "
              "\"barchans\"?");
    EXPECT_EQ(
        message_of<InputError>(
            [] { parse_scene("[film]\nrate = 25\n[[shot]]\n", "cut.toml", "."); }),
        "cut.toml: is a film, not a scene; a film is cut from a run: fumon film RUN cut.toml");
}

TEST(FilmRead, LocatesEveryFault) {
    EXPECT_EQ(film_refusal("[[shot]]\nsecond = 3\n[film]\nrat = 3\nquality = \"good\"\n"),
              "f.toml:2:1: unknown key shot.0.second; did you mean \"shot.0.seconds\"?\n"
              "f.toml:4:1: unknown key film.rat; did you mean \"film.rate\"?\n"
              "f.toml:5:11: film.quality is 'good'; it takes a whole number 0 … 51");
    EXPECT_EQ(film_refusal("[film]\nsize = \"2k\"\n[[shot]]\n").substr(0, 37),
              "f.toml:2:8: unknown film.size \"2k\"; d");
    EXPECT_EQ(film_refusal("[film]\n"), "f.toml:1:1: a film needs at least one [[shot]]");
    EXPECT_EQ(film_refusal("[[shot]]\nmove = \"keys\"\n"),
              "f.toml:2:8: shot.0.move = \"keys\" needs at least two [[shot.key]]");
    EXPECT_EQ(film_refusal("[[shot]]\nmove = \"orbit\"\n[[shot.key]]\nat = [0, 0, 1]\n"),
              "f.toml:2:8: shot.0 has [[shot.key]] and a predefined move; write move = \"keys\"");
    EXPECT_EQ(film_refusal("[[shot]]\n[[shot.key]]\nat = [0, 1]\n"),
              "f.toml:3:6: shot.0.key.0.at has 2 numbers; it takes three: east, north, above the "
              "bed");
    EXPECT_EQ(film_refusal("[[shot]]\n[[caption]]\nfrom = 3\nto = 2\n"),
              "f.toml:4:6: caption.0.to = 2 is not after its from = 3");
    EXPECT_EQ(film_refusal("[[shot]]\nseconds = 1\ntransition = \"cross-fade\"\n"),
              "f.toml: shot.0.transition_seconds = 1 is more than half of the shorter shot (1 s)");
    EXPECT_EQ(film_refusal("[[shot]]\n", {"film.siz=4k"}),
              "--set 1:1: unknown key film.siz; did you mean \"film.size\"?");
    EXPECT_EQ(film_size(parse_film("[[shot]]\n", "f.toml", {"film.size=4k"})).width, 3840);
}

TEST(FilmOutput, NamesAFileForEachPurpose) {
    const Film film = parse_film("[[shot]]\n", "f.toml");
    const auto outputs = film_outputs(film, "a/b.mp4", {"talk", "social", "readme", "poster"}, 0);
    ASSERT_EQ(outputs.size(), 4U);
    EXPECT_EQ(outputs[0].file, "a/b-talk.mp4");
    EXPECT_EQ(film_size(outputs[1].film).height, 1920);
    EXPECT_EQ(outputs[2].file, "a/b-readme.webp");
    EXPECT_EQ(outputs[2].most_bytes, 3'000'000);
    EXPECT_EQ(outputs[3].file, "a/b-poster.png");
    EXPECT_THROW(film_outputs(film, "b.mp4", {"gift"}, 0), InputError);
    EXPECT_THROW(film_outputs(film, "b.avi", {}, 0), InputError);
    EXPECT_EQ(film_outputs(film, "b.WEBM", {}, 0).front().film.settings.format, "webm");
    const FilmOutput draft = draft_output(film, "b.mp4");
    EXPECT_EQ(draft.file, "b-draft.mp4");
    EXPECT_EQ(draft.sheet, "b-draft.png");
    EXPECT_EQ(film_size(draft.film).width, 480);
    EXPECT_EQ(draft.film.settings.rate, 3.0);
    EXPECT_NE(film_toml(draft.film).find("draft = true"), std::string::npos);
    EXPECT_EQ(film_toml(film).find("draft"), std::string::npos) << "other films keep their bytes";
    EXPECT_EQ(bytes_of_size("8MB"), 8'000'000);
    EXPECT_EQ(bytes_of_size("1.5kB"), 1500);
    EXPECT_THROW(bytes_of_size("8 MB"), InputError);
    EXPECT_THROW(bytes_of_size("-8MB"), InputError);
}

}  // namespace
}  // namespace fumon
