#pragma once

#include <map>
#include <memory>

#include "base/worker_pool.h"
#include "film/film_frames.h"
#include "film/film_painter.h"
#include "film/timeline.h"
#include "film/titles.h"
#include "gl/context.h"

namespace fumon {

/// Draws a film of pieces of other films, each of a run of its own, with cards and captions over
/// all. What draws a piece is made when it is reached and let go after it, so that no more than two
/// are there at a time.
class JoinedFilm : public FilmFrames {
  public:
    /// Film, runs and pool outlive it. Throws InputError, located, where a piece asks for a run
    /// that there is not, and as FilmPainter for every piece.
    JoinedFilm(const Film& film, const FilmRuns& runs, const FilmSize& size,
               const TitleFacts& facts, gl::Backend backend, WorkerPool& pool);

    [[nodiscard]] std::int64_t frames() const override { return timeline_.frames(); }
    [[nodiscard]] FilmSize size() const override { return size_; }
    [[nodiscard]] bool transparent() const override;
    Image paint(std::int64_t frame) override;
    [[nodiscard]] DrawingRecord record() const override { return record_; }
    [[nodiscard]] const std::vector<std::string>& notes() const override { return notes_; }

  private:
    /// What draws one piece.
    struct Piece {
        Film film;
        FilmRuns runs;
        std::unique_ptr<FilmPainter> painter;
    };

    [[nodiscard]] Film film_of(std::size_t number) const;
    Piece& piece(std::size_t number);
    Image ground(const PartOfFrame& shown, std::int64_t frame);

    const Film& film_;
    const FilmRuns& runs_;
    FilmSize size_;
    TitleFacts facts_;
    gl::Backend backend_;
    WorkerPool& pool_;
    Timeline timeline_;
    std::unique_ptr<Titles> titles_;
    std::map<std::size_t, Piece> pieces_;
    DrawingRecord record_;
    std::vector<std::string> notes_;
};

/// What draws a film: a JoinedFilm where it has excerpts, else a FilmPainter. Arguments outlive it.
std::unique_ptr<FilmFrames> film_frames(const Film& film, const FilmRuns& runs,
                                        const TitleFacts& facts, gl::Backend backend,
                                        WorkerPool& pool);

}  // namespace fumon
