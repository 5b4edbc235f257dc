#include "figure/plot/axes.h"

#include <array>
#include <utility>

namespace fumon {

namespace {

PlotAxis plot_axis(const AxisRange& range) {
    return {range.label, false, range.low, range.high, range.tick_labels, range.ticks};
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

PlotAxes Axes::drawn(const Canvas& canvas) const {
    Plot plot;
    plot.x = plot_axis(x_);
    plot.y = plot_axis(y_);
    return {canvas, plot, frame_};
}

PanelMargins Axes::margins(const Canvas& canvas) const {
    return drawn(canvas).margins(canvas);
}

void Axes::draw(Canvas& canvas) const {
    drawn(canvas).draw(canvas);
}

void outline(Canvas& canvas, const CanvasBox& box, double width) {
    const double right = box.x + box.width;
    const double bottom = box.y + box.height;
    canvas.stroke(
        std::array<CanvasPoint, 5>{
            {{box.x, box.y}, {right, box.y}, {right, bottom}, {box.x, bottom}, {box.x, box.y}}},
        width, black_ink);
}

std::string in_two_lines(const Canvas& canvas, const std::string& text, double longest,
                         double size) {
    std::string best = text;
    double shortest = canvas.text_size(text, size)[0];
    if (shortest <= longest) return best;
    for (std::size_t i = text.find(' '); i != std::string::npos; i = text.find(' ', i + 1)) {
        std::string two = text;
        two[i] = '\n';
        const double length = canvas.text_size(two, size)[0];
        if (length >= shortest) continue;
        shortest = length;
        best = two;
    }
    return best;
}

void write_within(Canvas& canvas, const std::string& text, double longest, const CanvasPoint& at,
                  const CanvasPoint& anchor, double size, bool upright) {
    const double length = canvas.text_size(text, size)[0];
    const double fitting = length > longest ? size * longest / length : size;
    canvas.write(text, at, anchor, black_ink, fitting, upright);
}

}  // namespace fumon
