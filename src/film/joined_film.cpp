#include "film/joined_film.h"

#include <fmt/format.h>

#include <utility>

#include "base/error.h"
#include "film/film_of_looks.h"

namespace fumon {

JoinedFilm::JoinedFilm(const Film& film, const FilmRuns& runs, const FilmSize& size,
                       const TitleFacts& facts, gl::Backend backend, WorkerPool& pool,
                       PictureCache* cache)
    : film_(film),
      runs_(runs),
      size_(size),
      facts_(facts),
      backend_(backend),
      pool_(pool),
      cache_(cache),
      timeline_(film) {
    for (std::size_t i = 0; i < film.excerpts.size(); ++i) {
        const auto run = static_cast<std::size_t>(film.excerpts[i].run);
        if (run <= runs.size()) continue;
        const std::string key = fmt::format("excerpt.{}.run", i);
        throw InputError(fmt::format("{}{} = {}, and {} {} given", film.at(key), key, run,
                                     runs.size(), runs.size() == 1 ? "run is" : "runs are"));
    }
    FilmStage whole{runs.first().scene(), {}, 1.0};
    whole.scene.view.image.width = size.width;
    whole.scene.view.image.height = size.height;
    titles_ = std::make_unique<Titles>(film, whole, runs.first().first(), facts, timeline_,
                                       std::vector<CanvasBox>{});
    if (!titles_->missing_letters().empty()) notes_.push_back(titles_->missing_letters());
    // What is wrong with any is said before the first frame is drawn.
    for (std::size_t i = 0; i < film.excerpts.size(); ++i) {
        place_piece(i);
        for (const std::string& note : pieces_[piece_of_[i]]->painter->notes())
            notes_.push_back(fmt::format("excerpt {}: {}", i + 1, note));
    }
}

Film JoinedFilm::film_of(std::size_t number) const {
    Film film = *film_.excerpts[number].read;
    std::string title = std::move(film.settings.title);
    film.settings = film_.settings;
    film.settings.title = std::move(title);
    film.found_layers = film_.found_layers;
    film.looks.insert(film.looks.end(), film_.looks.begin(), film_.looks.end());
    return film;
}

/// Excerpts of one film and one run have the same piece.
void JoinedFilm::place_piece(std::size_t number) {
    const Excerpt& excerpt = film_.excerpts[number];
    for (std::size_t before = 0; before < number; ++before) {
        const Excerpt& other = film_.excerpts[before];
        if (other.film != excerpt.film || other.run != excerpt.run) continue;
        piece_of_.push_back(piece_of_[before]);
        return;
    }
    piece_of_.push_back(pieces_.size());
    pieces_.push_back(std::make_unique<Piece>(
        film_of(number), runs_.only(static_cast<std::size_t>(excerpt.run - 1)), *this));
}

JoinedFilm::Piece::Piece(Film film_, FilmRuns runs_, const JoinedFilm& whole)
    : film(std::move(film_)),
      runs(std::move(runs_)),
      painter(shots_frames(film, runs, whole.size_, whole.facts_, whole.backend_, whole.pool_,
                           whole.cache_)) {}

FilmFrames& JoinedFilm::painter(std::size_t number) {
    const std::size_t wanted = piece_of_[number];
    const std::size_t before = piece_of_[number == 0 ? 0 : number - 1];  // a cross-fade's
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece)
        if (piece != wanted && piece != before) pieces_[piece]->painter->close();
    return *pieces_[wanted]->painter;
}

void JoinedFilm::close() {
    for (const auto& piece : pieces_) piece->painter->close();
}

DrawingRecord JoinedFilm::record() {
    if (!record_) record_ = painter(0).record();
    return *record_;
}

bool JoinedFilm::transparent() const {
    return film_.settings.background == FilmBackground::transparent;
}

Image JoinedFilm::ground(const FramePart& shown, std::int64_t frame) {
    const FilmPart& part = *shown.part;
    if (part.kind == FilmPart::Kind::card) {
        return titles_->card(part.number, shown.share, [&](std::int64_t beside) {
            return ground(timeline_.shot_at(beside), beside);
        });
    }
    FilmFrames& drawn = painter(part.number);
    Image image = drawn.paint(part.begin + frame - part.first);
    if (!record_ && piece_of_[part.number] == 0) record_ = drawn.record();
    return image;
}

Image JoinedFilm::paint(std::int64_t frame) {
    const std::vector<FramePart> shown = timeline_.at(frame);
    Image image = ground(shown.front(), frame);
    if (shown.size() > 1)
        image = mixed(std::move(image), ground(shown.back(), frame), shown.back().weight);
    titles_->darken(image, frame);
    titles_->draw(image, frame);
    return image;
}

std::unique_ptr<FilmFrames> film_frames(const Film& film, const FilmRuns& runs,
                                        const TitleFacts& facts, gl::Backend backend,
                                        WorkerPool& pool, PictureCache* cache) {
    const FilmSize size = film_size(film);
    if (!film.excerpts.empty())
        return std::make_unique<JoinedFilm>(film, runs, size, facts, backend, pool, cache);
    return shots_frames(film, runs, size, facts, backend, pool, cache);
}

}  // namespace fumon
