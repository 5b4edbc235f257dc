#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "figure/plot_drawing.h"

namespace fumon {

namespace {

constexpr Ink black{0.0, 0.0, 0.0, 1.0};
constexpr Ink paper{1.0, 1.0, 1.0, 0.85};
constexpr double sample = 2.2;      // its length, font sizes
constexpr double sample_gap = 0.5;  // before its text
constexpr double padding = 0.3;     // around all
constexpr double apart = 0.5;       // from the frame
constexpr double column_gap = 1.2;
constexpr double row_height = 1.25;  // of the text's own
constexpr double widest_beside = 9.0;

struct Entries {
    std::vector<std::size_t> series;
    double width = 0.0;   ///< of the widest, with its sample
    double height = 0.0;  ///< of each
};

Entries entries_of(const Canvas& canvas, const Plot& plot) {
    Entries entries;
    const double font = canvas.font_size();
    for (std::size_t n = 0; n < plot.series.size(); ++n) {
        if (plot.series[n].label.empty()) continue;
        const auto [width, height] = canvas.text_size(plot.series[n].label, tick_text);
        entries.series.push_back(n);
        entries.width = std::max(entries.width, width + (sample + sample_gap) * font);
        entries.height = std::max(entries.height, row_height * height);
    }
    return entries;
}

/// Width and height in so many columns.
std::array<double, 2> size_of(const Entries& entries, int columns, double font) {
    const int count = static_cast<int>(entries.series.size());
    const int rows = (count + columns - 1) / columns;
    return {columns * entries.width + (columns - 1) * column_gap * font + 2.0 * padding * font,
            rows * entries.height + 2.0 * padding * font};
}

struct Place {
    double across;  // 0: left … 1: right
    double down;
};

constexpr std::array<Place, 4> corners{{{1.0, 0.0}, {0.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
constexpr std::array<Place, 4> sides{{{0.5, 0.0}, {0.5, 1.0}, {1.0, 0.5}, {0.0, 0.5}}};

CanvasBox box_at(const Place& place, const CanvasBox& frame, double width, double height,
                 double gap) {
    return {frame.x + gap + place.across * (frame.width - width - 2.0 * gap),
            frame.y + gap + place.down * (frame.height - height - 2.0 * gap), width, height};
}

std::optional<Place> named_corner(LegendPlace place) {
    switch (place) {
        case LegendPlace::upper_right:
            return corners[0];
        case LegendPlace::upper_left:
            return corners[1];
        case LegendPlace::lower_right:
            return corners[2];
        case LegendPlace::lower_left:
            return corners[3];
        default:
            return std::nullopt;
    }
}

LegendBox below(const Entries& entries, const CanvasBox& frame, const PanelMargins& margins,
                double font) {
    const int count = static_cast<int>(entries.series.size());
    int columns = 1;
    while (columns < count && size_of(entries, columns + 1, font)[0] <= frame.width) ++columns;
    const auto [width, height] = size_of(entries, columns, font);
    return {{frame.x + 0.5 * (frame.width - width), frame.bottom() + margins.below + padding * font,
             width, height},
            columns,
            false};
}

}  // namespace

int Clutter::within(const CanvasBox& box) const {
    int count = 0;
    for (const CanvasBox& one : boxes) count += overlap(one, box) ? 1 : 0;
    for (const auto& [from, to] : segments) {
        // The part of the segment that lies in the box, as shares of it (Liang & Barsky 1984).
        double start = 0.0;
        double end = 1.0;
        const auto cut = [&](double begin, double step, double low, double high) {
            if (step == 0.0) {
                if (begin < low || begin > high) end = -1.0;
                return;
            }
            const double a = (low - begin) / step;
            const double b = (high - begin) / step;
            start = std::max(start, std::min(a, b));
            end = std::min(end, std::max(a, b));
        };
        cut(from.x, to.x - from.x, box.x, box.right());
        cut(from.y, to.y - from.y, box.y, box.bottom());
        count += start <= end ? 1 : 0;
    }
    return count;
}

std::optional<LegendBox> place_legend(const Canvas& canvas, const Plot& plot, const PlotAxes& axes,
                                      const PanelMargins& margins, const Clutter& clutter) {
    const Entries entries = entries_of(canvas, plot);
    if (entries.series.empty() || plot.legend == LegendPlace::none) return std::nullopt;
    const double font = canvas.font_size();
    const CanvasBox& frame = axes.frame();
    const auto [width, height] = size_of(entries, 1, font);
    const double gap = apart * font;
    if (const auto corner = named_corner(plot.legend))
        return LegendBox{box_at(*corner, frame, width, height, gap), 1, true};
    if (plot.legend == LegendPlace::automatic && width + 2.0 * gap <= frame.width &&
        height + 2.0 * gap <= frame.height) {
        for (const auto& places : {corners, sides}) {
            for (const Place& place : places) {
                const CanvasBox box = box_at(place, frame, width, height, gap);
                if (clutter.within(grown(box, 0.5 * gap)) == 0) return LegendBox{box, 1, true};
            }
        }
    }
    const bool beside = plot.legend == LegendPlace::right ||
                        (plot.legend == LegendPlace::automatic && width <= widest_beside * font);
    if (!beside) return below(entries, frame, margins, font);
    return LegendBox{{frame.right() + margins.right + gap, frame.y, width, height}, 1, false};
}

void draw_legend(Canvas& canvas, const Plot& plot, const LegendBox& legend) {
    const Entries entries = entries_of(canvas, plot);
    const std::vector<SeriesLook> looks = series_looks(plot);
    const double font = canvas.font_size();
    if (legend.inside) canvas.fill(legend.box, paper);
    const int count = static_cast<int>(entries.series.size());
    const int rows = (count + legend.columns - 1) / legend.columns;
    for (int i = 0; i < count; ++i) {
        const std::size_t n = entries.series[static_cast<std::size_t>(i)];
        const CanvasPoint at{
            legend.box.x + padding * font + i / rows * (entries.width + column_gap * font),
            legend.box.y + padding * font + (i % rows + 0.5) * entries.height};
        draw_sample(canvas, plot.series[n], looks[n], at, sample * font);
        canvas.write(plot.series[n].label, {at.x + (sample + sample_gap) * font, at.y}, {0.0, 0.5},
                     black, tick_text);
    }
}

}  // namespace fumon
