#include "figure/axes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "figure/ticks.h"

namespace fumon {

namespace {

constexpr Ink black{0.0, 0.0, 0.0, 1.0};
// Sizes and distances, of the font size.
constexpr double tick_text = 0.85;
constexpr double label_text = 0.95;
constexpr double mark = 0.3;
constexpr double to_tick_text = 0.5;
constexpr double to_label = 0.2;
constexpr double beyond_frame = 1.0;  // by which a label may be longer than its axis, each way

/// The largest width and height of some tick labels.
std::array<double, 2> largest(const Canvas& canvas, const std::vector<std::string>& labels) {
    std::array<double, 2> size{};
    for (const std::string& label : labels) {
        const auto [width, height] = canvas.text_size(label, tick_text);
        size = {std::max(size[0], width), std::max(size[1], height)};
    }
    return size;
}

/// What ticks take off an axis, beyond their marks.
double room_of_ticks(double font, const AxisRange& range, double text) {
    return range.tick_labels ? to_tick_text * font + text : mark * font;
}

double room_of_label(const Canvas& canvas, const AxisRange& range) {
    if (range.label.empty()) return 0.0;
    return to_label * canvas.font_size() + canvas.text_size(range.label, label_text)[1];
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

Ticks Axes::across(const Canvas& canvas) const {
    const double font = canvas.font_size();
    for (int most = std::max(2, static_cast<int>(frame_.width / (2.2 * font)));; --most) {
        Ticks ticks = linear_ticks(x_.low, x_.high, most);
        const double taken =
            (largest(canvas, ticks.labels)[0] + 0.8 * font) * static_cast<double>(ticks.labels.size());
        if (most <= 2 || taken <= frame_.width) return ticks;
    }
}

Ticks Axes::upward(const Canvas& canvas) const {
    const double apart = 1.5 * canvas.font_size();
    return linear_ticks(y_.low, y_.high, std::max(2, static_cast<int>(frame_.height / apart)));
}

PanelMargins Axes::margins(const Canvas& canvas) const {
    const double font = canvas.font_size();
    const double thin = 0.5 * canvas.line_width();
    const auto across_text = largest(canvas, across(canvas).labels);
    const auto upward_text = largest(canvas, upward(canvas).labels);
    PanelMargins room{thin, thin, thin, thin};
    room.left = room_of_ticks(font, y_, upward_text[0]) + room_of_label(canvas, y_);
    room.below = room_of_ticks(font, x_, across_text[1]) + room_of_label(canvas, x_);
    if (x_.tick_labels) {
        room.right = std::max(room.right, 0.5 * across_text[0]);
        room.left = std::max(room.left, 0.5 * across_text[0]);
    }
    if (y_.tick_labels) room.above = std::max(room.above, 0.5 * upward_text[1]);
    const double length = canvas.text_size(y_.label, label_text)[0];
    room.above = std::max(room.above, std::min(0.5 * (length - frame_.height), beyond_frame * font));
    return room;
}

void Axes::draw(Canvas& canvas) const {
    const double font = canvas.font_size();
    const double thin = canvas.line_width();
    const double bottom = frame_.y + frame_.height;
    outline(canvas, frame_, thin);

    const Ticks columns = across(canvas);
    for (std::size_t i = 0; i < columns.values.size(); ++i) {
        const double x = at(columns.values[i], y_.low).x;
        canvas.stroke(std::array<CanvasPoint, 2>{{{x, bottom}, {x, bottom + mark * font}}}, thin,
                      black);
        if (x_.tick_labels)
            canvas.write(columns.labels[i], {x, bottom + to_tick_text * font}, {0.5, 0.0}, black,
                         tick_text);
    }
    const Ticks rows = upward(canvas);
    for (std::size_t i = 0; i < rows.values.size(); ++i) {
        const double y = at(x_.low, rows.values[i]).y;
        canvas.stroke(std::array<CanvasPoint, 2>{{{frame_.x - mark * font, y}, {frame_.x, y}}},
                      thin, black);
        if (y_.tick_labels)
            canvas.write(rows.labels[i], {frame_.x - to_tick_text * font, y}, {1.0, 0.5}, black,
                         tick_text);
    }
    const double below = room_of_ticks(font, x_, largest(canvas, columns.labels)[1]);
    if (!x_.label.empty())
        write_within(canvas, x_.label, frame_.width + beyond_frame * font,
                     {frame_.x + 0.5 * frame_.width, bottom + below + to_label * font}, {0.5, 0.0},
                     label_text);
    const double beside = room_of_ticks(font, y_, largest(canvas, rows.labels)[0]);
    if (!y_.label.empty())
        write_within(canvas, y_.label, frame_.height + 2.0 * beyond_frame * font,
                     {frame_.x - beside - to_label * font, frame_.y + 0.5 * frame_.height},
                     {1.0, 0.5}, label_text, true);
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
