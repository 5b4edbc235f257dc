#include "figure/panels/ground_arrow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "base/elementary.h"
#include "base/find_named.h"
#include "base/units.h"
#include "figure/words/words.h"

namespace fumon {

namespace {

constexpr double arrow_text_size_em = 0.9;

/// A box around points relative to the arrow's middle.
struct Extent {
    glm::dvec2 low{0.0};
    glm::dvec2 high{0.0};

    void take(const glm::dvec2& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    [[nodiscard]] FurnitureSize size() const { return {high.x - low.x, high.y - low.y}; }
};

/// An arrow's outline and its label's middle on the canvas, relative to the arrow's middle.
struct ArrowShape {
    std::vector<glm::dvec2> outline;
    glm::dvec2 label{0.0};
    Extent extent;
};

/// A flat shape of the ground, (along, across) in font sizes, as it is seen in units.
std::vector<glm::dvec2> lay(std::span<const glm::dvec2> shape, const glm::dvec2& towards,
                            const GroundAxes& axes, double font) {
    std::vector<glm::dvec2> seen;
    for (const glm::dvec2& point : shape) {
        const glm::dvec2 ground(point.x * towards.x - point.y * towards.y,
                                point.x * towards.y + point.y * towards.x);
        seen.push_back(font * axes(ground));
    }
    return seen;
}

void fill_shape(Canvas& canvas, std::span<const glm::dvec2> shape, const glm::dvec2& middle,
                const Ink& ink) {
    std::vector<CanvasPoint> corners;
    for (const glm::dvec2& point : shape)
        corners.push_back({middle.x + point.x, middle.y + point.y});
    canvas.fill(corners, ink);
}

void take_text(ArrowShape& shape, const std::array<double, 2>& size) {
    const glm::dvec2 half(0.5 * size[0], 0.5 * size[1]);
    shape.extent.take(shape.label - half);
    shape.extent.take(shape.label + half);
}

/// An arrow along the first axis around `middle`, font sizes.
std::array<glm::dvec2, 7> arrow_outline(double length, double middle = 0.0) {
    const double tail = middle - 0.5 * length;
    const double tip = middle + 0.5 * length;
    const double neck = tip - 0.95;
    constexpr double shaft = 0.14;  // half its width
    constexpr double barb = 0.46;
    return {{{tail, shaft},
             {neck, shaft},
             {neck, barb},
             {tip, 0.0},
             {neck, -barb},
             {neck, -shaft},
             {tail, -shaft}}};
}

ArrowShape arrow_shape(const Canvas& canvas, const GroundDirection& direction,
                       const GroundAxes& axes, double length) {
    const double font = canvas.font_size();
    ArrowShape shape{lay(arrow_outline(length), direction.towards, axes, font), {}, {}};
    for (const glm::dvec2& point : shape.outline) shape.extent.take(point);
    if (direction.label.empty()) return shape;
    const auto size = canvas.text_size(direction.label, arrow_text_size_em);
    const glm::dvec2 along = axes(direction.towards);
    const FurnitureSize arrow = shape.extent.size();
    if (std::abs(along.y) > 1.5 * std::abs(along.x))  // beside an arrow up or down the page
        shape.label = {0.5 * arrow.width + 0.3 * font + 0.5 * size[0], 0.0};
    else
        shape.label = {0.0, -0.5 * arrow.height - 0.05 * font - 0.5 * size[1]};
    take_text(shape, size);
    return shape;
}

/// The outline of one arrow of a rose, relative to the rose's middle.
std::vector<glm::dvec2> arrow_of_rose(const GroundWind& wind, const GroundAxes& axes, double font) {
    constexpr double from_middle = 0.5;  // font sizes, of the tips
    constexpr double shortest = 1.2;
    constexpr double longest = 2.4;
    const double length = shortest + (longest - shortest) * wind.drift;
    return lay(arrow_outline(length, -from_middle - 0.5 * length), wind.towards, axes, font);
}

/// The two halves of a needle, the left one hollow, and the letter beyond its tip.
struct CompassShape {
    std::vector<glm::dvec2> west;
    std::vector<glm::dvec2> east;
    ArrowShape letter;
};

CompassShape compass_shape(const Canvas& canvas, const GroundAxes& axes, double length) {
    const double font = canvas.font_size();
    const glm::dvec2 north(0.0, 1.0);
    const double half = 0.5 * length;
    constexpr double wing = 0.5;
    const std::array<glm::dvec2, 3> west{{{half, 0.0}, {-half, wing}, {-0.55 * half, 0.0}}};
    const std::array<glm::dvec2, 3> east{{{half, 0.0}, {-half, -wing}, {-0.55 * half, 0.0}}};
    CompassShape shape{lay(west, north, axes, font), lay(east, north, axes, font), {}};
    for (const auto* wings : {&shape.west, &shape.east}) {
        for (const glm::dvec2& point : *wings) {
            shape.letter.extent.take(point - 0.5 * canvas.line_width());
            shape.letter.extent.take(point + 0.5 * canvas.line_width());
        }
    }
    const auto size = canvas.text_size(word("N"), arrow_text_size_em);
    const glm::dvec2 tip = font * half * axes(north);
    const double seen = std::max(glm::length(tip), 1e-9);
    const double beyond =
        0.5 * (std::abs(tip.x) * size[0] + std::abs(tip.y) * size[1]) / seen + 0.1 * font;
    shape.letter.label = tip * (1.0 + beyond / seen);
    take_text(shape.letter, size);
    return shape;
}

}  // namespace

FurnitureSize ground_arrow_size(const Canvas& canvas, const GroundDirection& direction,
                                const GroundAxes& axes, double length) {
    return arrow_shape(canvas, direction, axes, length).extent.size();
}

void draw_ground_arrow(Canvas& canvas, const GroundDirection& direction, const GroundAxes& axes,
                       const CanvasBox& box, const Ink& ink, double length) {
    const ArrowShape shape = arrow_shape(canvas, direction, axes, length);
    const glm::dvec2 middle = glm::dvec2(box.x, box.y) - shape.extent.low;
    fill_shape(canvas, shape.outline, middle, ink);
    if (direction.label.empty()) return;
    canvas.write(direction.label, {middle.x + shape.label.x, middle.y + shape.label.y}, {0.5, 0.5},
                 ink, arrow_text_size_em);
}

std::vector<GroundWind> ground_winds(const Snapshot& snapshot) {
    if (snapshot.winds.size() < 2) return {};
    double strongest = 0.0;
    for (const SnapshotWind& wind : snapshot.winds) strongest = std::max(strongest, wind.drift);
    std::vector<GroundWind> winds;
    for (const SnapshotWind& wind : snapshot.winds)
        winds.push_back({{wind.x, wind.y}, strongest > 0.0 ? wind.drift / strongest : 1.0, false});
    const SnapshotNumber* from = find_named(snapshot.numbers, "wind_from");
    if (from == nullptr) return winds;
    const glm::dvec2 towards(-elementary::sin(from->value * degree),
                             -elementary::cos(from->value * degree));
    std::ranges::max_element(winds, {}, [&](const GroundWind& wind) {
        return glm::dot(wind.towards, towards);
    })->blows = true;
    return winds;
}

FurnitureSize ground_winds_size(const Canvas& canvas, const std::vector<GroundWind>& winds,
                                const GroundAxes& axes) {
    double across = 0.0;
    double down = 0.0;
    for (const GroundWind& wind : winds) {
        for (const glm::dvec2& point : arrow_of_rose(wind, axes, canvas.font_size())) {
            across = std::max(across, std::abs(point.x));
            down = std::max(down, std::abs(point.y));
        }
    }
    return {2.0 * across, 2.0 * down};
}

void draw_ground_winds(Canvas& canvas, const std::vector<GroundWind>& winds, const GroundAxes& axes,
                       const CanvasBox& box) {
    constexpr Ink faint{0.0, 0.0, 0.0, 0.45};
    const glm::dvec2 middle(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    for (const GroundWind& wind : winds) {
        fill_shape(canvas, arrow_of_rose(wind, axes, canvas.font_size()), middle,
                   wind.blows ? Ink{} : faint);
    }
}

FurnitureSize compass_size(const Canvas& canvas, const GroundAxes& axes, double length) {
    return compass_shape(canvas, axes, length).letter.extent.size();
}

void draw_compass(Canvas& canvas, const GroundAxes& axes, const CanvasBox& box, const Ink& ink,
                  double length) {
    const CompassShape shape = compass_shape(canvas, axes, length);
    const ArrowShape& letter = shape.letter;
    const glm::dvec2 middle = glm::dvec2(box.x, box.y) - letter.extent.low;
    fill_shape(canvas, shape.east, middle, ink);
    std::vector<CanvasPoint> rim;
    for (std::size_t i = 0; i <= shape.west.size(); ++i) {
        const glm::dvec2 point = middle + shape.west[i % shape.west.size()];
        rim.push_back({point.x, point.y});
    }
    canvas.stroke(rim, canvas.line_width(), ink);
    canvas.write(word("N"), {middle.x + letter.label.x, middle.y + letter.label.y}, {0.5, 0.5}, ink,
                 arrow_text_size_em);
}

}  // namespace fumon
