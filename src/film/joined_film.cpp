#include "film/joined_film.h"

#include <fmt/format.h>

#include <utility>

#include "base/error.h"

namespace fumon {

JoinedFilm::JoinedFilm(const Film& film, const FilmRuns& runs, const FilmSize& size,
                       const TitleFacts& facts, gl::Backend backend, WorkerPool& pool)
    : film_(film),
      runs_(runs),
      size_(size),
      facts_(facts),
      backend_(backend),
      pool_(pool),
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
    // One after the other: what is wrong with any is said before the first frame is drawn.
    for (std::size_t i = 0; i < film.excerpts.size(); ++i) {
        for (const std::string& note : piece(i).painter->notes())
            notes_.push_back(fmt::format("excerpt {}: {}", i + 1, note));
    }
    record_ = pieces_.begin()->second.painter->record();
    pieces_.clear();
}

Film JoinedFilm::film_of(std::size_t number) const {
    Film film = *film_.excerpts[number].read;
    std::string title = std::move(film.settings.title);
    film.settings = film_.settings;
    film.settings.title = std::move(title);
    return film;
}

JoinedFilm::Piece& JoinedFilm::piece(std::size_t number) {
    if (const auto found = pieces_.find(number); found != pieces_.end()) return found->second;
    std::erase_if(pieces_, [&](const auto& one) { return one.first + 1 != number; });
    const auto run = static_cast<std::size_t>(film_.excerpts[number].run - 1);
    Piece& made =
        pieces_.emplace(number, Piece{film_of(number), runs_.only(run), nullptr}).first->second;
    made.painter =
        std::make_unique<FilmPainter>(made.film, made.runs, size_, facts_, backend_, pool_);
    return made;
}

bool JoinedFilm::transparent() const {
    return film_.settings.background == FilmGround::transparent;
}

Image JoinedFilm::ground(const PartOfFrame& shown, std::int64_t frame) {
    const FilmPart& part = *shown.part;
    if (part.kind == FilmPart::Kind::card) {
        return titles_->card(part.number, shown.share, [&](std::int64_t beside) {
            return ground(timeline_.shot_at(beside), beside);
        });
    }
    return piece(part.number).painter->paint(part.begin + frame - part.first);
}

Image JoinedFilm::paint(std::int64_t frame) {
    const std::vector<PartOfFrame> shown = timeline_.at(frame);
    Image image = ground(shown.front(), frame);
    if (shown.size() > 1)
        image = mixed(std::move(image), ground(shown.back(), frame), shown.back().weight);
    titles_->draw(image, frame);
    return image;
}

std::unique_ptr<FilmFrames> film_frames(const Film& film, const FilmRuns& runs,
                                        const TitleFacts& facts, gl::Backend backend,
                                        WorkerPool& pool) {
    const FilmSize size = film_size(film);
    if (!film.excerpts.empty())
        return std::make_unique<JoinedFilm>(film, runs, size, facts, backend, pool);
    return std::make_unique<FilmPainter>(film, runs, size, facts, backend, pool);
}

}  // namespace fumon
