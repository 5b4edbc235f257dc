#pragma once

#include <vector>

#include "base/snapshot.h"
#include "figure/canvas/canvas.h"
#include "figure/ground/ground_contours.h"
#include "figure/panels/ground_axes.h"

namespace fumon {

/// A line, or the part of one that is seen, on a canvas.
struct CanvasContour {
    double level = 0.0;
    std::vector<CanvasPoint> points;
};

/// The parts of a snapshot's lines that a view sees.
std::vector<CanvasContour> visible_contours(const GroundContours& contours,
                                            const Snapshot& snapshot, const ViewProjection& view);

/// Strokes lines within a frame and writes heights into gaps of the thick ones, where these are
/// straight. Labels keep away from one another, from `taken` and from the frame's edges. Returns
/// what is taken then.
std::vector<CanvasBox> draw_contours(Canvas& canvas, const CanvasBox& frame,
                                     const std::vector<CanvasContour>& lines, double interval,
                                     std::vector<CanvasBox> taken = {});

}  // namespace fumon
