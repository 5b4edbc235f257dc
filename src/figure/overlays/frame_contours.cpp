#include "figure/overlays/frame_contours.h"

#include <utility>

#include "figure/panels/contours.h"

namespace fumon {

FrameContours::FrameContours(const OverlayScene& on, double font_size) : view_(on, font_size) {}

void FrameContours::draw(Image& image, const OverlayFrame& frame, std::vector<CanvasBox>& taken,
                         double opacity) const {
    view_.draw_over(
        image, frame, opacity,
        [&](Canvas& canvas, const Snapshot& snapshot, const ViewProjection& view) {
            const auto contours = ground_contours(view_.scene().view.look.contours, snapshot);
            if (!contours) return;
            taken = draw_contours(canvas, view.picture, visible_contours(*contours, snapshot, view),
                                  contours->interval, std::move(taken));
        });
}

}  // namespace fumon
