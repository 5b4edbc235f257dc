#include "figure/panels/scale_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary_power.h"
#include "figure/panels/axis_units.h"
#include "figure/words/words.h"

namespace fumon {

namespace {

constexpr double bar_text_size_em = 0.9;

std::string length_text(bool in_metres, double length) {
    if (!in_metres && length == 1.0) return word("1 site");
    // A bar, unlike an axis, counts in kilometres as soon as it is one.
    constexpr double kilometre = 1e3;
    if (in_metres && length >= kilometre) return fmt::format("{:g} km", length / kilometre);
    const LengthUnit unit = length_unit(in_metres, length);
    return fmt::format("{:g} {}", length / unit.length, unit_word(unit.symbol));
}

}  // namespace

double round_length(double longest) {
    const double rounded = longest * (1.0 + 1e-9);
    const double power = elementary::pow(10.0, std::floor(elementary::log10(rounded)));
    for (const double step : {5.0, 2.0}) {
        if (step * power <= rounded) return step * power;
    }
    return power;
}

ScaleBar round_scale_bar(bool in_metres, double units_per_length, double longest) {
    const double length = round_length(longest / units_per_length);
    return {length, length * units_per_length, length_text(in_metres, length)};
}

FurnitureSize scale_bar_size(const Canvas& canvas, const ScaleBar& bar) {
    const auto [width, height] = canvas.text_size(bar.text, bar_text_size_em);
    return {std::max(bar.drawn, width), height + 0.5 * canvas.font_size()};
}

void draw_scale_bar(Canvas& canvas, const ScaleBar& bar, const CanvasBox& box, const Ink& ink) {
    const double font = canvas.font_size();
    const double left = box.x + 0.5 * (box.width - bar.drawn);
    const double right = left + bar.drawn;
    const double thick = 0.22 * font;
    const double bottom = box.y + box.height;
    canvas.fill(CanvasBox{left, bottom - thick, right - left, thick}, ink);
    canvas.write(bar.text, {0.5 * (left + right), bottom - thick - 0.1 * font}, {0.5, 1.0}, ink,
                 bar_text_size_em);
}

GroundBar ground_scale_bar(const ViewProjection& view, bool in_metres, const glm::dvec2& place,
                           const glm::dvec2& direction, double longest, double base) {
    const double length = round_length(longest);
    return {view.at_ground(place, base), view.at_ground(place + length * direction, base), length,
            length_text(in_metres, length)};
}

namespace {

/// How a bar on the ground and its text lie on the canvas.
struct GroundBarShape {
    glm::dvec2 across{0.0, 1.0};  ///< a unit vector at right angles to it, downward
    double mark = 0.0;            ///< half a tick's length
    CanvasBox text;
};

GroundBarShape shape_of(const Canvas& canvas, const GroundBar& bar) {
    const double font = canvas.font_size();
    const glm::dvec2 along(bar.to.x - bar.from.x, bar.to.y - bar.from.y);
    GroundBarShape shape;
    if (glm::length(along) > 0.0) shape.across = glm::dvec2(-along.y, along.x) / glm::length(along);
    if (shape.across.y < 0.0) shape.across = -shape.across;
    shape.mark = 0.25 * font;
    // Off the bar by so much that no corner of the text's box touches it.
    const auto [width, height] = canvas.text_size(bar.text, bar_text_size_em);
    const double off =
        0.5 * (std::abs(shape.across.x) * width + std::abs(shape.across.y) * height) + 0.3 * font;
    shape.text = {0.5 * (bar.from.x + bar.to.x) + off * shape.across.x - 0.5 * width,
                  0.5 * (bar.from.y + bar.to.y) + off * shape.across.y - 0.5 * height, width,
                  height};
    return shape;
}

}  // namespace

CanvasBox ground_bar_box(const Canvas& canvas, const GroundBar& bar) {
    const GroundBarShape shape = shape_of(canvas, bar);
    const double room = shape.mark + canvas.line_width();
    const double left = std::min({bar.from.x - room, bar.to.x - room, shape.text.x});
    const double top = std::min({bar.from.y - room, bar.to.y - room, shape.text.y});
    const double right = std::max({bar.from.x + room, bar.to.x + room, shape.text.right()});
    const double bottom = std::max({bar.from.y + room, bar.to.y + room, shape.text.bottom()});
    return {left, top, right - left, bottom - top};
}

void draw_ground_bar(Canvas& canvas, const GroundBar& bar, const Ink& ink) {
    const GroundBarShape shape = shape_of(canvas, bar);
    const glm::dvec2 half = shape.mark * shape.across;
    const double thick = 1.5 * canvas.line_width();
    canvas.stroke(std::array<CanvasPoint, 2>{bar.from, bar.to}, thick, ink);
    for (const CanvasPoint& end : {bar.from, bar.to}) {
        canvas.stroke(std::array<CanvasPoint, 2>{{{end.x - half.x, end.y - half.y},
                                                  {end.x + half.x, end.y + half.y}}},
                      thick, ink);
    }
    canvas.write(bar.text, shape.text.middle(), {0.5, 0.5}, ink, bar_text_size_em);
}

}  // namespace fumon
