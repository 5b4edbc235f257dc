#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "figure/plot/plot_drawing.h"

namespace fumon {

namespace {

constexpr double sample_length_em = 2.2;   // its length, font sizes
constexpr double sample_gap_em = 0.5;      // before its text
constexpr double legend_padding_em = 0.3;  // around all
constexpr double frame_gap_em = 0.5;       // from the frame
constexpr double column_gap_em = 1.2;
constexpr double row_height_em = 1.25;    // of the text's own
constexpr double widest_beside_em = 9.0;  // a legend right of the frame, font sizes
constexpr int fewest_beside_entries = 4;  // its entries; fewer stand in a row below

/// The series with a label, and their texts in columns, each as wide as its widest.
struct Entries {
    std::vector<std::size_t> series;
    std::vector<double> widths;  ///< of each, with its sample
    double height = 0.0;         ///< of each row

    [[nodiscard]] int count() const { return static_cast<int>(series.size()); }
    [[nodiscard]] int rows(int columns) const { return (count() + columns - 1) / columns; }
    [[nodiscard]] double column_width(int column, int columns) const {
        double width = 0.0;
        for (int i = column * rows(columns); i < std::min((column + 1) * rows(columns), count());
             ++i)
            width = std::max(width, widths[static_cast<std::size_t>(i)]);
        return width;
    }
};

Entries entries_of(const Canvas& canvas, const Plot& plot) {
    Entries entries;
    const double font = canvas.font_size();
    for (std::size_t n = 0; n < plot.series.size(); ++n) {
        if (plot.series[n].label.empty()) continue;
        const auto [width, height] = canvas.text_size(plot.series[n].label, tick_text_size_em);
        entries.series.push_back(n);
        entries.widths.push_back(width + (sample_length_em + sample_gap_em) * font);
        entries.height = std::max(entries.height, row_height_em * height);
    }
    return entries;
}

/// Width and height in so many columns.
std::array<double, 2> size_of(const Entries& entries, int columns, double font) {
    double width = (2.0 * legend_padding_em + (columns - 1) * column_gap_em) * font;
    for (int column = 0; column < columns; ++column) width += entries.column_width(column, columns);
    return {width, entries.rows(columns) * entries.height + 2.0 * legend_padding_em * font};
}

struct Anchor {
    double across;  // 0: left … 1: right
    double down;
};

constexpr std::array<Anchor, 4> legend_corners{{{1.0, 0.0}, {0.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
constexpr std::array<Anchor, 4> sides{{{0.5, 0.0}, {0.5, 1.0}, {1.0, 0.5}, {0.0, 0.5}}};

CanvasBox box_at(const Anchor& place, const CanvasBox& frame, double width, double height,
                 double gap) {
    return {frame.x + gap + place.across * (frame.width - width - 2.0 * gap),
            frame.y + gap + place.down * (frame.height - height - 2.0 * gap), width, height};
}

std::optional<Anchor> named_corner(LegendPosition place) {
    switch (place) {
        case LegendPosition::upper_right:
            return legend_corners[0];
        case LegendPosition::upper_left:
            return legend_corners[1];
        case LegendPosition::lower_right:
            return legend_corners[2];
        case LegendPosition::lower_left:
            return legend_corners[3];
        default:
            return std::nullopt;
    }
}

/// Whether part of a segment lies in a box (Liang & Barsky 1984).
bool touches(const std::pair<CanvasPoint, CanvasPoint>& segment, const CanvasBox& box) {
    const auto& [from, to] = segment;
    double start = 0.0;  // of that part, as a share of the segment
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
    return start <= end;
}

/// Within the frame, where it covers nothing; over references only if there is no other place.
std::optional<LegendBox> free_place(const Entries& entries, const CanvasBox& frame, double font,
                                    const CoveredArea& clutter) {
    const double gap = frame_gap_em * font;
    std::optional<LegendBox> over_references;
    for (int columns = 1; columns <= entries.count(); ++columns) {
        const auto [across, down] = size_of(entries, columns, font);
        if (across + 2.0 * gap > frame.width || down + 2.0 * gap > frame.height) continue;
        for (const auto& places : {legend_corners, sides}) {
            for (const Anchor& place : places) {
                const LegendBox legend{box_at(place, frame, across, down, gap), columns, true};
                const CanvasBox room = grown(legend.box, 0.5 * gap);
                if (clutter.within(room) > 0) continue;
                if (clutter.references_within(room) == 0) return legend;
                if (!over_references) over_references = legend;
            }
        }
    }
    return over_references;
}

LegendBox below(const Entries& entries, const CanvasBox& frame, const PanelMargins& margins,
                double font) {
    int columns = 1;
    for (int more = 2; more <= entries.count(); ++more) {
        if (size_of(entries, more, font)[0] <= frame.width) columns = more;
    }
    const auto [width, height] = size_of(entries, columns, font);
    return {{frame.x + 0.5 * (frame.width - width),
             frame.bottom() + margins.below + legend_padding_em * font, width, height},
            columns,
            false};
}

}  // namespace

int CoveredArea::within(const CanvasBox& box) const {
    return static_cast<int>(
        std::count_if(boxes.begin(), boxes.end(),
                      [&box](const CanvasBox& one) { return overlap(one, box); }) +
        std::count_if(segments.begin(), segments.end(),
                      [&box](const auto& one) { return touches(one, box); }));
}

int CoveredArea::references_within(const CanvasBox& box) const {
    return static_cast<int>(std::count_if(references.begin(), references.end(),
                                          [&box](const auto& one) { return touches(one, box); }));
}

std::optional<LegendBox> place_legend(const Canvas& canvas, const Plot& plot, const PlotAxes& axes,
                                      const PanelMargins& margins, const CoveredArea& clutter) {
    const Entries entries = entries_of(canvas, plot);
    if (entries.series.empty() || plot.legend == LegendPosition::none) return std::nullopt;
    const double font = canvas.font_size();
    const CanvasBox& frame = axes.frame();
    const auto [width, height] = size_of(entries, 1, font);
    const double gap = frame_gap_em * font;
    if (const auto corner = named_corner(plot.legend))
        return LegendBox{box_at(*corner, frame, width, height, gap), 1, true};
    if (plot.legend == LegendPosition::automatic) {
        if (const auto place = free_place(entries, frame, font, clutter)) return place;
    }
    const bool beside =
        plot.legend == LegendPosition::right ||
        (plot.legend == LegendPosition::automatic && entries.count() >= fewest_beside_entries &&
         width <= widest_beside_em * font);
    if (!beside) return below(entries, frame, margins, font);
    return LegendBox{{frame.right() + margins.right + gap, frame.y, width, height}, 1, false};
}

void draw_legend(Canvas& canvas, const Plot& plot, const LegendBox& legend) {
    const Entries entries = entries_of(canvas, plot);
    const std::vector<SeriesLook> looks = series_looks(plot);
    const double font = canvas.font_size();
    if (legend.inside) canvas.fill(legend.box, white_ink);
    const int rows = entries.rows(legend.columns);
    double x = legend.box.x + legend_padding_em * font;
    for (int i = 0; i < entries.count(); ++i) {
        if (i > 0 && i % rows == 0)
            x += entries.column_width(i / rows - 1, legend.columns) + column_gap_em * font;
        const std::size_t n = entries.series[static_cast<std::size_t>(i)];
        const CanvasPoint at{
            x, legend.box.y + legend_padding_em * font + (i % rows + 0.5) * entries.height};
        draw_sample(canvas, plot.series[n], looks[n], at, sample_length_em * font);
        canvas.write(plot.series[n].label, {at.x + (sample_length_em + sample_gap_em) * font, at.y},
                     {0.0, 0.5}, black_ink, tick_text_size_em);
    }
}

}  // namespace fumon
