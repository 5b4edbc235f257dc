#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "film/beds/film_runs.h"
#include "film/cache/picture_cache.h"
#include "film/film_frames.h"
#include "film/script/film.h"
#include "film/script/film_sizes.h"
#include "film/timeline.h"
#include "film/titles.h"
#include "gl/context.h"

namespace fumon {

/// Draws a film of pieces of other films, each of a run of its own, with cards and captions over
/// all. No more than two of them hold OpenGL at a time.
class JoinedFilm : public FilmFrames {
  public:
    /// Film, runs and pool outlive it. Throws InputError, located, where a piece asks for a run
    /// that there is not, and as FilmPainter for every piece.
    JoinedFilm(const Film& film, const FilmRuns& runs, const FilmSize& size,
               const TitleFacts& facts, gl::Backend backend, WorkerPool& pool,
               PictureCache* cache = nullptr);

    [[nodiscard]] std::int64_t frames() const override { return timeline_.frames(); }
    [[nodiscard]] FilmSize size() const override { return size_; }
    [[nodiscard]] bool transparent() const override;
    Image paint(std::int64_t frame) override;
    void close() override;
    /// Of the first piece.
    [[nodiscard]] DrawingRecord record() override;
    [[nodiscard]] const std::vector<std::string>& notes() const override { return notes_; }

  private:
    /// A film of which excerpts show a part, and its run.
    struct Piece {
        Piece(Film film_, FilmRuns runs_, const JoinedFilm& whole);
        Film film;
        FilmRuns runs;
        std::unique_ptr<FilmFrames> painter;
    };

    [[nodiscard]] Film film_of(std::size_t number) const;
    void place_piece(std::size_t number);
    FilmFrames& painter(std::size_t number);
    Image ground(const FramePart& shown, std::int64_t frame);

    const Film& film_;
    const FilmRuns& runs_;
    FilmSize size_;
    TitleFacts facts_;
    gl::Backend backend_;
    WorkerPool& pool_;
    PictureCache* cache_;
    Timeline timeline_;
    std::unique_ptr<Titles> titles_;
    std::vector<std::unique_ptr<Piece>> pieces_;
    std::vector<std::size_t> piece_of_;  ///< of each excerpt, in pieces_
    std::optional<DrawingRecord> record_;
    std::vector<std::string> notes_;
};

/// What draws a film: a JoinedFilm where it has excerpts, a FilmOfLooks where its shots differ in
/// their looks, else a FilmPainter. Arguments outlive it.
std::unique_ptr<FilmFrames> film_frames(const Film& film, const FilmRuns& runs,
                                        const TitleFacts& facts, gl::Backend backend,
                                        WorkerPool& pool, PictureCache* cache = nullptr);

}  // namespace fumon
