#include "run/overlay_painter.h"

#include <utility>

#include "figure/canvas/canvas.h"
#include "gl/pinned.h"

namespace fumon {

OverlayPainter::OverlayPainter(std::unique_ptr<FramePainter> under, const Scene& scene,
                               const Snapshot& first)
    : under_(std::move(under)), overlays_(scene, first) {}

Image OverlayPainter::paint(const Snapshot& snapshot, const MeasuredRows& rows) {
    Image image = under_->paint(snapshot, rows);
    overlays_.draw(image, {snapshot, rows, under_->colour_range()});
    return image;
}

std::pair<double, double> OverlayPainter::colour_range() const {
    return under_->colour_range();
}

DrawingRecord OverlayPainter::record() const {
    DrawingRecord record = under_->record();
    record.text_library = figure_library();
    record.environment.pinned = false;
    if (gl::rendering_is_pinned()) record.why_not_pinned = text_is_not_pinned;
    return record;
}

}  // namespace fumon
