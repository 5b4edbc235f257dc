#include "film/timeline.h"

#include <gtest/gtest.h>

#include "film/titles.h"

namespace fumon {
namespace {

Film film_of_shots(std::vector<double> seconds) {
    Film film;
    film.settings.rate = 10.0;
    for (const double length : seconds) {
        Shot shot;
        shot.seconds = length;
        film.shots.push_back(shot);
    }
    return film;
}

TEST(Timeline, CutsFollowOneAnother) {
    const Timeline timeline(film_of_shots({2.0, 1.0}));
    EXPECT_EQ(timeline.frames(), 30);
    ASSERT_EQ(timeline.at(19).size(), 1U);
    EXPECT_EQ(timeline.at(19).front().part->number, 0U);
    EXPECT_DOUBLE_EQ(timeline.at(19).front().share, 1.0);
    EXPECT_EQ(timeline.at(20).front().part->number, 1U);
    EXPECT_DOUBLE_EQ(timeline.at(20).front().share, 0.0);
}

TEST(Timeline, CrossFadesShowBothShotsAndShortenTheFilm) {
    Film film = film_of_shots({2.0, 2.0});
    film.shots[1].transition = Transition::cross_fade;
    film.shots[1].transition_seconds = 0.5;
    const Timeline timeline(film);
    EXPECT_EQ(timeline.frames(), 35);
    EXPECT_EQ(timeline.at(14).size(), 1U);
    double before = 0.0;
    for (std::int64_t frame = 15; frame < 20; ++frame) {
        const auto shown = timeline.at(frame);
        ASSERT_EQ(shown.size(), 2U);
        EXPECT_DOUBLE_EQ(shown[0].weight + shown[1].weight, 1.0);
        EXPECT_GT(shown[1].weight, before);
        before = shown[1].weight;
    }
    EXPECT_LT(before, 1.0);
    EXPECT_EQ(timeline.at(20).size(), 1U);
}

TEST(Timeline, AHoldKeepsTheLastPicture) {
    Film film = film_of_shots({2.0});
    film.shots[0].hold = 0.5;
    const Timeline timeline(film);
    EXPECT_LT(timeline.at(13).front().share, 1.0);
    for (std::int64_t frame = 14; frame < 20; ++frame)
        EXPECT_DOUBLE_EQ(timeline.at(frame).front().share, 1.0) << frame;
}

TEST(Timeline, DarkAndBlurredCardsStandBeforeAndAfterTheShots) {
    Film film = film_of_shots({2.0});
    for (const CardPosition place : {CardPosition::end, CardPosition::start}) {
        Card card;
        card.place = place;
        card.ground = place == CardPosition::end ? CardBackground::blurred : CardBackground::dark;
        card.seconds = 1.0;
        card.fade = 0.2;
        film.cards.push_back(card);
    }
    const Timeline timeline(film);
    EXPECT_EQ(timeline.frames(), 40 - 2 - 2);
    EXPECT_EQ(timeline.at(0).front().part->kind, FilmPart::Kind::card);
    EXPECT_EQ(timeline.at(0).front().part->number, 1U);
    EXPECT_EQ(timeline.at(20).front().part->kind, FilmPart::Kind::shot);
    EXPECT_EQ(timeline.at(35).front().part->number, 0U);
    EXPECT_EQ(timeline.shots_begin(), 8);
    EXPECT_EQ(timeline.shots_end(), 28);
    for (const std::int64_t frame : {8, 27}) {  // which cards overlap
        EXPECT_EQ(timeline.at(frame).size(), 2U);
        EXPECT_EQ(timeline.shot_at(frame).part->kind, FilmPart::Kind::shot) << frame;
    }
}

TEST(Subrip, HasTheTimesOfTheCaptionsInTheirOrder) {
    EXPECT_EQ(subrip({{62.5, 3723.004, "二\nthe second"}, {0.0, 2.25, "first"}}),
              "1\n00:00:00,000 --> 00:00:02,250\nfirst\n\n"
              "2\n00:01:02,500 --> 01:02:03,004\n二\nthe second\n\n");
}

TEST(BrokenLines, BreakBetweenWordsAndJapaneseBetweenLetters) {
    const Canvas ruler(1, 1, 1.0);
    const double three = ruler.text_size("one two", 20.0)[0] + 1.0;
    EXPECT_EQ(broken_lines(ruler, "one two three", 20.0, false, three),
              (std::vector<std::string>{"one two", "three"}));
    const double letters = ruler.text_size("砂丘砂", 20.0)[0] + 1.0;
    const auto broken = broken_lines(ruler, "砂丘砂丘砂丘砂", 20.0, false, letters);
    ASSERT_EQ(broken.size(), 3U);
    EXPECT_EQ(broken[0], "砂丘砂");
}

}  // namespace
}  // namespace fumon
