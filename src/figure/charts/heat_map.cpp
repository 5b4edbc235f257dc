#include "figure/charts/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/elementary_power.h"
#include "figure/panels/contours.h"

namespace fumon {

namespace {

constexpr double text_size_em = 0.8;     // of cells' texts, font sizes
constexpr double text_room_share = 0.9;  // of a cell, which its text takes at most

/// A place among cells, −½ … count − ½, as a share of the side.
double share_of(const HeatAxis& axis, double place) {
    const auto last = static_cast<double>(axis.middles.size() - 1);
    if (place <= 0.0) return std::lerp(axis.middles.front(), 0.0, std::min(1.0, -2.0 * place));
    if (place >= last)
        return std::lerp(axis.middles.back(), 1.0, std::min(1.0, 2.0 * (place - last)));
    const auto below = static_cast<std::size_t>(std::floor(place));
    return std::lerp(axis.middles[below], axis.middles[below + 1],
                     place - static_cast<double>(below));
}

PlotAxis plot_axis(const HeatAxis& axis) {
    PlotAxis made;
    made.label = axis.label;
    made.low = 0.0;
    made.high = 1.0;
    made.tick_labels = axis.tick_labels;
    for (std::size_t i = 0; i < axis.names.size(); ++i)
        made.named.emplace_back(axis.middles[i], axis.names[i]);
    return made;
}

/// Whether black letters are read better on a colour than white ones (its luma, ITU-R BT.601).
bool is_light(const Ink& ink) {
    return 0.299 * ink.red + 0.587 * ink.green + 0.114 * ink.blue > 0.5;
}

}  // namespace

HeatAxis even_axis(std::vector<std::string> names) {
    HeatAxis axis;
    axis.names = std::move(names);
    const auto count = static_cast<double>(axis.names.size());
    for (std::size_t i = 0; i < axis.names.size(); ++i) {
        axis.edges.push_back(static_cast<double>(i) / count);
        axis.middles.push_back((static_cast<double>(i) + 0.5) / count);
    }
    axis.edges.push_back(1.0);
    return axis;
}

HeatAxis value_axis(const std::vector<double>& values, std::vector<std::string> names,
                    bool logarithmic) {
    if (values.size() < 2) return even_axis(std::move(names));
    std::vector<double> places;
    places.reserve(values.size());
    for (const double value : values)
        places.push_back(logarithmic ? elementary::log10(value) : value);
    std::vector<double> edges;
    const std::size_t last = places.size() - 1;
    edges.push_back(1.5 * places[0] - 0.5 * places[1]);
    for (std::size_t i = 0; i < last; ++i) edges.push_back(0.5 * (places[i] + places[i + 1]));
    edges.push_back(1.5 * places[last] - 0.5 * places[last - 1]);
    const double low = edges.front();
    const double range = edges.back() - low;
    HeatAxis axis;
    axis.names = std::move(names);
    for (const double place : places) axis.middles.push_back((place - low) / range);
    for (const double edge : edges) axis.edges.push_back((edge - low) / range);
    axis.edges.back() = 1.0;
    return axis;
}

std::size_t HeatMap::class_of(double value) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(bounds, [value](double bound) { return value >= bound; }));
}

Ink HeatMap::ink(double value) const {
    if (colours.classes.empty()) return colours.ink(value);
    const double share =
        (static_cast<double>(class_of(value)) + 0.5) / static_cast<double>(colours.classes.size());
    return colours.ink(std::lerp(colours.low, colours.high, share));
}

std::vector<ContourLine> cell_lines(const Grid& values, double level) {
    Grid padded(values.nx() + 2, values.ny() + 2);
    for (int y = 0; y < padded.ny(); ++y) {
        for (int x = 0; x < padded.nx(); ++x) {
            padded(x, y) = values(std::clamp(x - 1, 0, values.nx() - 1),
                                  std::clamp(y - 1, 0, values.ny() - 1));
        }
    }
    std::vector<ContourLine> lines = contour_lines(padded, {}, level);
    for (ContourLine& line : lines) {
        for (glm::dvec2& point : line.points)
            point = glm::clamp(point - 1.0, glm::dvec2(-0.5),
                               glm::dvec2(values.nx() - 0.5, values.ny() - 0.5));
    }
    return lines;
}

PlotAxes HeatMapPanel::axes_in(const Canvas& canvas, const CanvasBox& frame) const {
    Plot plot;
    plot.x = plot_axis(map_.x);
    plot.y = plot_axis(map_.y);
    return {canvas, plot, frame};
}

PanelMargins HeatMapPanel::margins(const Canvas& canvas, double width, double height) const {
    const PanelMargins room = axes_in(canvas, {0.0, 0.0, width, height}).margins(canvas);
    return with_colour_bar(canvas, room, map_.bar, map_.colours, width, height);
}

