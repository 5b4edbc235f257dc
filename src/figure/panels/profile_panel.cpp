#include "figure/panels/profile_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/elementary_power.h"
#include "base/error.h"
#include "base/quantity_text.h"
#include "base/snapshot_lookup.h"
#include "figure/canvas/picture_inks.h"
#include "figure/panels/axis_units.h"
#include "figure/panels/ground_arrow.h"
#include "figure/panels/row_means.h"
#include "figure/panels/scale_bar.h"
#include "figure/panels/step_text.h"
#include "figure/words/words.h"
#include "render/view/water.h"

namespace fumon {

namespace {

constexpr double room_below_line_share = 0.12;  // of the relief, filled with sand
constexpr double room_above_share = 0.12;       // of the relief
constexpr double line_spacing_ratio = 1.25;     // of the relief, from one profile to the next
constexpr double room_of_name_em = 1.6;         // font sizes
constexpr double name_gap_em = 0.5;             // font sizes
constexpr double bar_gap_em = 0.7;              // font sizes

double rounded_exaggeration(double largest) {
    const double rounded = largest * (1.0 + 1e-9);
    const double power = elementary::pow(10.0, std::floor(elementary::log10(rounded)));
    for (const double step : {8.0, 6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.5}) {
        if (step * power <= rounded) return step * power;
    }
    return power;
}

}  // namespace

ProfileLine profile_line(const Snapshot& snapshot, std::optional<int> row) {
    const int ny = snapshot.bed.ny();
    if (row && (*row < 0 || *row >= ny))
        throw InputError(
            fmt::format("row {} of a profile: the bed has rows 0 to {}", *row, ny - 1));
    const int first = row.value_or(0);
    const int last = row.value_or(ny - 1);
    ProfileLine line;
    line.bed = row_means(snapshot.bed, snapshot.nodata, first, last);
    for (double& height : line.bed) height *= snapshot.scale.height_unit;
    if (has_water(snapshot)) {
        line.surface =
            row_means(*field_of(snapshot.fields, "water_depth"), snapshot.nodata, first, last);
        for (std::size_t i = 0; i < line.bed.size(); ++i) line.surface[i] += line.bed[i];
    }
    line.label = time_text(snapshot);
    return line;
}

ProfilePicture profile_picture(std::span<const Snapshot> snapshots, std::optional<int> row) {
    ProfilePicture picture;
    for (const Snapshot& snapshot : snapshots) {
        picture.lines.push_back(profile_line(snapshot, row));
        picture.length = bed_extent(snapshot.bed, snapshot.scale).width;
        picture.in_metres = snapshot.scale.in_metres;
    }
    return picture;
}

ProfilePanel::ProfilePanel(ProfilePicture picture) : picture_(std::move(picture)) {
    if (picture_.lines.empty()) throw InputError("a profile panel needs at least one profile");
    double low = INFINITY;
    double high = -INFINITY;
    for (const ProfileLine& line : picture_.lines) {
        for (const auto* heights : {&line.bed, &line.surface}) {
            for (const double height : *heights) {
                if (!std::isfinite(height)) continue;
                low = std::min(low, height);
                high = std::max(high, height);
            }
        }
    }
    if (!(high >= low)) low = high = 0.0;
    low_ = low;
    relief_ = high > low ? high - low : std::max(1e-3 * picture_.length, 1e-9);
}

double ProfilePanel::exaggeration(double width, double height) const {
    if (picture_.exaggeration > 0.0) return picture_.exaggeration;
    const auto lines = static_cast<double>(picture_.lines.size());
    const double all = relief_ * (1.0 + room_below_line_share + room_above_share +
                                  line_spacing_ratio * (lines - 1.0));
    return rounded_exaggeration((height / all) / (width / picture_.length));
}

Axes ProfilePanel::axes_in(const CanvasBox& frame) const {
    const LengthUnit unit = length_unit(picture_.in_metres, picture_.length);
    const double largest = std::max(std::abs(low_), std::abs(low_ + relief_));
    const LengthUnit heights = height_unit(picture_.in_metres, largest);
    const double shown =
        frame.height / frame.width * picture_.length / exaggeration(frame.width, frame.height);
    const double low = low_ - room_below_line_share * relief_;
    return {frame,
            {0.0, picture_.length / unit.length,
             label_or(picture_.x_label,
                      fmt::format("{} ({})", picture_.along, unit_word(unit.symbol)))},
            {low / heights.length, (low + shown) / heights.length,
             label_or(picture_.y_label, labelled("z", heights.symbol)), !stacked(), !stacked()}};
}

PanelMargins ProfilePanel::margins(const Canvas& canvas, double width, double height) const {
    const double font = canvas.font_size();
    PanelMargins room = axes_in({0.0, 0.0, width, height}).margins(canvas);
    room.above = std::max(room.above, room_of_name_em * font);
    if (!stacked()) return room;
    room.left = std::max(room.left,
                         (bar_gap_em + 0.5) * font + canvas.text_size("0", tick_text_size_em)[1]);
    for (const ProfileLine& line : picture_.lines) {
        room.right = std::max(
            room.right, name_gap_em * font + canvas.text_size(line.label, tick_text_size_em)[0]);
    }
    return room;
}

void ProfilePanel::draw_line(Canvas& canvas, const Axes& axes, const ProfileLine& line,
                             double offset) const {
    const double unit =
        height_unit(picture_.in_metres, std::max(std::abs(low_), std::abs(low_ + relief_))).length;
    const auto count = line.bed.size();
    const double base = low_ - room_below_line_share * relief_ + offset;
    const auto at = [&](std::size_t i, double height) {
        // A cell's height stands at its middle; the outer ones reach the frame.
        const double share = i == 0 ? 0.0
                             : i + 1 == count
                                 ? 1.0
                                 : (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        return axes.at(share * axes.x().high, height / unit);
    };
    const auto body = [&](const std::vector<double>& top, std::size_t begin, std::size_t end,
                          const Ink& ink) {
        std::vector<CanvasPoint> corners;
        for (std::size_t i = begin; i < end; ++i) corners.push_back(at(i, top[i] + offset));
        corners.push_back(at(end - 1, base));
        corners.push_back(at(begin, base));
        canvas.fill(corners, ink);
    };
    const CanvasClip clip(canvas, axes.frame());
    for (std::size_t begin = 0; begin < count;) {
        if (!std::isfinite(line.bed[begin])) {
            ++begin;
            continue;
        }
        std::size_t end = begin;
        while (end < count && std::isfinite(line.bed[end])) ++end;
        if (!line.surface.empty()) body(line.surface, begin, end, water_ink);
        body(line.bed, begin, end, ground_ink);
        std::vector<CanvasPoint> top;
        for (std::size_t i = begin; i < end; ++i) top.push_back(at(i, line.bed[i] + offset));
        canvas.stroke(top, 1.5 * canvas.line_width(), dark_ink);
        begin = end;
    }
}

void ProfilePanel::draw_height_bar(Canvas& canvas, const Axes& axes) const {
    const double font = canvas.font_size();
    const CanvasBox& frame = axes.frame();
    const double unit =
        height_unit(picture_.in_metres, std::max(std::abs(low_), std::abs(low_ + relief_))).length;
    const double units_per_height = frame.height / ((axes.y().high - axes.y().low) * unit);
    const double height = round_length(std::min(relief_, frame.height / units_per_height));
    const double shown = height * units_per_height;
    const double x = frame.x - bar_gap_em * font;
    const CanvasPoint low{x, frame.bottom()};
    const CanvasPoint high{x, frame.bottom() - shown};
    canvas.stroke(std::array<CanvasPoint, 2>{low, high}, 2.0 * canvas.line_width(), dark_ink);
    const LengthUnit heights = height_unit(picture_.in_metres, height);
    canvas.write(fmt::format("{:g} {}", height / heights.length, unit_word(heights.symbol)),
                 {x - 0.3 * font, frame.bottom()}, {1.0, 1.0}, {}, tick_text_size_em, true);
}

void ProfilePanel::draw(Canvas& canvas, const CanvasBox& frame) const {
    const double font = canvas.font_size();
    const Axes axes = axes_in(frame);
    const double unit =
        height_unit(picture_.in_metres, std::max(std::abs(low_), std::abs(low_ + relief_))).length;
    for (std::size_t n = picture_.lines.size(); n-- > 0;) {
        const ProfileLine& line = picture_.lines[n];
        const double offset = line_spacing_ratio * relief_ * static_cast<double>(n);
        draw_line(canvas, axes, line, offset);
        if (!stacked()) continue;
        const double middle = axes.at(0.0, (low_ + 0.5 * relief_ + offset) / unit).y;
        canvas.write(line.label, {frame.right() + name_gap_em * font, middle}, {0.0, 0.5}, {},
                     tick_text_size_em);
    }
    axes.draw(canvas);
    if (stacked()) draw_height_bar(canvas, axes);
    const double above = frame.y - 0.5 * room_of_name_em * font;
    canvas.write(
        phrase("heights × {}", fmt::format("{:g}", exaggeration(frame.width, frame.height))),
        {frame.right(), above}, {1.0, 0.5}, {}, tick_text_size_em);
    if (!picture_.wind || picture_.wind->towards.y != 0.0) return;
    const GroundDirection wind{picture_.wind->towards, ""};
    const FurnitureSize size = ground_arrow_size(canvas, wind, map_axes());
    draw_ground_arrow(canvas, wind, map_axes(),
                      {frame.x, above - 0.5 * size.height, size.width, size.height});
    canvas.write(picture_.wind->label, {frame.x + size.width + 0.4 * font, above}, {0.0, 0.5}, {},
                 tick_text_size_em);
}

}  // namespace fumon
