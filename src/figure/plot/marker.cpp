#include "figure/plot/marker.h"

#include <array>
#include <vector>

#include "figure/plot/axes.h"

namespace fumon {

namespace {

struct Rgb {
    int red;
    int green;
    int blue;
};

constexpr std::array<Rgb, 7> inks{{{0, 114, 178},
                                   {213, 94, 0},
                                   {0, 158, 115},
                                   {204, 121, 167},
                                   {0, 0, 0},
                                   {230, 159, 0},
                                   {86, 180, 233}}};
constexpr std::array<Marker, 9> markers{
    Marker::circle,      Marker::square,      Marker::triangle,
    Marker::diamond,     Marker::circle_open, Marker::triangle_down,
    Marker::square_open, Marker::cross,       Marker::dot};

/// The corners of a marker that is a polygon, of size 1 around 0; none for others.
std::vector<CanvasPoint> corners_of(Marker marker) {
    switch (marker) {
        case Marker::square:
            return {{-0.44, -0.44}, {0.44, -0.44}, {0.44, 0.44}, {-0.44, 0.44}};
        case Marker::triangle:
            return {{0.0, -0.62}, {0.56, 0.38}, {-0.56, 0.38}};
        case Marker::triangle_down:
            return {{0.0, 0.62}, {0.56, -0.38}, {-0.56, -0.38}};
        case Marker::diamond:
            return {{0.0, -0.64}, {0.64, 0.0}, {0.0, 0.64}, {-0.64, 0.0}};
        default:
            return {};
    }
}

std::vector<CanvasPoint> placed(const std::vector<CanvasPoint>& corners, const CanvasPoint& at,
                                double size) {
    std::vector<CanvasPoint> points;
    points.reserve(corners.size());
    for (const CanvasPoint& corner : corners)
        points.push_back({at.x + size * corner.x, at.y + size * corner.y});
    return points;
}

void polygon(Canvas& canvas, Marker marker, const CanvasPoint& at, double size, const Ink& ink) {
    canvas.fill(placed(corners_of(marker), at, size), ink);
}

}  // namespace

SeriesLook series_look(std::size_t n) {
    static const std::array<LineDashes, 5> dashes{
        {{}, {5.0, 2.0}, {6.0, 1.6, 1.4, 1.6}, {1.5, 1.5}, {9.0, 2.5}}};
    const Rgb& rgb = inks.at(n % inks.size());
    constexpr double full = 255.0;
    return {{rgb.red / full, rgb.green / full, rgb.blue / full, 1.0},
            markers.at(n % markers.size()),
            dashes.at(n % dashes.size())};
}

void draw_marker(Canvas& canvas, Marker marker, const CanvasPoint& at, double size,
                 const Ink& ink) {
    const double line = 0.16 * size;
    const CanvasBox square{at.x - 0.44 * size, at.y - 0.44 * size, 0.88 * size, 0.88 * size};
    switch (marker) {
        case Marker::circle:
            return canvas.fill_circle(at, 0.5 * size, ink);
        case Marker::dot:
            return canvas.fill_circle(at, 0.25 * size, ink);
        case Marker::square:
            return canvas.fill(square, ink);
        case Marker::triangle:
        case Marker::triangle_down:
        case Marker::diamond:
            return polygon(canvas, marker, at, size, ink);
        case Marker::circle_open:
            canvas.fill_circle(at, 0.5 * size, white_ink);
            return canvas.stroke_circle(at, 0.5 * (size - line), line, ink);
        case Marker::square_open: {
            canvas.fill(square, white_ink);
            const CanvasBox edge = grown(square, -0.5 * line);
            return canvas.stroke(std::array<CanvasPoint, 5>{{{edge.x, edge.y},
                                                             {edge.right(), edge.y},
                                                             {edge.right(), edge.bottom()},
                                                             {edge.x, edge.bottom()},
                                                             {edge.x, edge.y}}},
                                 line, ink);
        }
        case Marker::cross:
            for (const double side : {-1.0, 1.0})
                canvas.stroke(
                    std::array<CanvasPoint, 2>{{{at.x - 0.42 * size, at.y - 0.42 * side * size},
                                                {at.x + 0.42 * size, at.y + 0.42 * side * size}}},
                    line, ink);
            return;
    }
}

void draw_hollow_marker(Canvas& canvas, Marker marker, const CanvasPoint& at, double size,
                        const Ink& ink) {
    if (marker == Marker::circle) return draw_marker(canvas, Marker::circle_open, at, size, ink);
    const double line = 0.16 * size;
    std::vector<CanvasPoint> outline = placed(corners_of(marker), at, size - line);
    if (outline.empty()) {
        const auto pale = [](double part) { return 0.5 * (1.0 + part); };
        return draw_marker(canvas, marker, at, size,
                           {pale(ink.red), pale(ink.green), pale(ink.blue), ink.opacity});
    }
    canvas.fill(outline, white_ink);
    outline.push_back(outline.front());
    outline.push_back(outline[1]);
    canvas.stroke(outline, line, ink);
}

}  // namespace fumon
