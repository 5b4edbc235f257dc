#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/image.h"
#include "base/worker_pool.h"
#include "figure/overlays/frame_overlays.h"
#include "film/beds/blended_bed.h"
#include "film/beds/film_runs.h"
#include "film/cache/picture_cache.h"
#include "film/camera/moves.h"
#include "film/camera/stage.h"
#include "film/film_frames.h"
#include "film/panes.h"
#include "film/picture_prefetch.h"
#include "film/timeline.h"
#include "film/titles.h"
#include "gl/context.h"
#include "keys/override.h"
#include "render/renderer.h"
#include "run/frame_painter.h"

namespace fumon {

/// Draws the frames of a film from the stored beds of a run, or of several side by side, any of
/// them at any time. What must not jump is the same in all frames and all runs: the exaggeration,
/// the palette's range and the axes of plots (over all stored beds that the film shows), the places
/// of overlays.
class FilmPainter : public FilmFrames {
  public:
    /// All shots have the film's look, changed by `looks`. Film and runs outlive it. Throws
    /// InputError, located, where the film does not fit the runs. Pictures are taken from `cache`
    /// where they are there, and put there; none: all are drawn.
    FilmPainter(const Film& film, const FilmRuns& runs, const FilmSize& size,
                const TitleFacts& facts, gl::Backend backend, WorkerPool& pool,
                const std::vector<Override>& looks = {}, PictureCache* cache = nullptr);

    ~FilmPainter() override;

    [[nodiscard]] std::int64_t frames() const override { return timeline_.frames(); }
    [[nodiscard]] const Timeline& timeline() const { return timeline_; }
    /// Of the picture of one run.
    [[nodiscard]] const FilmStage& stage() const { return stage_; }
    [[nodiscard]] const std::vector<StagedShot>& shots() const { return shots_; }
    [[nodiscard]] FilmSize size() const override { return size_; }
    [[nodiscard]] bool transparent() const override;
    /// Throws Error where OpenGL fails.
    Image paint(std::int64_t frame) override;
    LayeredImage light(std::int64_t frame) override;
    void close() override;

    /// A part of a frame with its overlays, without captions and cards over it, but darkened under
    /// a card.
    Image untitled(const FramePart& shown, std::int64_t frame);
    /// The light of a shot's part of a frame.
    LayeredImage light_of(const FramePart& shown);
    /// Writes the captions and cards of a frame over its parts.
    void write_titles(Image& image, std::int64_t frame);

    [[nodiscard]] DrawingRecord record() override;
    [[nodiscard]] const std::vector<std::string>& notes() const override { return notes_; }

  private:
    /// A place among the beds of the first run, with the number of its shot, in step.
    struct Moment {
        std::size_t shot = 0;
        RecordPlace place{};
        friend auto operator<=>(const Moment&, const Moment&) = default;
    };
    /// All that the picture of a run depends on.
    struct ViewState {
        Moment moment;
        CameraPose pose;
        std::int64_t frame = 0;  ///< see PictureRequest
        friend bool operator==(const ViewState&, const ViewState&) = default;
    };
    /// One run's part of the picture.
    struct Pane {
        const StoredBeds* beds = nullptr;
        Scene scene{};                     ///< as the stage's, of this run
        SunSettings sun{};                 ///< of this run's own scene, with the film's look
        std::vector<MeasuredRows> rows{};  ///< up to each bed
        std::unique_ptr<Renderer> renderer{};
        std::unique_ptr<FrameOverlays> overlays{};  ///< what is its own: plots
        std::shared_ptr<const LitBed> lit{};        ///< of its last picture
        std::optional<ViewState> seen{};            ///< likewise
        Image image{};                              ///< likewise, without overlays
        FrameColourRange colours{};                 ///< likewise
        std::optional<Sha256> key{};                ///< of all pictures of its renderer
        std::map<std::size_t, Sha256> bed_keys{};   ///< of its snapshots, by their number
    };

    void open();
    void begin_frame(std::int64_t frame);
    [[nodiscard]] bool differs() const { return film_.panes.show == PanesShow::difference; }
    [[nodiscard]] std::size_t bed_of(std::size_t run, const Moment& moment) const;
    [[nodiscard]] RecordPlace place_of(std::size_t run, const Moment& moment) const;
    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot_of(std::size_t run,
                                                              const Moment& moment) const;
    [[nodiscard]] std::set<Moment> shown_moments() const;
    [[nodiscard]] double pane_letters() const;
    [[nodiscard]] double shared_letters() const;
    void keep_clear(double edge, const TitleFacts& facts);
    void stage_panes(const std::vector<Override>& looks);
    void fix_ranges(const std::set<Moment>& shown);
    /// Frames of a shot and the beds that they show, from the first to the last of the run.
    struct Stretch {
        double frames = 0.0;
        std::size_t first = 0;
        std::size_t last = 0;
    };
    [[nodiscard]] Stretch stillest(const FilmPart& part) const;
    void note_jumps();
    void fix_colours(const std::set<Moment>& shown);
    void fix_contours(const std::set<Moment>& shown);
    void fix_plots(const std::set<Moment>& shown);
    void place_overlays(const FilmSize& size);
    [[nodiscard]] std::vector<PictureRequest> pictures_of(std::int64_t frame) const;
    [[nodiscard]] std::int64_t frame_of(const FramePart& shown) const;
    [[nodiscard]] ViewState view_state_of(const PictureRequest& wanted) const;
    [[nodiscard]] FramePose pose_of(std::size_t run, const ViewState& view_state) const;
    [[nodiscard]] PicturePrefetch::Find preparation_of(std::size_t run,
                                                       const ViewState& view_state);
    Renderer& renderer_of(Pane& pane);
    [[nodiscard]] RenderLimits limits() const;
    Sha256 bed_key(std::size_t run, const Moment& moment);
    [[nodiscard]] Sha256 key_of(std::size_t run, const ViewState& view_state);
    void show(std::size_t run, const PictureRequest& wanted, const ViewState& view_state);
    void prefetch_from(const PictureRequest& present);
    Image picture(std::size_t run, const FramePart& shown);
    Image ground(const FramePart& shown);
    void write_over(Image& image, const FramePart& shown);

    const Film& film_;
    const FilmRuns& runs_;
    FilmSize size_;
    Timeline timeline_;
    Panes layout_;
    FilmStage stage_;
    gl::Backend backend_;
    WorkerPool& pool_;
    PictureCache* cache_;
    std::vector<StagedShot> shots_;
    std::vector<std::string> notes_;
    std::unique_ptr<gl::Context> context_;     ///< while frames are drawn
    std::vector<Pane> panes_;                  ///< of every run
    Scene whole_;                              ///< as the stage's, of the film's size
    std::unique_ptr<FrameOverlays> overlays_;  ///< over the whole picture
    std::unique_ptr<Titles> titles_;
    bool light_ = false;  ///< whether radiances are drawn
    std::int64_t last_frame_ = -2;
    std::vector<PictureRequest> coming_;  ///< of the present frame and, frame after frame, the next
    PicturePrefetch prefetch_;            // last: it uses the renderers
};

}  // namespace fumon
