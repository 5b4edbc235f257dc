#pragma once

#include <memory>

#include "figure/overlays/frame_overlays.h"
#include "run/frame_painter.h"

namespace fumon {

/// Lays a scene's overlays over what another painter draws.
class OverlayPainter : public FramePainter {
  public:
    /// The scene outlives it. Throws what FrameOverlays throws.
    OverlayPainter(std::unique_ptr<FramePainter> under, const Scene& scene, const Snapshot& first);

    Image paint(const Snapshot& snapshot, const MeasuredRows& rows) override;
    [[nodiscard]] std::pair<double, double> colour_range() const override;
    [[nodiscard]] DrawingRecord record() const override;

  private:
    std::unique_ptr<FramePainter> under_;
    FrameOverlays overlays_;
};

}  // namespace fumon
