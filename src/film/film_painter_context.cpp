#include "film/film_painter.h"
#include "gl/pinned.h"

namespace fumon {

void FilmPainter::open() {
    if (context_) return;
    context_ = gl::Context::create(backend_);
    RenderLimits limits;
    limits.draft = film_.settings.draft;
    for (Pane& pane : panes_) {
        if (&pane == &panes_.front() || !differs())
            pane.renderer =
                std::make_unique<Renderer>(*context_, pane.scene.view, pane.beds->first(),
                                           pane.scene.run.steps, pool_, limits);
    }
}

void FilmPainter::close() {
    if (!context_) return;
    prefetch_.wait_idle();
    context_->make_current();  // other films may have drawn since
    for (Pane& pane : panes_) {
        pane.renderer.reset();
        pane.lit.reset();
        pane.seen.reset();
        pane.image = {};
    }
    context_.reset();
}

DrawingRecord FilmPainter::record() {
    open();
    const std::string name = context_->renderer_name();
    const std::string obstacle = gl::rendering_is_pinned() ? text_is_not_pinned : "";
    DrawingRecord record{
        opengl_environment(context_->backend_name(), name, context_->version(), false), obstacle,
        panes_.front().renderer->exaggeration(), figure_library()};
    return record;
}

}  // namespace fumon
