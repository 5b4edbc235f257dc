#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/elementary_angle.h"
#include "figure/plot/plot_drawing.h"

namespace fumon {

namespace {

constexpr double curve_width_ratio = 2.0;  // of the frame's line
constexpr double band_opacity = 0.25;
constexpr Ink dark_edge{0.25, 0.25, 0.25, 1.0};
constexpr double error_bar_cap_em = 0.2;  // half the cap of an error bar, font sizes
constexpr double arrow_head_em = 0.5;     // of the arrow of one that goes on beyond the frame

double line_width_of(const Canvas& canvas, const PlotSeries& series) {
    if (series.width > 0.0) return series.width;
    return canvas.line_width() * (series.kind == SeriesKind::fit ? 1.5 : curve_width_ratio);
}

bool has_line(const PlotSeries& series) {
    return series.kind != SeriesKind::points && series.kind != SeriesKind::band &&
           series.kind != SeriesKind::area;
}

bool has_markers(const PlotSeries& series) {
    return series.kind == SeriesKind::points || series.kind == SeriesKind::line_and_points;
}

std::vector<double> dash_lengths(const LineDashes& dashes, double width) {
    std::vector<double> lengths;
    for (const double dash : dashes) lengths.push_back(dash * width);
    return lengths;
}

bool alike(const Ink& a, const Ink& b) {
    constexpr double near = 0.1;
    return std::abs(a.red - b.red) < near && std::abs(a.green - b.green) < near &&
           std::abs(a.blue - b.blue) < near;
}

/// The unbroken pieces of a series's curve.
std::vector<std::vector<CanvasPoint>> pieces_of(const PlotSeries& series, const PlotAxes& axes) {
    constexpr double visible = 0.02;  // units
    std::vector<std::vector<CanvasPoint>> pieces(1);
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!axes.shows(series.x[i], series.y[i], series.on_right)) {
            if (!pieces.back().empty()) pieces.emplace_back();
            continue;
        }
        const CanvasPoint point = axes.at(series.x[i], series.y[i], series.on_right);
        std::vector<CanvasPoint>& piece = pieces.back();
        if (piece.size() > 1 && i + 1 < series.x.size() &&
            elementary::hypot(point.x - piece.back().x, point.y - piece.back().y) < visible)
            continue;
        if (series.kind == SeriesKind::step && !piece.empty())
            piece.push_back({point.x, piece.back().y});
        piece.push_back(point);
    }
    if (pieces.back().empty()) pieces.pop_back();
    return pieces;
}

void draw_band(Canvas& canvas, const PlotSeries& series, const PlotAxes& axes, Ink ink) {
    ink.opacity *= band_opacity;
    std::vector<CanvasPoint> upper;
    std::vector<CanvasPoint> lower;
    const auto close = [&] {
        upper.insert(upper.end(), lower.rbegin(), lower.rend());
        if (upper.size() > 2) canvas.fill(upper, ink);
        upper.clear();
        lower.clear();
    };
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!axes.shows(series.x[i], series.y[i], series.on_right) ||
            !std::isfinite(series.y_low[i])) {
            close();
            continue;
        }
        upper.push_back(axes.at(series.x[i], series.y[i], series.on_right));
        lower.push_back(axes.at(series.x[i], series.y_low[i], series.on_right));
    }
    close();
}

/// Filled palely, and outlined thinly.
void draw_area(Canvas& canvas, const PlotSeries& series, const PlotAxes& axes, const Ink& ink) {
    Ink pale = ink;
    pale.opacity *= band_opacity;
    for (auto& piece : pieces_of(series, axes)) {
        if (piece.size() < 3) continue;
        canvas.fill(piece, pale);
        piece.push_back(piece.front());
        canvas.stroke(piece, 1.3 * canvas.line_width(), ink);
    }
}

