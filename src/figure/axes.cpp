#include "figure/axes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "figure/ticks.h"

namespace fumon {

namespace {

constexpr Ink black{0.0, 0.0, 0.0, 1.0};
constexpr double tick_text = 0.85;  // of the font size

int ticks_along(double length, double apart) {
    return std::max(2, static_cast<int>(length / apart));
}

}  // namespace

Axes::Axes(const CanvasBox& frame, AxisRange x, AxisRange y)
    : frame_(frame), x_(std::move(x)), y_(std::move(y)) {}

CanvasPoint Axes::at(double x, double y) const {
    return {frame_.x + frame_.width * (x - x_.low) / (x_.high - x_.low),
            frame_.y + frame_.height * (y_.high - y) / (y_.high - y_.low)};
}

CanvasPoint Axes::value(const CanvasPoint& place) const {
    return {x_.low + (x_.high - x_.low) * (place.x - frame_.x) / frame_.width,
            y_.high - (y_.high - y_.low) * (place.y - frame_.y) / frame_.height};
}

void Axes::draw(Canvas& canvas) const {
    const double font = canvas.font_size();
    const double thin = std::max(1.0, 0.06 * font);
    const double mark = 0.3 * font;
    const double bottom = frame_.y + frame_.height;
    outline(canvas, frame_, thin);

    const Ticks across = linear_ticks(x_.low, x_.high, ticks_along(frame_.width, 3.6 * font));
    for (std::size_t i = 0; i < across.values.size(); ++i) {
        const double x = at(across.values[i], y_.low).x;
        canvas.stroke(std::array<CanvasPoint, 2>{{{x, bottom}, {x, bottom + mark}}}, thin, black);
        canvas.write(across.labels[i], {x, bottom + 0.5 * font}, {0.5, 0.0}, black, tick_text);
    }
    const Ticks upward = linear_ticks(y_.low, y_.high, ticks_along(frame_.height, 1.1 * font));
    double widest = 0.0;
    for (std::size_t i = 0; i < upward.values.size(); ++i) {
        widest = std::max(widest, canvas.text_size(upward.labels[i], tick_text)[0]);
        const double y = at(x_.low, upward.values[i]).y;
        canvas.stroke(std::array<CanvasPoint, 2>{{{frame_.x - mark, y}, {frame_.x, y}}}, thin,
                      black);
        write_within(canvas, upward.labels[i], 3.6 * font, {frame_.x - 0.5 * font, y}, {1.0, 0.5},
                     tick_text);
    }
    write_within(canvas, x_.label, frame_.width,
                 {frame_.x + 0.5 * frame_.width, bottom + room_below * font}, {0.5, 1.0}, 0.95);
    write_within(
        canvas, y_.label, frame_.height + 2.0 * font,
        {frame_.x - 0.8 * font - std::min(widest, 3.6 * font), frame_.y + 0.5 * frame_.height},
        {1.0, 0.5}, 0.95, true);
}

void outline(Canvas& canvas, const CanvasBox& box, double width) {
    const double right = box.x + box.width;
    const double bottom = box.y + box.height;
    canvas.stroke(
        std::array<CanvasPoint, 5>{
            {{box.x, box.y}, {right, box.y}, {right, bottom}, {box.x, bottom}, {box.x, box.y}}},
        width, black);
}

void write_within(Canvas& canvas, const std::string& text, double longest, const CanvasPoint& at,
                  const CanvasPoint& anchor, double size, bool upright) {
    const double length = canvas.text_size(text, size)[0];
    const double fitting = length > longest ? size * longest / length : size;
    canvas.write(text, at, anchor, black, fitting, upright);
}

}  // namespace fumon
