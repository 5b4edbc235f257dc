#include "run/frame_painter.h"

#include <utility>

#include "figure/canvas/canvas.h"
#include "figure/overlays/frame_overlays.h"
#include "figure/panels/section_figure.h"
#include "gl/pinned.h"
#include "render/renderer.h"
#include "render/view/chosen_ground.h"
#include "scene/overlay_keys.h"

namespace fumon {

namespace {

class BedPainter : public FramePainter {
  public:
    BedPainter(const Scene& scene, const Snapshot& first, gl::Backend backend, WorkerPool& pool)
        : context_(gl::Context::create(backend)),
          renderer_(*context_, scene.view, first, scene.run.steps, pool) {}

    Image paint(const Snapshot& snapshot, const MeasuredRows& /*rows*/) override {
        return renderer_.render(snapshot);
    }
    [[nodiscard]] std::pair<double, double> colour_range() const override {
        return renderer_.colour_range();
    }
    [[nodiscard]] DrawingRecord record() const override {
        const std::string name = context_->renderer_name();
        const std::string obstacle = gl::rendering_is_pinned() ? gl::why_not_pinned(name) : "";
        return {opengl_environment(context_->backend_name(), name, context_->version(),
                                   gl::rendering_is_pinned() && obstacle.empty()),
                obstacle, renderer_.exaggeration(), ""};
    }

  private:
    std::unique_ptr<gl::Context> context_;
    Renderer renderer_;
};

class SectionPainter : public FramePainter {
  public:
    SectionPainter(const Scene& scene, const Snapshot& first)
        : view_(scene.view), exaggeration_(draw_section_figure(view_, first).exaggeration) {}

    Image paint(const Snapshot& snapshot, const MeasuredRows& /*rows*/) override {
        return draw_section_figure(view_, snapshot).image;
    }
    [[nodiscard]] DrawingRecord record() const override {
        RenderingEnvironment environment;
        environment.backend = "cairo";
        environment.renderer = figure_library();
        return {environment, gl::rendering_is_pinned() ? text_is_not_pinned : "", exaggeration_,
                figure_library()};
    }

  private:
    View view_;
    double exaggeration_;
};

/// Lays a scene's overlays over what another painter draws.
class OverlayPainter : public FramePainter {
  public:
    /// The scene outlives it. Throws what FrameOverlays throws.
    OverlayPainter(std::unique_ptr<FramePainter> under, const Scene& scene, const Snapshot& first)
        : under_(std::move(under)), overlays_(scene, first) {}

    Image paint(const Snapshot& snapshot, const MeasuredRows& rows) override {
        Image image = under_->paint(snapshot, rows);
        overlays_.draw(image, {snapshot, rows, under_->colour_range()});
        return image;
    }
    [[nodiscard]] std::pair<double, double> colour_range() const override {
        return under_->colour_range();
    }
    [[nodiscard]] DrawingRecord record() const override {
        DrawingRecord record = under_->record();
        record.text_library = figure_library();
        record.environment.pinned = false;
        if (gl::rendering_is_pinned()) record.why_not_pinned = text_is_not_pinned;
        return record;
    }

  private:
    std::unique_ptr<FramePainter> under_;
    FrameOverlays overlays_;
};

std::unique_ptr<FramePainter> make_bare_painter(const Scene& scene, const Snapshot& first,
                                                gl::Backend backend, WorkerPool& pool) {
    check_background(scene.view, first);
    if (first.section && scene.view.look.mode == ViewMode::figure)
        return std::make_unique<SectionPainter>(scene, first);
    return std::make_unique<BedPainter>(scene, first, backend, pool);
}

}  // namespace

std::unique_ptr<FramePainter> make_frame_painter(const Scene& scene, const Snapshot& first,
                                                 gl::Backend backend, WorkerPool& pool) {
    auto bare = make_bare_painter(scene, first, backend, pool);
    if (!has_overlays(scene)) return bare;
    return std::make_unique<OverlayPainter>(std::move(bare), scene, first);
}

}  // namespace fumon
