#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "figure/canvas/canvas.h"
#include "figure/plot/coordinate_scale.h"

namespace fumon {

/// Where an axis of coordinates runs over a picture.
struct CoordinateAxis {
    CoordinateScale scale;
    double length = 0.0;  ///< metres or sites from the bed's south-west corner
    /// Where a place so many metres or sites along it is seen; nothing where it is not.
    std::function<std::optional<CanvasPoint>(double)> seen;
    /// Which way its ticks point there, as long as there is room: a unit vector.
    std::function<CanvasPoint(double)> outward;
    bool upright = false;  ///< whether its texts read from below
};

/// A tick with its text.
struct CoordinateMark {
    CanvasPoint from;
    CanvasPoint to;
    std::string text;
    CanvasBox box;  ///< of the text
    bool upright = false;
};

/// The marks of some axes: each has the most, up to eight, whose texts do not overlap one another.
/// Of these, those are left out whose texts leave `room` or come near boxes that are `taken` or
/// texts of the axes before. An axis that would lose more than half of its marks has them on its
/// other side, where more have room there.
std::vector<CoordinateMark> coordinate_marks(const Canvas& canvas,
                                             std::span<const CoordinateAxis> axes,
                                             std::span<const CanvasBox> taken,
                                             const CanvasBox& room);

}  // namespace fumon
