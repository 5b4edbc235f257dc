#include "film/timeline.h"

#include <algorithm>
#include <cmath>

namespace fumon {

namespace {

/// A piece ends with its film at the latest, whose frames are whole ones.
double excerpt_seconds(const Excerpt& excerpt, double rate) {
    Film whole = *excerpt.read;
    whole.settings.rate = rate;
    const double end = static_cast<double>(Timeline(whole).frames()) / rate;
    return (excerpt.to.is_word() ? end : std::min(end, excerpt.to.value)) - excerpt.from;
}

}  // namespace

Timeline::Timeline(const Film& film) : rate_(film.settings.rate) {
    const auto add_cards = [&](CardPosition place) {
        for (std::size_t i = 0; i < film.cards.size(); ++i) {
            const Card& card = film.cards[i];
            if (card.place != place || card.ground == CardBackground::picture) continue;
            add({FilmPart::Kind::card, i}, card.seconds,
                place == CardPosition::end ? card.fade : 0.0);
        }
    };
    add_cards(CardPosition::start);
    const bool after_card = !parts_.empty();
    shots_begin_ = frames_;
    const auto overlap_of = [&](const auto& piece, std::size_t number) {
        const double overlap =
            piece.transition == Transition::cross_fade ? piece.transition_seconds : 0.0;
        if (number > 0 || !after_card || overlap > 0.0) return overlap;
        return film.cards[parts_.back().number].fade;
    };
    for (std::size_t i = 0; i < film.excerpts.size(); ++i) {
        const Excerpt& excerpt = film.excerpts[i];
        FilmPart part{FilmPart::Kind::excerpt, i};
        part.begin = std::lround(excerpt.from * rate_);
        add(part, excerpt_seconds(excerpt, rate_), overlap_of(excerpt, i));
        if (i == 0) shots_begin_ = parts_.back().first;
    }
    for (std::size_t i = 0; i < film.shots.size(); ++i) {
        const Shot& shot = film.shots[i];
        const double overlap = overlap_of(shot, i);
        FilmPart part{FilmPart::Kind::shot, i};
        part.held = std::lround(shot.hold * rate_);
        add(part, shot.seconds, overlap);
        if (i == 0) shots_begin_ = parts_.back().first;
    }
    shots_end_ = frames_;
    add_cards(CardPosition::end);
}

void Timeline::add(FilmPart part, double seconds, double overlap) {
    part.frames = std::max<std::int64_t>(1, std::lround(seconds * rate_));
    if (!parts_.empty()) {
        const std::int64_t most = std::min(part.frames, parts_.back().frames) / 2;
        part.overlap = std::min<std::int64_t>(std::lround(overlap * rate_), most);
    }
    part.held = std::min(part.held, part.frames - 1);
    part.first = frames_ - part.overlap;
    frames_ = part.first + part.frames;
    parts_.push_back(part);
}

std::vector<FramePart> Timeline::at(std::int64_t frame) const {
    std::vector<FramePart> shown;
    for (const FilmPart& part : parts_) {
        const std::int64_t within = frame - part.first;
        if (within < 0 || within >= part.frames) continue;
        const std::int64_t moving = part.frames - part.held;
        const double share =
            moving > 1
                ? std::min(1.0, static_cast<double>(within) / static_cast<double>(moving - 1))
                : 0.0;
        double weight = 1.0;
        if (within < part.overlap) {
            weight = static_cast<double>(within + 1) / static_cast<double>(part.overlap + 1);
            if (!shown.empty()) shown.front().weight = 1.0 - weight;
        }
        shown.push_back({&part, share, weight, frame});
    }
    return shown;
}

FramePart Timeline::shot_at(std::int64_t frame) const {
    std::vector<FramePart> shown = at(frame);
    std::erase_if(shown,
                  [](const FramePart& one) { return one.part->kind == FilmPart::Kind::card; });
    return shown.back();
}

}  // namespace fumon
