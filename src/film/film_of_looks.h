#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "film/cache/picture_cache.h"
#include "film/film_frames.h"
#include "film/film_painter.h"
#include "film/timeline.h"
#include "gl/context.h"

namespace fumon {

/// Draws a film of which some shots have a look of their own. From one to the next the looks change
/// as the transition says: at once, or both pictures are mixed. The ranges of colours and plots are
/// those of the whole film. No more than two looks hold OpenGL at a time.
class FilmOfLooks : public FilmFrames {
  public:
    /// Film, runs and pool outlive it. Throws InputError as FilmPainter.
    FilmOfLooks(const Film& film, const FilmRuns& runs, const FilmSize& size,
                const TitleFacts& facts, gl::Backend backend, WorkerPool& pool,
                PictureCache* cache = nullptr);

    [[nodiscard]] std::int64_t frames() const override { return timeline_.frames(); }
    [[nodiscard]] FilmSize size() const override { return painters_.front()->size(); }
    [[nodiscard]] bool transparent() const override;
    Image paint(std::int64_t frame) override;
    LayeredImage light(std::int64_t frame) override;
    void close() override;
    /// Of the first shot.
    [[nodiscard]] DrawingRecord record() override;
    [[nodiscard]] const std::vector<std::string>& notes() const override;

  private:
    void close_all_but(std::size_t first, std::size_t second);
    [[nodiscard]] std::size_t painter_of(const FramePart& shown) const;

    const Film& film_;
    Timeline timeline_;
    std::vector<std::unique_ptr<FilmPainter>> painters_;  ///< one for each look
    std::vector<std::size_t> painter_of_shot_;
};

/// What draws a film of shots: a FilmOfLooks where they differ in their looks, else a FilmPainter.
/// Arguments outlive it.
std::unique_ptr<FilmFrames> shots_frames(const Film& film, const FilmRuns& runs,
                                         const FilmSize& size, const TitleFacts& facts,
                                         gl::Backend backend, WorkerPool& pool,
                                         PictureCache* cache = nullptr);

}  // namespace fumon
