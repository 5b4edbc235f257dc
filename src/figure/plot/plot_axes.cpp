#include "figure/plot/plot_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "figure/plot/axes.h"
#include "figure/plot/ticks.h"

namespace fumon {

namespace {

constexpr double major_mark_em = 0.3;  // font sizes
constexpr double minor_mark_em = 0.17;
constexpr double label_gap_em = 0.2;  // between marks, their labels and the axis's label
constexpr int most_label_count = 8;
constexpr double label_spacing_across_em = 0.9;  // tick labels, font sizes
constexpr double label_spacing_upward_em = 0.6;

double text_height(const Canvas& canvas, double size) {
    return canvas.text_size("0", size)[1];
}

double widest_label(const Canvas& canvas, const PlotTicks& ticks) {
    double widest = 0.0;
    for (const std::string& label : ticks.labels)
        widest = std::max(widest, canvas.text_size(label, tick_text_size_em)[0]);
    return widest;
}

/// The marks whose labels stand `apart` font sizes from the one before, along an axis that is
/// `length` long; `dimension` 0 of the labels, their width, lies along it, or 1, their height.
std::vector<std::size_t> kept_apart(const Canvas& canvas, const PlotScale& scale,
                                    const PlotTicks& ticks, double length, std::size_t dimension,
                                    double apart) {
    std::vector<std::size_t> kept;
    double end = -INFINITY;
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double half =
            0.5 * canvas.text_size(ticks.labels[i], tick_text_size_em).at(dimension);
        const double middle = scale.share(ticks.values[i]) * length;
        if (middle - half < end + apart * canvas.font_size()) continue;
        end = middle + half;
        kept.push_back(i);
    }
    return kept;
}

/// As many marks as there is room for the labels of.
PlotTicks fitting_ticks(const Canvas& canvas, const PlotScale& scale, double length,
                        std::size_t dimension, double apart) {
    PlotTicks ticks;
    std::vector<std::size_t> kept;
    for (int most = most_label_count; most >= 2; --most) {
        ticks = plot_ticks(scale, most);
        kept = kept_apart(canvas, scale, ticks, length, dimension, apart);
        if (kept.size() == ticks.values.size()) return ticks;
    }
    PlotTicks fewer{{}, {}, ticks.minor, ticks.power};
    for (const std::size_t i : kept) {
        fewer.values.push_back(ticks.values[i]);
        fewer.labels.push_back(ticks.labels[i]);
    }
    return fewer;
}

/// The marks that an axis names, all of them, with those of the words that there is room for.
PlotTicks named_ticks(const Canvas& canvas, const PlotScale& scale, const PlotAxis& axis,
                      double length, std::size_t dimension) {
    constexpr double apart = 0.4;  // words, font sizes
    PlotTicks all;
    for (const auto& [value, word] : axis.named) {
        all.values.push_back(value);
        all.labels.push_back(word);
    }
    const std::vector<std::size_t> kept =
        kept_apart(canvas, scale, all, length, dimension, dimension == 0 ? apart : 0.0);
    for (std::size_t i = 0; i < all.labels.size(); ++i) {
        if (std::ranges::find(kept, i) == kept.end()) all.labels[i].clear();
    }
    return all;
}

/// A label with the power of ten that its tick labels are to be taken times: "height (10⁻³ m)".
std::string with_power(const std::string& label, int power) {
    if (power == 0) return label;
    const std::size_t unit = label.rfind('(');
    if (unit != std::string::npos && label.ends_with(')'))
        return label.substr(0, unit + 1) + power_of_ten(power) + ' ' + label.substr(unit + 1);
    return label + (label.empty() ? "(×" : " (×") + power_of_ten(power) + ')';
}

}  // namespace

PlotAxes::PlotAxes(const Canvas& canvas, const Plot& plot, const CanvasBox& frame, double stretch)
    : frame_(frame) {
    const PlotRanges ranges = plot_ranges(plot);
    const auto upright = [&](const PlotAxis& axis, const ValueRange& range) {
        const PlotScale scale = plot_scale(axis, range, room_along_y_share);
        return side(canvas, axis, stretch > 0.0 && !axis.high ? stretched(scale, stretch) : scale,
                    frame_.height, 1, label_spacing_upward_em);
    };
    x_ = side(canvas, plot.x, plot_scale(plot.x, ranges.x, room_along_x(plot)), frame_.width, 0,
              label_spacing_across_em);
    y_ = upright(plot.y, ranges.y);
    if (plot.right) right_ = upright(*plot.right, ranges.right);
}

PlotAxes::Side PlotAxes::side(const Canvas& canvas, const PlotAxis& axis, const PlotScale& scale,
                              double length, std::size_t dimension, double apart) {
    Side side{scale,
              axis.named.empty() ? fitting_ticks(canvas, scale, length, dimension, apart)
                                 : named_ticks(canvas, scale, axis, length, dimension),
              "", axis.tick_labels, 0.0};
    if (!axis.ticks) side.ticks = {};
    side.label =
        in_two_lines(canvas, with_power(axis.label, side.ticks.power), length, label_text_size_em);
    side.widest = widest_label(canvas, side.ticks);
    return side;
}

CanvasPoint PlotAxes::at(double x, double y, bool on_right) const {
    const PlotScale& upright = on_right && right_ ? right_->scale : y_.scale;
    constexpr double far = 100.0;  // frames
    return {frame_.x + frame_.width * std::clamp(x_.scale.share(x), -far, far),
            frame_.y + frame_.height * (1.0 - std::clamp(upright.share(y), -far, far))};
}