/// Half an error bar, with its cap; where it leaves the frame it ends there in an arrow.
void draw_half_bar(Canvas& canvas, const CanvasBox& frame, const CanvasPoint& from,
                   const CanvasPoint& to, const Ink& ink) {
    const double font = canvas.font_size();
    const double width = 1.3 * canvas.line_width();
    const auto stroke = [&](const CanvasPoint& begin, const CanvasPoint& end) {
        canvas.stroke(std::array<CanvasPoint, 2>{begin, end}, width, ink);
    };
    const bool upright = to.x == from.x;
    const double across = upright ? error_bar_cap_em * font : 0.0;  // along the cap
    const double along = upright ? 0.0 : error_bar_cap_em * font;
    if (within(to, frame) || !within(from, frame)) {
        stroke(from, to);
        stroke({to.x - across, to.y - along}, {to.x + across, to.y + along});
        return;
    }
    const CanvasPoint tip{std::clamp(to.x, frame.x, frame.right()),
                          std::clamp(to.y, frame.y, frame.bottom())};
    const double way_x = upright ? 0.0 : (to.x > from.x ? 1.0 : -1.0);
    const double way_y = upright ? (to.y > from.y ? 1.0 : -1.0) : 0.0;
    const CanvasPoint foot{tip.x - way_x * arrow_head_em * font,
                           tip.y - way_y * arrow_head_em * font};
    stroke(from, foot);
    canvas.fill(
        std::array<CanvasPoint, 3>{
            {tip, {foot.x - across, foot.y - along}, {foot.x + across, foot.y + along}}},
        ink);
}

void draw_bars(Canvas& canvas, const PlotSeries& series, const PlotAxes& axes, const Ink& ink) {
    constexpr double rounding = 1e-6;  // units
    const CanvasBox frame = grown(axes.frame(), rounding);
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!axes.shows(series.x[i], series.y[i], series.on_right)) continue;
        if (!series.y_error.empty() && series.y_error[i] > 0.0) {
            for (const double side : {-1.0, 1.0}) {
                const CanvasPoint end =
                    axes.at(series.x[i], series.y[i] + side * series.y_error[i], series.on_right);
                draw_half_bar(canvas, frame, axes.at(series.x[i], series.y[i], series.on_right),
                              end, ink);
            }
        }
        if (!series.x_error.empty() && series.x_error[i] > 0.0) {
            for (const double side : {-1.0, 1.0}) {
                const CanvasPoint end =
                    axes.at(series.x[i] + side * series.x_error[i], series.y[i], series.on_right);
                draw_half_bar(canvas, frame, axes.at(series.x[i], series.y[i], series.on_right),
                              end, ink);
            }
        }
    }
}

void draw_curve(Canvas& canvas, const PlotSeries& series, const PlotAxes& axes,
                const SeriesLook& look) {
    const double width = line_width_of(canvas, series);
    const auto pieces = pieces_of(series, axes);
    for (const auto& piece : pieces) {
        if (piece.size() == 1 && pieces.size() > 1 && !has_markers(series)) {  // between gaps
            draw_marker(canvas, Marker::circle, piece.front(), width, look.ink);
            continue;
        }
        canvas.stroke(piece, width, look.ink, dash_lengths(look.dashes, width));
    }
}

void draw_markers(Canvas& canvas, const PlotSeries& series, const PlotAxes& axes,
                  const SeriesLook& look) {
    constexpr double rounding = 1e-6;  // units
    const double size = marker_size(canvas, series);
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!axes.shows(series.x[i], series.y[i], series.on_right)) continue;
        const CanvasPoint at = axes.at(series.x[i], series.y[i], series.on_right);
        if (!within(at, grown(axes.frame(), rounding))) continue;
        const bool hollow = !series.hollow.empty() && series.hollow[i];
        if (!series.inks.empty()) {  // pale colours end in an edge
            const double edge = 1.2 * canvas.line_width();
            draw_marker(canvas, look.marker, at, size + edge, dark_edge);
            draw_marker(canvas, look.marker, at, size, series.inks[i]);
            continue;
        }
        (hollow ? draw_hollow_marker : draw_marker)(canvas, look.marker, at, size, look.ink);
    }
}

}  // namespace

std::vector<SeriesLook> series_looks(const Plot& plot) {
    const auto is_given = [&plot](const Ink& ink) {
        return std::any_of(
            plot.series.begin(), plot.series.end(),
            [&ink](const PlotSeries& series) { return series.ink && alike(*series.ink, ink); });
    };
    std::vector<SeriesLook> looks;
    std::size_t next = 0;
    for (const PlotSeries& series : plot.series) {
        if (series.kind == SeriesKind::fit || series.ink) {
            looks.push_back({black_ink, Marker::circle, {}});
        } else {
            constexpr std::size_t cycle = 7;
            while (next < cycle && is_given(series_look(next).ink)) ++next;
            looks.push_back(series_look(next++));
        }
        SeriesLook& look = looks.back();
        if (has_markers(series)) look.dashes.clear();
        if (series.ink) look.ink = *series.ink;
        if (series.marker) look.marker = *series.marker;
        if (series.dashes) look.dashes = *series.dashes;
    }
    return looks;
}

