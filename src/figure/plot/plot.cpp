#include "figure/plot/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.h"
#include "figure/plot/axes.h"
#include "figure/plot/plot_drawing.h"

namespace fumon {

namespace {

constexpr Ink grey{0.45, 0.45, 0.45, 1.0};
constexpr double box_opacity = 0.14;

std::string name_of(const PlotAxis& axis) {
    return axis.label.empty() ? "without a label" : fmt::format("\"{}\"", axis.label);
}

void check_axis(const PlotAxis& axis) {
    for (const auto& limit : {axis.low, axis.high}) {
        if (!limit) continue;
        if (!std::isfinite(*limit))
            throw InputError(
                fmt::format("the axis {} has a limit that is not a number", name_of(axis)));
        if (axis.logarithmic && !(*limit > 0.0))
            throw InputError(
                fmt::format("the logarithmic axis {} has the limit {}; it must be above 0",
                            name_of(axis), *limit));
    }
    if (axis.low && axis.high && !(*axis.low < *axis.high))
        throw InputError(fmt::format("the axis {} has the empty range {} to {}", name_of(axis),
                                     *axis.low, *axis.high));
}

void check_series(const PlotSeries& series) {
    const auto check = [&series](const std::vector<double>& list, const char* what) {
        if (list.size() != series.x.size())
            throw InputError(fmt::format("the series \"{}\" has {} values of x, but {} of {}",
                                         series.label, series.x.size(), list.size(), what));
    };
    check(series.y, "y");
    if (series.kind == SeriesKind::band) check(series.y_low, "y_low");
    if (!series.x_error.empty()) check(series.x_error, "x_error");
    if (!series.y_error.empty()) check(series.y_error, "y_error");
    if (!series.inks.empty() && series.inks.size() != series.x.size())
        throw InputError(fmt::format("the series \"{}\" has {} values of x, but {} inks",
                                     series.label, series.x.size(), series.inks.size()));
    if (!series.hollow.empty() && series.hollow.size() != series.x.size())
        throw InputError(fmt::format("the series \"{}\" has {} values of x, but {} of hollow",
                                     series.label, series.x.size(), series.hollow.size()));
}

void draw_boxes(Canvas& canvas, const Plot& plot, const PlotAxes& axes) {
    for (std::size_t n = 0; n < plot.boxes.size(); ++n) {
        const PlotBox& box = plot.boxes[n];
        Ink ink = series_look(n).ink;
        const CanvasPoint low = axes.at(box.x_low, box.y_low);
        const CanvasPoint high = axes.at(box.x_high, box.y_high);
        const CanvasBox area{low.x, high.y, high.x - low.x, low.y - high.y};
        ink.opacity = box_opacity;
        canvas.fill(area, ink);
        outline(canvas, area, canvas.line_width());
    }
}

void draw_lines(Canvas& canvas, const Plot& plot, const PlotAxes& axes) {
    const double width = canvas.line_width();
    const std::array<double, 2> dashes{4.0 * width, 3.0 * width};
    const CanvasBox& frame = axes.frame();
    for (const ReferenceLine& line : plot.lines) {
        const CanvasPoint at = axes.at(line.value, line.value);
        const std::array<CanvasPoint, 2> ends =
            line.upright ? std::array<CanvasPoint, 2>{{{at.x, frame.bottom()}, {at.x, frame.y}}}
                         : std::array<CanvasPoint, 2>{{{frame.x, at.y}, {frame.right(), at.y}}};
        canvas.stroke(ends, width, grey, dashes);
    }
}

}  // namespace

PlotPanel::PlotPanel(Plot plot) : plot_(std::move(plot)) {
    check_axis(plot_.x);
    check_axis(plot_.y);
    if (plot_.right) check_axis(*plot_.right);
    for (const PlotSeries& series : plot_.series) check_series(series);
}

PlotPanel::~PlotPanel() = default;

PanelMargins PlotPanel::margins(const Canvas& canvas, double width, double height) const {
    return plot_drawing(canvas, plot_, {0.0, 0.0, width, height}).margins;
}

void PlotPanel::draw(Canvas& canvas, const CanvasBox& frame) const {
    const PlotDrawing drawing = plot_drawing(canvas, plot_, frame);
    {
        const CanvasClip clip(canvas, frame);
        draw_boxes(canvas, plot_, drawing.axes);
        draw_lines(canvas, plot_, drawing.axes);
    }
    draw_series(canvas, plot_, drawing.axes);
    drawing.axes.draw(canvas);
    for (const PlotLabel& label : drawing.labels)
        canvas.write(label.text, label.at, label.anchor, black_ink, tick_text_size_em);
    if (drawing.legend) draw_legend(canvas, plot_, *drawing.legend);
}

void share_axes(std::span<Plot> plots, int columns, bool share_x, bool share_y) {
    const int count = static_cast<int>(plots.size());
    const auto at = [&plots](int n) -> Plot& { return plots[static_cast<std::size_t>(n)]; };
    const auto share = [&](int first, int step, int last, bool across) {
        ValueRange all;
        double room = across ? 0.0 : room_along_y_share;
        for (int n = first; n < last; n += step) {
            const PlotRanges ranges = plot_ranges(at(n));
            const ValueRange& range = across ? ranges.x : ranges.y;
            if (!range.empty()) all.add(range.low);
            if (!range.empty()) all.add(range.high);
            if (across) room = std::max(room, room_along_x(at(n)));
        }
        const PlotAxis& model = across ? at(first).x : at(first).y;
        const PlotScale scale = plot_scale(model, all, room);
        for (int n = first; n < last; n += step) {
            PlotAxis& axis = across ? at(n).x : at(n).y;
            axis.low = scale.low;
            axis.high = scale.high;
            const bool outer = across ? n + step >= last : n == first;
            axis.tick_labels = outer;
        }
    };
    for (int column = 0; share_x && column < std::min(columns, count); ++column)
        share(column, columns, count, true);
    for (int first = 0; share_y && first < count; first += columns)
        share(first, 1, std::min(first + columns, count), false);
}

}  // namespace fumon
