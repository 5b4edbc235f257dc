#pragma once

#include <vector>

#include "base/image.h"
#include "figure/canvas/canvas_box.h"
#include "figure/overlays/frame_view.h"
#include "figure/overlays/overlay.h"

namespace fumon {

/// Lines of equal height over frames (look.contours), where the camera sees the ground they lie on.
class FrameContours {
  public:
    /// Of the frames of a scene, which outlives them. `font_size` in pixels.
    FrameContours(const OverlayScene& on, double font_size);

    /// Draws those of a frame's bed over it; labels keep away from boxes that are `taken`, and
    /// are taken then. Throws InputError as ground_contours() does.
    void draw(Image& image, const OverlayFrame& frame, std::vector<CanvasBox>& taken,
              double opacity) const;

  private:
    FrameView view_;
};

}  // namespace fumon
