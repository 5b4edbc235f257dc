#pragma once

#include <cstddef>
#include <vector>

#include "figure/canvas/canvas.h"

namespace fumon {

enum class Marker {
    circle,
    square,
    triangle,
    diamond,
    circle_open,
    square_open,
    triangle_down,
    cross,
    dot
};

/// Lengths of dashes and gaps in line widths; empty: a solid line.
using LineDashes = std::vector<double>;

/// How the n-th series of a plot looks, so that readers of any colour vision and of grey prints
/// distinguish it from the others.
struct SeriesLook {
    Ink ink;
    Marker marker = Marker::circle;
    LineDashes dashes;
};

/// Colours of Okabe & Ito 2008, "Color Universal Design", dark ones first; each with a marker and
/// dashes of its own.
SeriesLook series_look(std::size_t n);

/// Draws a marker `size` units across.
void draw_marker(Canvas& canvas, Marker marker, const CanvasPoint& at, double size, const Ink& ink);

/// The same with its outline alone; a marker that has no filling is pale.
void draw_hollow_marker(Canvas& canvas, Marker marker, const CanvasPoint& at, double size,
                        const Ink& ink);

}  // namespace fumon
