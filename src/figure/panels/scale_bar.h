#pragma once

#include <string>

#include "figure/canvas/furniture.h"
#include "figure/panels/ground_axes.h"

namespace fumon {

/// The greatest of 1, 2 and 5 times a power of ten up to a length above 0.
double round_length(double longest);

/// A bar of a round length.
struct ScaleBar {
    double length = 0.0;  ///< of the ground, metres or sites
    double drawn = 0.0;   ///< on the canvas, units
    std::string text;     ///< "50 m", "20 sites"
};

/// The longest bar of 1, 2 or 5 times a power of ten metres (sites without metres) that is not
/// longer than `longest` units, where a metre (a site) takes `units_per_length` of them. Both
/// above 0.
ScaleBar round_scale_bar(bool in_metres, double units_per_length, double longest);

/// What a horizontal bar takes with its text.
FurnitureSize scale_bar_size(const Canvas& canvas, const ScaleBar& bar);

/// Draws a horizontal bar with a tick at both ends and its text above, into the upper left of
/// `box`, which has its size.
void draw_scale_bar(Canvas& canvas, const ScaleBar& bar, const CanvasBox& box, const Ink& ink = {});

/// A bar that lies on the ground of an oblique view, along a direction of it.
struct GroundBar {
    CanvasPoint from;
    CanvasPoint to;
    double length = 0.0;  ///< of the ground, metres or sites
    std::string text;
};

/// The longest round bar on the ground of a view from the place `x`, `y` (metres or sites from the
/// bed's south-west corner) along `direction`, a unit vector, that ends before `longest` metres or
/// sites. `base` is the height at which it lies, in z of the block.
GroundBar ground_scale_bar(const ViewProjection& view, bool in_metres, const glm::dvec2& place,
                           const glm::dvec2& direction, double longest, double base);

/// The box around such a bar and its text.
CanvasBox ground_bar_box(const Canvas& canvas, const GroundBar& bar);

/// Draws such a bar, with its text on the side of it that lies lower on the canvas.
void draw_ground_bar(Canvas& canvas, const GroundBar& bar, const Ink& ink = {});

}  // namespace fumon
