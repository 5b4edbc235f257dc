#include "figure/panels/colour_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "figure/plot/axes.h"
#include "figure/plot/ticks.h"

namespace fumon {

namespace {

constexpr double bar_tick_text_size_em = 0.85;  // of the font size, as are those below
constexpr double bar_label_text_size_em = 0.95;
constexpr double tick_mark_em = 0.25;
constexpr double tick_text_gap_em = 0.4;
constexpr double label_gap_em = 0.25;
constexpr double label_overhang_em = 0.2;  // by which a label may be longer than its bar
constexpr int most_tick_count = 8;
constexpr double bar_width_em = 0.9;
constexpr double frame_gap_em = 0.8;
constexpr double bar_below_gap_em = 0.5;

constexpr double triangle_length_ratio = 0.8;  // of the bar's width

/// A bar's ticks, the room that their texts take, and how its label is written.
struct BarLayout {
    Ticks ticks;
    double widest = 0.0;
    double highest = 0.0;
    std::string label;  ///< in one line or two
    double label_size = bar_label_text_size_em;
    double label_height = 0.0;
};

/// Ticks at both ends of a bar too, in place of those nearer to them than `apart`, a share of the
/// bar. Their labels have a digit more than those of round numbers, where they need it.
Ticks with_ends(const Ticks& round, const ColourScale& scale, int most, double apart) {
    const double range = scale.high - scale.low;
    const int exponent = round_step(scale.low, scale.high, most).exponent;
    const auto label = [&](double end) {
        std::string few = plain_number(end, std::max(0, -exponent));
        std::string more = plain_number(end, std::max(0, 1 - exponent));
        return more == few + "0" || more == few + ".0" ? few : more;
    };
    const auto near = [&](double a, double b) { return std::abs(a - b) < apart * range; };
    Ticks ticks;
    const auto add = [&ticks](double value, const std::string& label) {
        ticks.values.push_back(value);
        ticks.labels.push_back(label);
    };
    const auto is_round = [&](double end) {
        return std::any_of(round.values.begin(), round.values.end(),
                           [&](double value) { return std::abs(value - end) < 1e-6 * range; });
    };
    if (!is_round(scale.low)) add(scale.low, label(scale.low));
    for (std::size_t i = 0; i < round.values.size(); ++i) {
        const double value = round.values[i];
        const bool in_the_way = (near(value, scale.low) && !is_round(scale.low)) ||
                                (near(value, scale.high) && !is_round(scale.high));
        if (!in_the_way) add(value, round.labels[i]);
    }
    if (!is_round(scale.high)) add(scale.high, label(scale.high));
    return ticks;
}

/// The names of a scale's classes, at their middles.
Ticks class_ticks(const ColourScale& scale) {
    Ticks ticks;
    const auto count = static_cast<double>(scale.classes.size());
    for (std::size_t i = 0; i < scale.classes.size(); ++i) {
        const double share = (static_cast<double>(i) + 0.5) / count;
        ticks.values.push_back(std::lerp(scale.low, scale.high, share));
        ticks.labels.push_back(scale.classes[i]);
    }
    return ticks;
}

BarLayout lay_out_bar(const Canvas& canvas, double length, const ColourScale& scale,
                      BarDirection direction) {
    const double font = canvas.font_size();
    const bool upright = direction == BarDirection::upright;
    BarLayout layout;
    int most =
        std::clamp(static_cast<int>(length / ((upright ? 1.5 : 2.2) * font)), 2, most_tick_count);
    for (;; --most) {
        layout.ticks =
            scale.classes.empty() ? linear_ticks(scale.low, scale.high, most) : class_ticks(scale);
        if (scale.ends_labelled && scale.classes.empty()) {
            const double label = upright ? 1.3 * canvas.text_size("0", bar_tick_text_size_em)[1]
                                         : layout.widest + 0.6 * font;
            layout.ticks = with_ends(layout.ticks, scale, most, std::min(label / length, 0.5));
        }
        layout.widest = 0.0;
        for (const std::string& label : layout.ticks.labels) {
            const auto [width, height] = canvas.text_size(label, bar_tick_text_size_em);
            layout.widest = std::max(layout.widest, width);
            layout.highest = std::max(layout.highest, height);
        }
        const auto count = static_cast<double>(layout.ticks.labels.size());
        if (upright || most <= 2 || count * (layout.widest + 0.6 * font) <= length) break;
    }
    if (scale.label.empty()) return layout;
    const double longest = length + 2.0 * label_overhang_em * font;
    layout.label = in_two_lines(canvas, scale.label, longest, bar_label_text_size_em);
    const auto [width, height] = canvas.text_size(layout.label, bar_label_text_size_em);
    const double shrink = std::min(1.0, longest / width);
    layout.label_size = bar_label_text_size_em * shrink;
    layout.label_height = height * shrink + label_gap_em * font;
    return layout;
}

/// A triangle in the end colour, pointing beyond the bar's end.
void draw_triangle(Canvas& canvas, const CanvasBox& bar, const ColourScale& scale, bool upright,
                   bool at_high, const Ink& ink) {
    const double length = triangle_length_ratio * (upright ? bar.width : bar.height);
    const double end = upright ? (at_high ? bar.y : bar.bottom()) : (at_high ? bar.right() : bar.x);
    const double tip = end + (at_high == upright ? -length : length);  // y points down
    const std::array<CanvasPoint, 3> corners =
        upright ? std::array<CanvasPoint, 3>{{{bar.x, end},
                                              {bar.x + 0.5 * bar.width, tip},
                                              {bar.right(), end}}}
                : std::array<CanvasPoint, 3>{
                      {{end, bar.y}, {tip, bar.y + 0.5 * bar.height}, {end, bar.bottom()}}};
    canvas.fill(corners, scale.ink(at_high ? scale.high : scale.low));
    canvas.stroke(corners, canvas.line_width(), ink);
}

/// The palette from one end to the other: two pixels a colour, one at the ends, as place() rounds.
Image gradient(const ColourScale& scale, BarDirection direction) {
    constexpr int pixels = 510;
    const bool upright = direction == BarDirection::upright;
    Image image(upright ? 1 : pixels, upright ? pixels : 1);
    for (int i = 0; i < pixels; ++i) {
        const auto& colour = scale.palette[static_cast<std::size_t>((i + 1) / 2)];
        const int at = upright ? pixels - 1 - i : i;
        std::copy(colour.begin(), colour.end(), image.rgb.begin() + std::ptrdiff_t{3} * at);
    }
    return image;
}

CanvasBox placed_bar(const Canvas& canvas, const CanvasBox& frame, double below,
                     BarPosition place) {
    const double font = canvas.font_size();
    if (place == BarPosition::below)
        return {frame.x, frame.bottom() + below + bar_below_gap_em * font, frame.width,
                bar_width_em * font};
    return {frame.right() + frame_gap_em * font, frame.y, bar_width_em * font, frame.height};
}

}  // namespace

std::size_t ColourScale::place(double value) const {
    const double last = static_cast<double>(palette.size()) - 1.0;
    return static_cast<std::size_t>(
        std::lround(std::clamp((value - low) / (high - low), 0.0, 1.0) * last));
}

Ink ColourScale::ink(double value) const {
    const auto& colour = palette[place(value)];
    constexpr double full = 255.0;
    return {colour[0] / full, colour[1] / full, colour[2] / full, 1.0};
}

PanelMargins colour_bar_margins(const Canvas& canvas, const CanvasBox& bar,
                                const ColourScale& scale, BarDirection direction) {
    const double font = canvas.font_size();
    const double thin = 0.5 * canvas.line_width();
    if (direction == BarDirection::upright) {
        const BarLayout layout = lay_out_bar(canvas, bar.height, scale, direction);
        const double half = std::max({thin, label_overhang_em * font, 0.5 * layout.highest});
        return {thin, tick_text_gap_em * font + layout.widest + layout.label_height, half, half};
    }
    const BarLayout layout = lay_out_bar(canvas, bar.width, scale, direction);
    const double half = std::max({thin, label_overhang_em * font, 0.5 * layout.widest});
    return {half, half, thin, tick_text_gap_em * font + layout.highest + layout.label_height};
}

void draw_colour_bar(Canvas& canvas, const CanvasBox& bar, const ColourScale& scale,
                     BarDirection direction, const Ink& ink) {
    const double font = canvas.font_size();
    const double thin = canvas.line_width();
    const bool upright = direction == BarDirection::upright;
    const BarLayout layout =
        lay_out_bar(canvas, upright ? bar.height : bar.width, scale, direction);
    const double right = bar.x + bar.width;
    const double bottom = bar.y + bar.height;
    canvas.draw(gradient(scale, direction), bar);
    canvas.stroke(
        std::array<CanvasPoint, 5>{
            {{bar.x, bar.y}, {right, bar.y}, {right, bottom}, {bar.x, bottom}, {bar.x, bar.y}}},
        thin, ink);
    if (scale.values_below) draw_triangle(canvas, bar, scale, upright, false, ink);
    if (scale.values_above) draw_triangle(canvas, bar, scale, upright, true, ink);
    for (std::size_t i = 0; i < layout.ticks.values.size(); ++i) {
        const double share = (layout.ticks.values[i] - scale.low) / (scale.high - scale.low);
        const double x = upright ? right : bar.x + bar.width * share;
        const double y = upright ? bottom - bar.height * share : bottom;
        const double dx = upright ? font : 0.0;
        const double dy = upright ? 0.0 : font;
        canvas.stroke(
            std::array<CanvasPoint, 2>{{{x, y}, {x + tick_mark_em * dx, y + tick_mark_em * dy}}},
            thin, ink);
        // The range of one of many frames may have labels that reach beyond the picture.
        const double half =
            0.5 * canvas.text_size(layout.ticks.labels[i], bar_tick_text_size_em)[0];
        const double middle = upright ? x : std::max(half, std::min(x, canvas.width() - half));
        canvas.write(
            layout.ticks.labels[i], {middle + tick_text_gap_em * dx, y + tick_text_gap_em * dy},
            upright ? CanvasPoint{0.0, 0.5} : CanvasPoint{0.5, 0.0}, ink, bar_tick_text_size_em);
    }
    if (scale.label.empty()) return;
    const double away =
        (tick_text_gap_em + label_gap_em) * font + (upright ? layout.widest : layout.highest);
    if (upright) {
        canvas.write(layout.label, {right + away, bar.y + 0.5 * bar.height}, {0.0, 0.5}, ink,
                     layout.label_size, true);
    } else {
        canvas.write(layout.label, {bar.x + 0.5 * bar.width, bottom + away}, {0.5, 0.0}, ink,
                     layout.label_size);
    }
}

PanelMargins with_colour_bar(const Canvas& canvas, const PanelMargins& margins, BarPosition place,
                             const ColourScale& scale, double width, double height) {
    if (place == BarPosition::none) return margins;
    const CanvasBox bar = placed_bar(canvas, {0.0, 0.0, width, height}, margins.below, place);
    const bool below = place == BarPosition::below;
    PanelMargins room =
        colour_bar_margins(canvas, bar, scale, below ? BarDirection::level : BarDirection::upright);
    const double triangle = triangle_length_ratio * (below ? bar.height : bar.width);
    if (scale.values_below) (below ? room.left : room.below) += triangle;
    if (scale.values_above) (below ? room.right : room.above) += triangle;
    return {std::max(margins.left, room.left - bar.x),
            std::max(margins.right, bar.right() + room.right - width),
            std::max(margins.above, room.above - bar.y),
            std::max(margins.below, bar.bottom() + room.below - height)};
}

void draw_placed_bar(Canvas& canvas, const CanvasBox& frame, const PanelMargins& margins,
                     BarPosition place, const ColourScale& scale) {
    if (place == BarPosition::none) return;
    draw_colour_bar(canvas, placed_bar(canvas, frame, margins.below, place), scale,
                    place == BarPosition::below ? BarDirection::level : BarDirection::upright);
}

}  // namespace fumon
