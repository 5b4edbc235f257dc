#pragma once

#include <vector>

#include "base/image.h"
#include "figure/canvas/canvas_box.h"
#include "figure/overlays/frame_view.h"
#include "figure/overlays/overlay.h"
#include "scene/view/layers.h"

namespace fumon {

/// The layers of a scene over its frames ([[layer]]), and the edge of its survey under them, where
/// the camera sees the ground they lie on.
class FrameLayers {
  public:
    /// Of the frames of a scene, which outlives them. `font_size` in pixels.
    FrameLayers(const OverlayScene& on, double font_size);

    /// Whether frames of a scene have any.
    [[nodiscard]] static bool has_any(const OverlayScene& on);

    /// Draws them over a frame; labels keep away from boxes that are `taken`.
    void draw(Image& image, const OverlayFrame& frame, const std::vector<CanvasBox>& taken,
              double opacity) const;

  private:
    FrameView view_;
    std::vector<LayerSettings> settings_;
    PlacedLayers placed_;
    double length_x_;  ///< of the bed, metres or sites
    double length_y_;
    bool moves_;
};

}  // namespace fumon
