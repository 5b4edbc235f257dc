#include "figure/plot/plot_drawing.h"

#include <algorithm>
#include <array>
#include <limits>

namespace fumon {

namespace {

struct LabelAnchor {
    CanvasPoint at;
    CanvasPoint anchor;
};

CanvasBox text_box(const Canvas& canvas, const std::string& text, const LabelAnchor& place) {
    const auto [width, height] = canvas.text_size(text, tick_text_size_em);
    return {place.at.x - place.anchor.x * width, place.at.y - place.anchor.y * height, width,
            height};
}

/// Takes the place within the frame that covers least, the first among equals, and adds the text to
/// the clutter.
PlotLabel best_anchor(const Canvas& canvas, const std::string& text, const CanvasBox& frame,
                      const std::vector<LabelAnchor>& places, CoveredArea& clutter) {
    const LabelAnchor* best = &places.front();
    int least = std::numeric_limits<int>::max();
    for (const LabelAnchor& place : places) {
        const CanvasBox box = text_box(canvas, text, place);
        constexpr int outside = 1'000'000;
        const int covers = clutter.within(box) + clutter.references_within(box) +
                           (within(box, frame) ? 0 : outside);
        if (covers >= least) continue;
        least = covers;
        best = &place;
    }
    CanvasBox box = text_box(canvas, text, *best);
    box.x = std::max(frame.x, std::min(box.x, frame.right() - box.width));
    box.y = std::max(frame.y, std::min(box.y, frame.bottom() - box.height));
    clutter.boxes.push_back(box);
    return {text, {box.x, box.y}, {0.0, 0.0}};
}

std::vector<LabelAnchor> anchors_at(const ReferenceLine& line, const CanvasBox& frame,
                                    const CanvasPoint& at, double gap) {
    if (line.upright)
        return {{{at.x + gap, frame.y + gap}, {0.0, 0.0}},
                {{at.x - gap, frame.y + gap}, {1.0, 0.0}},
                {{at.x + gap, frame.bottom() - gap}, {0.0, 1.0}},
                {{at.x - gap, frame.bottom() - gap}, {1.0, 1.0}}};
    const double low_gap = 0.4 * gap;
    return {{{frame.right() - gap, at.y - low_gap}, {1.0, 1.0}},
            {{frame.x + gap, at.y - low_gap}, {0.0, 1.0}},
            {{frame.right() - gap, at.y + low_gap}, {1.0, 0.0}},
            {{frame.x + gap, at.y + low_gap}, {0.0, 0.0}}};
}

std::vector<LabelAnchor> anchors_at(const CanvasBox& box, bool fits, double gap) {
    const CanvasPoint middle = box.middle();
    std::vector<LabelAnchor> places;
    if (fits) places.push_back({middle, {0.5, 0.5}});
    if (fits) places.push_back({{box.x + gap, box.y + gap}, {0.0, 0.0}});
    if (fits) places.push_back({{box.right() - gap, box.bottom() - gap}, {1.0, 1.0}});
    for (const auto& [x, share] : {std::pair{middle.x, 0.5}, {box.x, 0.0}, {box.right(), 1.0}}) {
        places.push_back({{x, box.y - gap}, {share, 1.0}});
        places.push_back({{x, box.bottom() + gap}, {share, 0.0}});
    }
    for (const auto& [y, share] : {std::pair{middle.y, 0.5}, {box.y, 0.0}, {box.bottom(), 1.0}}) {
        places.push_back({{box.right() + gap, y}, {0.0, share}});
        places.push_back({{box.x - gap, y}, {1.0, share}});
    }
    return places;
}

}  // namespace

PlotDrawing::PlotDrawing(const Canvas& canvas, const Plot& plot, const CanvasBox& frame,
                         double stretch)
    : axes(canvas, plot, frame, stretch) {
    const double gap = 0.4 * canvas.font_size();
    CoveredArea clutter = clutter_of_series(canvas, plot, axes);
    std::vector<CanvasBox> stated;
    for (const PlotBox& box : plot.boxes) {
        const CanvasPoint low = axes.at(box.x_low, box.y_low);
        const CanvasPoint high = axes.at(box.x_high, box.y_high);
        stated.push_back({low.x, high.y, high.x - low.x, low.y - high.y});
    }
    for (const ReferenceLine& line : plot.lines) {
        const CanvasPoint at = line.upright ? CanvasPoint{axes.at(line.value, 1.0).x, frame.y}
                                            : CanvasPoint{frame.x, axes.at(1.0, line.value).y};
        clutter.references.emplace_back(at, line.upright ? CanvasPoint{at.x, frame.bottom()}
                                                         : CanvasPoint{frame.right(), at.y});
    }
    for (const PlotText& text : plot.texts)
        labels.push_back(best_anchor(canvas, text.text, frame,
                                     {{axes.at(text.x, text.y), text.anchor}}, clutter));
    for (const CanvasBox& share : plot.taken)
        clutter.boxes.push_back({frame.x + share.x * frame.width, frame.y + share.y * frame.height,
                                 share.width * frame.width, share.height * frame.height});
    margins = axes.margins(canvas);
    CoveredArea with_boxes = clutter;
    with_boxes.boxes.insert(with_boxes.boxes.end(), stated.begin(), stated.end());
    legend = place_legend(canvas, plot, axes, margins, with_boxes);
    if (legend && legend->inside) clutter.boxes.push_back(legend->box);
    if (legend && !legend->inside) {
        margins.left = std::max(margins.left, frame.x - legend->box.x);
        margins.right = std::max(margins.right, legend->box.right() - frame.right());
        margins.below = std::max(margins.below, legend->box.bottom() - frame.bottom());
    }
    for (std::size_t i = 0; i < stated.size(); ++i) {
        if (plot.boxes[i].label.empty()) continue;
        const auto [width, height] = canvas.text_size(plot.boxes[i].label, tick_text_size_em);
        const bool fits = width <= stated[i].width - gap && height <= stated[i].height;
        CoveredArea others = clutter;
        for (std::size_t j = 0; j < stated.size(); ++j) {
            if (j != i) others.boxes.push_back(stated[j]);
        }
        labels.push_back(best_anchor(canvas, plot.boxes[i].label, frame,
                                     anchors_at(stated[i], fits, 0.4 * gap), others));
        clutter.boxes.push_back(others.boxes.back());
    }
    for (const ReferenceLine& line : plot.lines) {
        if (line.label.empty()) continue;
        const CanvasPoint at = line.upright ? CanvasPoint{axes.at(line.value, 1.0).x, frame.y}
                                            : CanvasPoint{frame.x, axes.at(1.0, line.value).y};
        labels.push_back(
            best_anchor(canvas, line.label, frame, anchors_at(line, frame, at, gap), clutter));
    }
}

PlotDrawing plot_drawing(const Canvas& canvas, const Plot& plot, const CanvasBox& frame) {
    PlotDrawing first(canvas, plot, frame, 0.0);
    if (!first.legend || first.legend->inside || plot.legend != LegendPosition::automatic ||
        plot.y.high)
        return first;
    for (const double stretch : {0.15, 0.3, 0.45}) {
        PlotDrawing drawing(canvas, plot, frame, stretch);
        if (drawing.legend->inside) return drawing;
    }
    return first;
}

}  // namespace fumon
