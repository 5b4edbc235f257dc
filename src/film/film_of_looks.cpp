#include "film/film_of_looks.h"

#include <algorithm>
#include <utility>

#include "film/script/film_looks.h"

namespace fumon {

FilmOfLooks::FilmOfLooks(const Film& film, const FilmRuns& runs, const FilmSize& size,
                         const TitleFacts& facts, gl::Backend backend, WorkerPool& pool,
                         PictureCache* cache)
    : film_(film), timeline_(film) {
    for (std::size_t shot = 0; shot < film.shots.size(); ++shot) {
        const auto same = [&](const Shot& other) {
            return same_looks(other.looks, film.shots[shot].looks);
        };
        const auto before = std::ranges::find_if(film.shots, same) - film.shots.begin();
        if (static_cast<std::size_t>(before) < shot) {
            painter_of_shot_.push_back(painter_of_shot_[static_cast<std::size_t>(before)]);
            continue;
        }
        painter_of_shot_.push_back(painters_.size());
        painters_.push_back(std::make_unique<FilmPainter>(film, runs, size, facts, backend, pool,
                                                          film.shots[shot].looks, cache));
    }
}

bool FilmOfLooks::transparent() const {
    return film_.settings.background == FilmBackground::transparent;
}

/// A card has the look of the shot beside it.
std::size_t FilmOfLooks::painter_of(const FramePart& shown) const {
    if (shown.part->kind == FilmPart::Kind::shot) return painter_of_shot_[shown.part->number];
    return film_.cards[shown.part->number].place == CardPosition::start ? painter_of_shot_.front()
                                                                        : painter_of_shot_.back();
}

void FilmOfLooks::close_all_but(std::size_t first, std::size_t second) {
    for (std::size_t look = 0; look < painters_.size(); ++look)
        if (look != first && look != second) painters_[look]->close();
}

LayeredImage FilmOfLooks::light(std::int64_t frame) {
    const std::vector<FramePart> shown = timeline_.at(frame);
    const std::size_t first = painter_of(shown.front());
    const std::size_t second = painter_of(shown.back());
    close_all_but(first, second);
    if (first == second) return painters_[first]->light(frame);
    return mixed(painters_[first]->light_of(shown.front()),
                 painters_[second]->light_of(shown.back()), shown.back().weight);
}

Image FilmOfLooks::paint(std::int64_t frame) {
    const std::vector<FramePart> shown = timeline_.at(frame);
    const std::size_t first = painter_of(shown.front());
    const std::size_t second = painter_of(shown.back());
    close_all_but(first, second);
    if (first == second) return painters_[first]->paint(frame);
    Image image = mixed(painters_[first]->untitled(shown.front(), frame),
                        painters_[second]->untitled(shown.back(), frame), shown.back().weight);
    painters_[first]->write_titles(image, frame);
    return image;
}

void FilmOfLooks::close() {
    for (const auto& painter : painters_) painter->close();
}

DrawingRecord FilmOfLooks::record() {
    return painters_.front()->record();
}

const std::vector<std::string>& FilmOfLooks::notes() const {
    return painters_.front()->notes();
}

std::unique_ptr<FilmFrames> shots_frames(const Film& film, const FilmRuns& runs,
                                         const FilmSize& size, const TitleFacts& facts,
                                         gl::Backend backend, WorkerPool& pool,
                                         PictureCache* cache) {
    const std::vector<Override>& first = film.shots.front().looks;
    const bool differ = std::ranges::any_of(
        film.shots, [&](const Shot& shot) { return !same_looks(shot.looks, first); });
    if (differ) return std::make_unique<FilmOfLooks>(film, runs, size, facts, backend, pool, cache);
    return std::make_unique<FilmPainter>(film, runs, size, facts, backend, pool, first, cache);
}

}  // namespace fumon