double marker_size(const Canvas& canvas, const PlotSeries& series) {
    constexpr std::size_t few = 80;
    constexpr std::size_t many = 1000;
    const double size = series.x.size() <= few ? 0.5 : series.x.size() <= many ? 0.36 : 0.2;
    return size * canvas.font_size();
}

void draw_series(Canvas& canvas, const Plot& plot, const PlotAxes& axes) {
    const std::vector<SeriesLook> looks = series_looks(plot);
    const auto each = [&](const auto& draw) {
        for (std::size_t n = 0; n < looks.size(); ++n) draw(plot.series[n], looks[n]);
    };
    {
        const CanvasClip clip(canvas, axes.frame());
        each([&](const PlotSeries& series, const SeriesLook& look) {
            if (series.kind == SeriesKind::band) draw_band(canvas, series, axes, look.ink);
            if (series.kind == SeriesKind::area) draw_area(canvas, series, axes, look.ink);
        });
        each([&](const PlotSeries& series, const SeriesLook& look) {
            if (series.kind == SeriesKind::fit) draw_curve(canvas, series, axes, look);
        });
        each([&](const PlotSeries& series, const SeriesLook& look) {
            draw_bars(canvas, series, axes, look.ink);
            if (has_line(series) && series.kind != SeriesKind::fit)
                draw_curve(canvas, series, axes, look);
        });
    }
    each([&](const PlotSeries& series, const SeriesLook& look) {
        if (has_markers(series)) draw_markers(canvas, series, axes, look);
    });
}

void draw_sample(Canvas& canvas, const PlotSeries& series, const SeriesLook& look,
                 const CanvasPoint& at, double length) {
    const double font = canvas.font_size();
    if (series.kind == SeriesKind::band || series.kind == SeriesKind::area || series.with_band) {
        Ink ink = look.ink;
        ink.opacity *= band_opacity;
        const CanvasBox box{at.x, at.y - 0.3 * font, length, 0.6 * font};
        canvas.fill(box, ink);
        if (series.kind == SeriesKind::area) {
            const std::array<CanvasPoint, 5> edge{{{box.x, box.y},
                                                   {box.right(), box.y},
                                                   {box.right(), box.bottom()},
                                                   {box.x, box.bottom()},
                                                   {box.x, box.y}}};
            canvas.stroke(edge, 1.3 * canvas.line_width(), look.ink);
        }
    }
    if (has_line(series)) {
        const double width = line_width_of(canvas, series);
        canvas.stroke(std::array<CanvasPoint, 2>{{at, {at.x + length, at.y}}}, width, look.ink,
                      dash_lengths(look.dashes, width));
    }
    if (has_markers(series))
        draw_marker(canvas, look.marker, {at.x + 0.5 * length, at.y},
                    std::max(marker_size(canvas, series), 0.36 * font), look.ink);
}

CoveredArea clutter_of_series(const Canvas& canvas, const Plot& plot, const PlotAxes& axes) {
    CoveredArea clutter;
    for (const PlotSeries& series : plot.series) {
        if (has_line(series) || series.kind == SeriesKind::band ||
            series.kind == SeriesKind::area) {
            for (const auto& piece : pieces_of(series, axes)) {
                for (std::size_t i = 1; i < piece.size(); ++i)
                    clutter.segments.emplace_back(piece[i - 1], piece[i]);
            }
        }
        const double half = 0.5 * marker_size(canvas, series);
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            if (!axes.shows(series.x[i], series.y[i], series.on_right)) continue;
            const auto at = [&](double x, double y) { return axes.at(x, y, series.on_right); };
            const double x = series.x[i];
            const double y = series.y[i];
            if (has_markers(series))
                clutter.boxes.push_back(grown({at(x, y).x, at(x, y).y, 0.0, 0.0}, half));
            if (!series.y_error.empty())
                clutter.segments.emplace_back(at(x, y - series.y_error[i]),
                                              at(x, y + series.y_error[i]));
            if (!series.x_error.empty())
                clutter.segments.emplace_back(at(x - series.x_error[i], y),
                                              at(x + series.x_error[i], y));
            if (series.kind == SeriesKind::band)
                clutter.segments.emplace_back(at(x, series.y_low[i]), at(x, y));
        }
    }
    return clutter;
}

}  // namespace fumon
