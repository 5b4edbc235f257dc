#include "figure/layers/layer_inks.h"

#include <array>
#include <string>

#include "figure/plot/marker.h"

namespace fumon {

namespace {

constexpr double rim_width = 1.5;         // pixels around markers
constexpr double cross_line_ratio = 0.2;  // of a cross's size
constexpr Ink rim_colour{1.0, 1.0, 1.0, 0.85};

Ink ink_of(const std::string& colour, double opacity) {
    const std::array<double, 3> rgb = layer_colour(colour).value_or(std::array{0.0, 0.0, 0.0});
    return {rgb[0], rgb[1], rgb[2], opacity};
}

Ink times(Ink ink, double opacity) {
    ink.opacity *= opacity;
    return ink;
}

void draw_cross(Canvas& canvas, const CanvasPoint& at, double half, double width, const Ink& ink) {
    for (const double side : {1.0, -1.0}) {
        canvas.stroke(std::array<CanvasPoint, 2>{{{at.x - half, at.y - side * half},
                                                  {at.x + half, at.y + side * half}}},
                      width, ink);
    }
}

}  // namespace

Ink line_ink(const LayerSettings& settings) {
    return ink_of(settings.colour, settings.opacity);
}

Ink area_ink(const LayerSettings& settings) {
    return ink_of(settings.fill.empty() ? settings.colour : settings.fill, settings.fill_opacity);
}

void draw_layer_marker(Canvas& canvas, const LayerSettings& settings, const CanvasPoint& at,
                       double pixel, double opacity) {
    const double size = settings.marker_size * pixel;
    const double rim = rim_width * pixel;
    const Ink ink = times(line_ink(settings), opacity);
    const Ink around = times(rim_colour, opacity);
    switch (settings.marker) {
        case LayerMarker::none:
            break;
        case LayerMarker::circle:
            draw_marker(canvas, Marker::circle, at, size + 2.0 * rim, around);
            draw_marker(canvas, Marker::circle, at, size, ink);
            break;
        case LayerMarker::square:
            draw_marker(canvas, Marker::square, at, size + 2.0 * rim, around);
            draw_marker(canvas, Marker::square, at, size, ink);
            break;
        case LayerMarker::triangle:
            draw_marker(canvas, Marker::triangle, at, size + 3.0 * rim, around);
            draw_marker(canvas, Marker::triangle, at, size, ink);
            break;
        case LayerMarker::cross: {
            const double half = 0.36 * size;
            const double width = cross_line_ratio * size;
            draw_cross(canvas, at, half, width + 2.0 * rim, around);
            draw_cross(canvas, at, half, width, ink);
            break;
        }
    }
}

}  // namespace fumon
