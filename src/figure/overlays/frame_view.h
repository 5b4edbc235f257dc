#pragma once

#include <functional>

#include "base/image.h"
#include "figure/canvas/canvas.h"
#include "figure/canvas/canvas_box.h"
#include "figure/overlays/overlay.h"
#include "figure/panels/ground_axes.h"
#include "render/view/block.h"

namespace fumon {

/// How the frames of a scene see the ground, for lines that lie on it.
class FrameView {
  public:
    /// Of the frames of a scene, which outlives them. `font_size` in pixels.
    FrameView(const OverlayScene& on, double font_size);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    /// The run's first snapshot, as it is drawn.
    [[nodiscard]] const Snapshot& first() const { return first_; }

    /// A frame's ground as it is drawn, its view, and a canvas over the whole picture.
    using Drawing =
        std::function<void(Canvas& canvas, const Snapshot& snapshot, const ViewProjection& view)>;
    /// Lays over a frame what is drawn on a transparent canvas.
    void draw_over(Image& image, const OverlayFrame& frame, double opacity,
                   const Drawing& draw) const;

  private:
    const Scene& scene_;
    Snapshot first_;
    Block block_;
    double font_size_;
};

}  // namespace fumon
