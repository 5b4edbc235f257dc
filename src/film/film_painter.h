#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/worker_pool.h"
#include "figure/overlays/frame_overlays.h"
#include "film/moves.h"
#include "film/stage.h"
#include "film/timeline.h"
#include "film/titles.h"
#include "gl/context.h"
#include "render/renderer.h"
#include "run/frame_painter.h"

namespace fumon {

/// Draws the frames of a film from a run's stored beds, any of them at any time. What must not jump
/// is the same in all: the exaggeration, the palette's range and the axes of plots (over all stored
/// beds that the film shows), the places of overlays. Lives on one thread.
class FilmPainter {
  public:
    /// Film and beds outlive it. Throws InputError, located, where the film does not fit the run,
    /// Error where OpenGL fails.
    FilmPainter(const Film& film, const StoredBeds& beds, const FilmSize& size,
                const TitleFacts& facts, gl::Backend backend, WorkerPool& pool);

    [[nodiscard]] std::int64_t frames() const { return timeline_.frames(); }
    [[nodiscard]] const Timeline& timeline() const { return timeline_; }
    [[nodiscard]] const FilmStage& stage() const { return stage_; }
    [[nodiscard]] const std::vector<StagedShot>& shots() const { return shots_; }
    Image paint(std::int64_t frame);

    [[nodiscard]] DrawingRecord record() const;
    /// Lines for the user: letters that no font has, shots that show few beds in many frames.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  private:
    [[nodiscard]] std::set<std::size_t> shown_beds(const FilmPart& part) const;
    void fix_ranges();
    Image ground(const PartOfFrame& shown);
    void write_over(Image& image, const PartOfFrame& shown);

    const Film& film_;
    const StoredBeds& beds_;
    Timeline timeline_;
    FilmStage stage_;
    std::vector<StagedShot> shots_;
    std::vector<std::string> notes_;
    std::vector<MeasuredRows> rows_;
    std::unique_ptr<gl::Context> context_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<FrameOverlays> overlays_;
    std::unique_ptr<Titles> titles_;
};

}  // namespace fumon