bool PlotAxes::shows(double x, double y, bool on_right) const {
    return x_.scale.shows(x) && (on_right && right_ ? right_->scale : y_.scale).shows(y);
}

double PlotAxes::room_beside(const Canvas& canvas, const Side& side) const {
    const double font = canvas.font_size();
    if (!side.labelled) return major_mark_em * font;
    const double label = side.label.empty() ? 0.0
                                            : canvas.text_size(side.label, label_text_size_em)[1] +
                                                  label_gap_em * font;
    return (major_mark_em + label_gap_em) * font + side.widest + label;
}

PanelMargins PlotAxes::margins(const Canvas& canvas) const {
    const double font = canvas.font_size();
    PanelMargins margins{room_beside(canvas, y_), right_ ? room_beside(canvas, *right_) : 0.0, 0.0,
                         major_mark_em * font};
    if (x_.labelled) {
        margins.below += label_gap_em * font + text_height(canvas, tick_text_size_em);
        if (!x_.label.empty())
            margins.below +=
                label_gap_em * font + canvas.text_size(x_.label, label_text_size_em)[1];
        for (std::size_t i = 0; i < x_.ticks.values.size(); ++i) {
            const double half = 0.5 * canvas.text_size(x_.ticks.labels[i], tick_text_size_em)[0];
            const double middle = x_.scale.share(x_.ticks.values[i]) * frame_.width;
            margins.left = std::max(margins.left, half - middle);
            margins.right = std::max(margins.right, middle + half - frame_.width);
        }
        if (!x_.label.empty()) {
            const double beyond =
                0.5 * (canvas.text_size(x_.label, label_text_size_em)[0] - frame_.width);
            margins.left = std::max(margins.left, beyond);
            margins.right = std::max(margins.right, beyond);
        }
    }
    const double half = 0.5 * text_height(canvas, tick_text_size_em);
    const auto raise_for = [&](const Side& side) {
        if (!side.labelled) return;
        for (const double value : side.ticks.values) {
            const double up = side.scale.share(value) * frame_.height;
            margins.above = std::max(margins.above, up + half - frame_.height);
            margins.below = std::max(margins.below, half - up);
        }
        if (side.label.empty()) return;
        const double beyond =
            0.5 * (canvas.text_size(side.label, label_text_size_em)[0] - frame_.height);
        margins.above = std::max(margins.above, beyond);
        margins.below = std::max(margins.below, beyond);
    };
    raise_for(y_);
    if (right_) raise_for(*right_);
    const double line = 0.5 * canvas.line_width();
    return {std::max(margins.left, line), std::max(margins.right, line),
            std::max(margins.above, line), std::max(margins.below, line)};
}

void PlotAxes::draw(Canvas& canvas) const {
    outline(canvas, frame_, canvas.line_width());
    draw_across(canvas);
    draw_upward(canvas, y_, false);
    if (right_) draw_upward(canvas, *right_, true);
}

void PlotAxes::draw_across(Canvas& canvas) const {
    const double font = canvas.font_size();
    const double line = canvas.line_width();
    const double bottom = frame_.bottom();
    const auto mark = [&](double value, double length) {
        const double x = frame_.x + frame_.width * x_.scale.share(value);
        canvas.stroke(std::array<CanvasPoint, 2>{{{x, bottom}, {x, bottom + length * font}}}, line,
                      black_ink);
        return x;
    };
    for (const double value : x_.ticks.minor) mark(value, minor_mark_em);
    const double labels = bottom + (major_mark_em + label_gap_em) * font;
    for (std::size_t i = 0; i < x_.ticks.values.size(); ++i) {
        const double x = mark(x_.ticks.values[i], major_mark_em);
        if (x_.labelled)
            canvas.write(x_.ticks.labels[i], {x, labels}, {0.5, 0.0}, black_ink, tick_text_size_em);
    }
    if (!x_.labelled) return;
    const double below = labels + text_height(canvas, tick_text_size_em) + label_gap_em * font;
    if (!x_.label.empty())
        canvas.write(x_.label, {frame_.middle().x, below}, {0.5, 0.0}, black_ink,
                     label_text_size_em);
}

void PlotAxes::draw_upward(Canvas& canvas, const Side& side, bool on_right) const {
    const double font = canvas.font_size();
    const double line = canvas.line_width();
    const double outward = on_right ? 1.0 : -1.0;
    const double edge = on_right ? frame_.right() : frame_.x;
    const double anchor = on_right ? 0.0 : 1.0;
    const auto mark = [&](double value, double length) {
        const double y = frame_.bottom() - frame_.height * side.scale.share(value);
        canvas.stroke(std::array<CanvasPoint, 2>{{{edge, y}, {edge + outward * length * font, y}}},
                      line, black_ink);
        return y;
    };
    for (const double value : side.ticks.minor) mark(value, minor_mark_em);
    const double labels = edge + outward * (major_mark_em + label_gap_em) * font;
    for (std::size_t i = 0; i < side.ticks.values.size(); ++i) {
        const double y = mark(side.ticks.values[i], major_mark_em);
        if (!side.labelled) continue;
        // Flush with the digits of all others.
        const double x = on_right ? labels + side.widest : labels;
        canvas.write(side.ticks.labels[i], {x, y}, {1.0, 0.5}, black_ink, tick_text_size_em);
    }
    if (!side.labelled) return;
    if (side.label.empty()) return;
    canvas.write(side.label,
                 {labels + outward * (side.widest + label_gap_em * font), frame_.middle().y},
                 {anchor, 0.5}, black_ink, label_text_size_em, true);
}

}  // namespace fumon
