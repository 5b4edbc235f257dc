#include "figure/scale_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "figure/length_unit.h"

namespace fumon {

namespace {

constexpr double text_size = 0.9;

/// The greatest of 1, 2 and 5 times a power of ten up to a length above 0.
double round_length(double longest) {
    const double rounded = longest * (1.0 + 1e-9);
    const double power = std::pow(10.0, std::floor(std::log10(rounded)));
    for (const double step : {5.0, 2.0}) {
        if (step * power <= rounded) return step * power;
    }
    return power;
}

std::string length_text(bool in_metres, double length) {
    if (!in_metres && length == 1.0) return "1 site";
    // A bar, unlike an axis, counts in kilometres as soon as it is one.
    constexpr double kilometre = 1e3;
    if (in_metres && length >= kilometre) return fmt::format("{:g} km", length / kilometre);
    const LengthUnit unit = length_unit(in_metres, length);
    return fmt::format("{:g} {}", length / unit.length, unit.symbol);
}

}  // namespace

ScaleBar round_scale_bar(bool in_metres, double units_per_length, double longest) {
    const double length = round_length(longest / units_per_length);
    return {length, length * units_per_length, length_text(in_metres, length)};
}

FurnitureSize scale_bar_size(const Canvas& canvas, const ScaleBar& bar) {
    const auto [width, height] = canvas.text_size(bar.text, text_size);
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
                 text_size);
}

GroundBar ground_scale_bar(const ViewProjection& view, bool in_metres, const glm::dvec2& place,
                           const glm::dvec2& direction, double longest, double base) {
    const double length = round_length(longest);
    return {view.at_ground(place, base), view.at_ground(place + length * direction, base), length,
            length_text(in_metres, length)};
}

void draw_ground_bar(Canvas& canvas, const GroundBar& bar, const Ink& ink) {
    const double font = canvas.font_size();
    const glm::dvec2 along(bar.to.x - bar.from.x, bar.to.y - bar.from.y);
    const double length = glm::length(along);
    if (!(length > 0.0)) return;
    glm::dvec2 across = glm::dvec2(-along.y, along.x) / length;
    if (across.y < 0.0) across = -across;
    const double mark = 0.25 * font;
    const auto end = [&](const CanvasPoint& at) {
        canvas.stroke(
            std::array<CanvasPoint, 2>{{{at.x - mark * across.x, at.y - mark * across.y},
                                        {at.x + mark * across.x, at.y + mark * across.y}}},
            1.5 * canvas.line_width(), ink);
    };
    canvas.stroke(std::array<CanvasPoint, 2>{bar.from, bar.to}, 1.5 * canvas.line_width(), ink);
    end(bar.from);
    end(bar.to);
    // Off the bar by so much that no corner of the text's box touches it.
    const auto [width, height] = canvas.text_size(bar.text, text_size);
    const double off =
        0.5 * (std::abs(across.x) * width + std::abs(across.y) * height) + 0.3 * font;
    canvas.write(bar.text,
                 {0.5 * (bar.from.x + bar.to.x) + off * across.x,
                  0.5 * (bar.from.y + bar.to.y) + off * across.y},
                 {0.5, 0.5}, ink, text_size);
}

}  // namespace fumon
