#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

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

/// Tells of shots whose ground stands still for some frames and then jumps, and which interval of
/// stored beds would change that. A draft is told what the whole film would show.
void FilmPainter::note_jumps(const std::set<Moment>& shown) {
    constexpr double few = 3.0;  // frames a bed
    const std::vector<StoredBed>& beds = runs_.first().beds();
    for (const FilmPart& part : timeline_.parts()) {
        if (part.kind != FilmPart::Kind::shot) continue;
        std::size_t first = beds.size();
        std::size_t last = 0;
        for (const Moment& moment : shown) {
            if (moment.shot != part.number) continue;
            first = std::min(first, moment.bed);
            last = std::max(last, moment.bed);
        }
        const double frames =
            film_.settings.frames_for_one * static_cast<double>(part.frames - part.held);
        if (last <= first || frames <= few * static_cast<double>(last - first + 1)) continue;
        const std::int64_t steps = beds[last].step - beds[first].step;
        const auto fitting = static_cast<std::int64_t>(2.0 * static_cast<double>(steps) / frames);
        const std::string remedy = fitting >= 1
                                       ? fmt::format(
                                             "for a smoother film run the scene with --set "
                                             "output.fields_every={}",
                                             fitting)
                                       : "for a smoother film shorten the shot, or show more steps";
        notes_.push_back(fmt::format(
            "shot {}: its {:.0f} frames show {} stored beds, each as it is, so that the ground "
            "moves in jumps; {}",
            part.number + 1, frames, last - first + 1, remedy));
    }
}

}  // namespace fumon