CanvasBox HeatMapPanel::cell_box(const CanvasBox& frame, int x, int y) const {
    const auto column = static_cast<std::size_t>(x);
    const auto row = static_cast<std::size_t>(y);
    const double left = frame.x + frame.width * map_.x.edges[column];
    const double right = frame.x + frame.width * map_.x.edges[column + 1];
    const double top = frame.bottom() - frame.height * map_.y.edges[row + 1];
    const double bottom = frame.bottom() - frame.height * map_.y.edges[row];
    return {left, top, right - left, bottom - top};
}

/// Each cell reaches a little under its right and lower neighbour, so that no seam shows.
void HeatMapPanel::draw_cells(Canvas& canvas, const CanvasBox& frame) const {
    const double under = 0.5 * canvas.line_width();
    constexpr Ink cross{0.6, 0.6, 0.6, 1.0};
    for (int y = map_.values.ny() - 1; y >= 0; --y) {
        for (int x = 0; x < map_.values.nx(); ++x) {
            const CanvasBox box = cell_box(frame, x, y);
            const double value = map_.values(x, y);
            CanvasBox filled = box;
            if (x + 1 < map_.values.nx()) filled.width += under;
            if (y > 0) filled.height += under;
            canvas.fill(filled, std::isfinite(value) ? map_.ink(value) : white_ink);
            if (std::isfinite(value)) continue;
            canvas.stroke(std::array<CanvasPoint, 2>{{{box.x, box.y}, {box.right(), box.bottom()}}},
                          canvas.line_width(), cross);
            canvas.stroke(std::array<CanvasPoint, 2>{{{box.x, box.bottom()}, {box.right(), box.y}}},
                          canvas.line_width(), cross);
        }
    }
}

/// All texts in one size, in which the longest fits its cell.
void HeatMapPanel::draw_texts(Canvas& canvas, const CanvasBox& frame) const {
    if (map_.texts.empty()) return;
    double size = text_size_em;
    const auto text_of = [this](int x, int y) -> const std::string& {
        return map_.texts[static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.values.nx()) +
                          static_cast<std::size_t>(x)];
    };
    for (int y = 0; y < map_.values.ny(); ++y) {
        for (int x = 0; x < map_.values.nx(); ++x) {
            if (text_of(x, y).empty()) continue;
            const CanvasBox box = cell_box(frame, x, y);
            const auto [width, height] = canvas.text_size(text_of(x, y), text_size_em);
            size = std::min({size, text_size_em * text_room_share * box.width / width,
                             text_size_em * text_room_share * box.height / height});
        }
    }
    for (int y = 0; y < map_.values.ny(); ++y) {
        for (int x = 0; x < map_.values.nx(); ++x) {
            const std::string& text = text_of(x, y);
            if (text.empty()) continue;
            const double value = map_.values(x, y);
            const bool light = !std::isfinite(value) || is_light(map_.ink(value));
            canvas.write(text, cell_box(frame, x, y).middle(), {0.5, 0.5},
                         light ? black_ink : white_ink, size);
        }
    }
}

void HeatMapPanel::draw_lines(Canvas& canvas, const CanvasBox& frame) const {
    const CanvasClip clip(canvas, frame);
    const double width = 2.0 * canvas.line_width();
    std::vector<std::pair<std::string, CanvasPoint>> names;
    for (const ContourLine& line : map_.lines) {
        std::vector<CanvasPoint> points;
        for (const glm::dvec2& point : line.points) {
            points.push_back({frame.x + frame.width * share_of(map_.x, point.x),
                              frame.bottom() - frame.height * share_of(map_.y, point.y)});
        }
        canvas.stroke(points, 2.2 * width, {1.0, 1.0, 1.0, 0.6});
        canvas.stroke(points, width, black_ink);
        if (map_.name_lines)
            names.emplace_back(fmt::format("{:g}", line.level), points[points.size() / 2]);
    }
    constexpr double name_size = 0.75;
    for (const auto& [name, at] : names) {
        const auto [wide, high] = canvas.text_size(name, name_size);
        const double gap = 0.15 * canvas.font_size();
        const CanvasPoint inside{
            std::clamp(at.x, frame.x + 0.5 * wide + gap, frame.right() - 0.5 * wide - gap),
            std::clamp(at.y, frame.y + 0.5 * high + gap, frame.bottom() - 0.5 * high - gap)};
        canvas.fill(grown({inside.x - 0.5 * wide, inside.y - 0.5 * high, wide, high}, gap),
                    {1.0, 1.0, 1.0, 0.85});
        canvas.write(name, inside, {0.5, 0.5}, black_ink, name_size);
    }
}

void HeatMapPanel::draw(Canvas& canvas, const CanvasBox& frame) const {
    draw_cells(canvas, frame);
    draw_lines(canvas, frame);
    draw_texts(canvas, frame);
    const PlotAxes axes = axes_in(canvas, frame);
    axes.draw(canvas);
    draw_placed_bar(canvas, frame, axes.margins(canvas), map_.bar, map_.colours);
}

}  // namespace fumon
