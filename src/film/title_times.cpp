#include "film/title_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "base/error.h"
#include "film/timeline.h"

namespace fumon {

namespace {

/// Half a millisecond, the finest that a file of captions tells.
constexpr double slack = 5e-4;  // seconds

void check_caption(const Film& film, std::size_t number, double film_seconds) {
    const Caption& caption = film.captions[number];
    const std::string path = fmt::format("caption.{}", number);
    if (caption.to > film_seconds + slack) {
        throw InputError(fmt::format("{}{}.to = {} is after the film's end, at {:.4g} s",
                                     film.at(path + ".to"), path, caption.to, film_seconds));
    }
    for (std::size_t i = 0; i < number; ++i) {
        const Caption& other = film.captions[i];
        if (caption.from >= other.to - slack || other.from >= caption.to - slack) continue;
        throw InputError(fmt::format(
            "{}{} (from {} to {} s, \"{}\") is shown at the same time as caption.{} (from {} to {} "
            "s, \"{}\"); let one end where the other begins",
            film.at(path + ".from"), path, caption.from, caption.to, caption.text, i, other.from,
            other.to, other.text));
    }
}

/// Seconds of the film's shots in which a card over the picture is seen.
struct CardSpan {
    std::size_t number;
    double begin;
    double end;
};

void check_cards(const Film& film, double begin, double end, Faults& faults) {
    std::optional<CardSpan> before;
    for (std::size_t i = 0; i < film.cards.size(); ++i) {
        const Card& card = film.cards[i];
        if (card.ground != CardBackground::picture) continue;
        const std::string path = fmt::format("card.{}", i);
        const double length = end - begin;
        faults.attempt([&] {
            if (card.seconds <= length + slack || card.seconds == Card{}.seconds) return;
            throw InputError(fmt::format(
                "{}{}.seconds = {} is longer than the film's shots, {:.4g} s; write less, or "
                "ground = \"dark\", which lets it stand before or after them",
                film.at(path + ".seconds"), path, card.seconds, length));
        });
        const bool first = card.place == CardPosition::start;
        const double seen = std::min(card.seconds, length);
        const CardSpan span{i, first ? begin : end - seen, first ? begin + seen : end};
        faults.attempt([&] {
            if (!before || span.begin >= before->end - slack || before->begin >= span.end - slack)
                return;
            throw InputError(fmt::format(
                "{}{} stands over card.{} for {:.4g} s; shorten one, or write ground = \"dark\"",
                film.at(path + ".place"), path, before->number,
                std::min(span.end, before->end) - std::max(span.begin, before->begin)));
        });
        if (!before) before = span;
    }
}

}  // namespace

void check_title_times(const Film& film, Faults& faults) {
    const Timeline timeline(film);
    const auto seconds = [&](std::int64_t frame) {
        return static_cast<double>(frame) / timeline.rate();
    };
    for (std::size_t i = 0; i < film.captions.size(); ++i)
        faults.attempt([&] { check_caption(film, i, seconds(timeline.frames())); });
    check_cards(film, seconds(timeline.shots_begin()), seconds(timeline.shots_end()), faults);
}

}  // namespace fumon
