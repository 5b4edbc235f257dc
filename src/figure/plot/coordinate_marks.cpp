#include "figure/plot/coordinate_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace fumon {

namespace {

constexpr double tick_length_em = 0.45;  // font sizes, as are the others
constexpr double text_gap_em = 0.25;     // between a tick and its text
constexpr double text_spacing_em = 0.5;  // between texts
constexpr int most_mark_count = 8;
constexpr int least_mark_count = 2;

/// A text's box, centred beyond the end of its tick.
CanvasBox box_beyond(const CanvasPoint& end, const CanvasPoint& way, double width, double height,
                     double room) {
    const double x = end.x + way.x * (room + 0.5 * width);
    const double y = end.y + way.y * (room + 0.5 * height);
    return {x - 0.5 * width, y - 0.5 * height, width, height};
}

/// Moves a text's box off the axis, to the side to which its tick points, until it is clear of it.
CanvasBox clear_of_axis(CanvasBox box, const CoordinateAxis& axis, double place,
                        const CanvasPoint& from, const CanvasPoint& way, double room) {
    const double step = 1e-3 * axis.length;
    const auto one = axis.seen(place - step);
    const auto other = axis.seen(place + step);
    if (!one || !other) return box;
    const double x = other->x - one->x;
    const double y = other->y - one->y;
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0.0)) return box;
    const double side = way.x * y - way.y * x < 0.0 ? -1.0 : 1.0;
    const CanvasPoint off{side * y / length, -side * x / length};
    // The least distance of a corner from the line.
    const CanvasPoint middle = box.middle();
    const double nearest = (middle.x - from.x) * off.x + (middle.y - from.y) * off.y -
                           0.5 * (box.width * std::abs(off.x) + box.height * std::abs(off.y));
    const double shift = std::max(0.0, room - nearest);
    box.x += shift * off.x;
    box.y += shift * off.y;
    return box;
}

std::vector<CoordinateMark> marks_of(const Canvas& canvas, const CoordinateAxis& axis, int most,
                                     double side) {
    const double font = canvas.font_size();
    const Ticks ticks = axis.scale.ticks(axis.length, most);
    std::vector<CoordinateMark> marks;
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double place = axis.scale.place_of(ticks.values[i]);
        const std::optional<CanvasPoint> from = axis.seen(place);
        if (!from) continue;
        const CanvasPoint outward = axis.outward(place);
        const CanvasPoint way{side * outward.x, side * outward.y};
        const CanvasPoint to{from->x + tick_length_em * font * way.x,
                             from->y + tick_length_em * font * way.y};
        auto [width, height] = canvas.text_size(ticks.labels[i]);
        if (axis.upright) std::swap(width, height);
        const CanvasBox box = clear_of_axis(box_beyond(to, way, width, height, text_gap_em * font),
                                            axis, place, *from, way, 2.0 * text_gap_em * font);
        marks.push_back({*from, to, ticks.labels[i], box, axis.upright});
    }
    return marks;
}

bool overlap_one_another(std::span<const CoordinateMark> marks, double room) {
    for (std::size_t i = 0; i < marks.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (overlap(grown(marks[i].box, room), marks[j].box)) return true;
        }
    }
    return false;
}

/// As many marks as do not overlap one another.
std::vector<CoordinateMark> densest_marks(const Canvas& canvas, const CoordinateAxis& axis,
                                          double side) {
    std::vector<CoordinateMark> marks;
    for (int most = most_mark_count; most >= least_mark_count; --most) {
        marks = marks_of(canvas, axis, most, side);
        if (!overlap_one_another(marks, text_spacing_em * canvas.font_size())) break;
    }
    return marks;
}

/// Those of some marks that have room in a picture beside boxes that are taken.
std::vector<CoordinateMark> with_room(const Canvas& canvas, std::span<const CoordinateMark> marks,
                                      std::vector<CanvasBox> taken, const CanvasBox& picture) {
    const double font = canvas.font_size();
    std::vector<CoordinateMark> kept;
    for (const CoordinateMark& mark : marks) {
        const CanvasBox around = grown(mark.box, text_spacing_em * font);
        const bool meets =
            std::ranges::any_of(taken, [&](const CanvasBox& box) { return overlap(around, box); });
        if (meets || !within(grown(mark.box, 0.5 * text_gap_em * font), picture)) continue;
        kept.push_back(mark);
        taken.push_back(mark.box);
    }
    return kept;
}

}  // namespace

std::vector<CoordinateMark> coordinate_marks(const Canvas& canvas,
                                             std::span<const CoordinateAxis> axes,
                                             std::span<const CanvasBox> taken,
                                             const CanvasBox& room) {
    std::vector<CoordinateMark> all;
    std::vector<CanvasBox> boxes(taken.begin(), taken.end());
    for (const CoordinateAxis& axis : axes) {
        const std::vector<CoordinateMark> outside = densest_marks(canvas, axis, 1.0);
        std::vector<CoordinateMark> kept = with_room(canvas, outside, boxes, room);
        if (2 * kept.size() < outside.size()) {
            auto inside = with_room(canvas, densest_marks(canvas, axis, -1.0), boxes, room);
            if (inside.size() > kept.size()) kept = std::move(inside);
        }
        for (CoordinateMark& mark : kept) {
            boxes.push_back(mark.box);
            all.push_back(std::move(mark));
        }
    }
    return all;
}

}  // namespace fumon
