#include "figure/panels/map_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/elementary_angle.h"
#include "base/quantity_text.h"
#include "base/snapshot_lookup.h"
#include "base/truncation.h"
#include "figure/canvas/furniture.h"
#include "figure/layers/draw_layers.h"
#include "figure/panels/arrow_field.h"
#include "figure/panels/axis_units.h"
#include "figure/panels/scale_bar.h"
#include "figure/plot/coordinate_scale.h"
#include "figure/words/words.h"
#include "numerics/percentile.h"
#include "render/view/water.h"

namespace fumon {

namespace {

constexpr double furniture_inset_em = 0.7;  // of furniture from the frame's edges, font sizes
constexpr double longest_bar_share_of_frame = 0.35;  // of the frame's width
constexpr double usual_speed_share = 0.95;           // share of cells
constexpr double arrow_spacing_em = 1.7;             // font sizes

/// The variance of the values that a box on the map covers.
double spread_under(const Grid& values, const CanvasBox& frame, const CanvasBox& box) {
    const auto cell = [](double share, int count) {
        return truncated_within(std::floor(share * count), 0, count - 1);
    };
    const int west = cell((box.x - frame.x) / frame.width, values.nx());
    const int east = cell((box.right() - frame.x) / frame.width, values.nx());
    const int north = cell((frame.bottom() - box.y) / frame.height, values.ny());
    const int south = cell((frame.bottom() - box.bottom()) / frame.height, values.ny());
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    for (int y = south; y <= north; ++y) {
        for (int x = west; x <= east; ++x) {
            const double value = values(x, y);
            if (!std::isfinite(value)) continue;
            sum += value;
            squares += value * value;
            count += 1.0;
        }
    }
    return count > 0.0 ? std::max(squares / count - (sum / count) * (sum / count), 0.0) : 0.0;
}

}  // namespace

namespace {

/// A map that fills the unit square, north up.
class FlatGround : public GroundSight {
  public:
    [[nodiscard]] std::optional<CanvasPoint> at(const BedPlace& place) const override {
        return CanvasPoint{place[0], 1.0 - place[1]};
    }
    [[nodiscard]] bool visible(const BedPlace&) const override { return true; }
};

}  // namespace

Corner arrow_corner(const Grid& values, const CanvasBox& frame, const FurnitureSize& size,
                    double margin, const std::vector<Corner>& taken) {
    constexpr double much_less = 0.25;  // of the variance: half of the spread
    const auto spread = [&](Corner corner) {
        return spread_under(values, frame, corner_box(frame, corner, size, margin));
    };
    Corner best = Corner::upper_right;
    double least = much_less * spread(best);
    for (const Corner corner : {Corner::upper_left, Corner::lower_right, Corner::lower_left}) {
        if (std::find(taken.begin(), taken.end(), corner) != taken.end()) continue;
        const double here = spread(corner);
        if (here >= least) continue;
        least = here;
        best = corner;
    }
    return best;
}

Corner emptiest_corner(const MapPicture& picture, const CanvasBox& frame, const FurnitureSize& size,
                       double margin, const std::vector<Corner>& taken) {
    const Grid& values = picture.values;
    const auto cells_under = [&](Corner corner) {
        const CanvasBox box = corner_box(frame, corner, size, margin);
        int count = 0;
        for (int y = 0; y < values.ny(); ++y) {
            for (int x = 0; x < values.nx(); ++x) {
                const CanvasPoint middle{frame.x + (x + 0.5) / values.nx() * frame.width,
                                         frame.bottom() - (y + 0.5) / values.ny() * frame.height};
                const bool blank = !picture.blank.empty() && picture.blank(x, y) != 0;
                count += !blank && std::isfinite(values(x, y)) && within(middle, box) ? 1 : 0;
            }
        }
        return count;
    };
    Corner best = Corner::upper_right;
    int fewest = -1;
    for (const Corner corner :
         {Corner::upper_right, Corner::lower_right, Corner::upper_left, Corner::lower_left}) {
        if (std::ranges::find(taken, corner) != taken.end()) continue;
        const int cells = cells_under(corner);
        if (fewest >= 0 && cells >= fewest) continue;
        fewest = cells;
        best = corner;
    }
    return best;
}

std::optional<MapFlow> water_flow_of(const Snapshot& snapshot) {
    if (!has_water(snapshot)) return std::nullopt;
    MapFlow flow;
    flow.velocity_x = *field_of(snapshot.fields, "velocity_x");
    flow.velocity_y = *field_of(snapshot.fields, "velocity_y");
    const Mask dry = dry_cells(snapshot);
    for (std::size_t i = 0; i < dry.size(); ++i) {
        if (dry.values()[i] != 0) flow.velocity_x.values()[i] = flow.velocity_y.values()[i] = 0.0;
    }
    return flow;
}

MapPanel::MapPanel(MapPicture picture, MapPanelSettings settings)
    : picture_(std::move(picture)), settings_(std::move(settings)) {
    if (!settings_.flow || settings_.flow->fastest > 0.0) return;
    MapFlow& flow = *settings_.flow;
    std::vector<float> speeds;
    for (std::size_t i = 0; i < flow.velocity_x.size(); ++i) {
        const double speed =
            elementary::hypot(flow.velocity_x.values()[i], flow.velocity_y.values()[i]);
        if (speed > 0.0) speeds.push_back(static_cast<float>(speed));
    }
    flow.fastest = percentile(speeds, usual_speed_share);
}

double MapPanel::aspect() const {
    const BedExtent extent = bed_extent(picture_.values, picture_.scale);
    return extent.width / extent.height;
}

Axes MapPanel::axes_in(const CanvasBox& frame) const {
    const BedExtent extent = bed_extent(picture_.values, picture_.scale);
    const LengthUnit unit =
        length_unit(picture_.scale.in_metres, std::max(extent.width, extent.height));
    return {frame,
            {0.0, extent.width / unit.length,
             label_or(settings_.x_label, labelled("x", unit.symbol)), settings_.x_axis},
            {0.0, extent.height / unit.length,
             label_or(settings_.y_label, labelled("y", unit.symbol)), settings_.y_axis}};
}

/// The axes that are drawn: by default those of axes_in().
Axes MapPanel::shown_axes(const CanvasBox& frame) const {
    if (!settings_.coordinates) return axes_in(frame);
    using Axis = CoordinateScale::Axis;
    const BedExtent extent = bed_extent(picture_.values, picture_.scale);
    const auto range = [&](Axis axis, double length, const std::string& label) -> AxisRange {
        const auto shown = CoordinateScale(*settings_.coordinates, axis).range(length);
        return {shown.low, shown.high,
                label_or(label, fmt::format("{} ({})", shown.name, shown.unit))};
    };
    AxisRange y = range(Axis::north, extent.height, settings_.y_label);
    y.tick_labels = settings_.y_axis;
    AxisRange x = range(Axis::east, extent.width, settings_.x_label);
    x.tick_labels = settings_.x_axis;
    return {frame, std::move(x), std::move(y)};
}

PanelMargins MapPanel::margins(const Canvas& canvas, double width, double height) const {
    const double thin = 0.5 * canvas.line_width();
    PanelMargins room{thin, thin, thin, thin};
    if (settings_.axes) room = shown_axes({0.0, 0.0, width, height}).margins(canvas);
    if (settings_.flow)
        room.above = std::max(room.above, reference_arrow_room_em * canvas.font_size());
    return with_colour_bar(canvas, room, settings_.colour_bar, picture_.colours, width, height);
}

void MapPanel::draw_flow(Canvas& canvas, const Axes& axes) const {
    const MapFlow& flow = *settings_.flow;
    const Grid& u = flow.velocity_x;
    ArrowField field;
    field.fastest = flow.fastest;
    field.unit = flow.unit;
    field.apart_x = field.apart_y = arrow_spacing_em;
    field.velocity = [&](double x, double y) -> std::optional<glm::dvec2> {
        const auto cell = [](double value, double high, int count) {
            return truncated_within(value / high * count, 0, count - 1);
        };
        const int column = cell(x, axes.x().high, u.nx());
        const int row = cell(y, axes.y().high, u.ny());
        return glm::dvec2(u(column, row), flow.velocity_y(column, row));
    };
    draw_arrow_field(canvas, axes, field);
    draw_reference_arrow(canvas, axes, field);
}

/// A map's cells may be fewer than those that the lines were found in.
void MapPanel::draw_contours_over(Canvas& canvas, const CanvasBox& frame) const {
    const GroundContours& contours = *settings_.contours;
    std::vector<CanvasContour> lines;
    for (const ContourLine& line : contours.lines) {
        CanvasContour drawn{line.level, {}};
        for (const glm::dvec2& point : line.points) {
            drawn.points.push_back({frame.x + frame.width * (point.x + 0.5) / contours.nx,
                                    frame.bottom() - frame.height * (point.y + 0.5) / contours.ny});
        }
        lines.push_back(std::move(drawn));
    }
    static_cast<void>(draw_contours(canvas, frame, lines, contours.interval));
}

/// Measured lines lie over predicted ones, which are wider, so that both show where they coincide.
void MapPanel::draw_lines(Canvas& canvas, const CanvasBox& frame) const {
    constexpr double reach = 0.4;          // of the frame's shorter side
    constexpr double broken_width = 0.36;  // font sizes
    constexpr double whole_width = 0.15;
    constexpr double rim = 0.12;
    constexpr Ink rim_ink{1.0, 1.0, 1.0, 0.75};
    constexpr Ink broken_ink{0.82, 0.1, 0.08, 1.0};
    const double font = canvas.font_size();
    const double half = reach * std::min(frame.width, frame.height);
    const std::array dashes{0.9 * font, 0.55 * font};
    const auto ends_of = [&](const MapLine& line) {
        const double x = frame.x + 0.5 * frame.width;
        const double y = frame.y + 0.5 * frame.height;
        return std::array<CanvasPoint, 2>{{{x - half * line.along.x, y + half * line.along.y},
                                           {x + half * line.along.x, y - half * line.along.y}}};
    };
    for (const MapLine& line : settings_.lines) {
        const double width = line.broken ? broken_width : whole_width;
        canvas.stroke(ends_of(line), (width + 2.0 * rim) * font, rim_ink);
    }
    for (const MapLine& line : settings_.lines) {
        if (line.broken) canvas.stroke(ends_of(line), broken_width * font, broken_ink, dashes);
    }
    for (const MapLine& line : settings_.lines) {
        if (!line.broken) canvas.stroke(ends_of(line), whole_width * font, black_ink);
    }
}

void MapPanel::draw_layers_over(Canvas& canvas, const CanvasBox& frame) const {
    if (!settings_.placed_layers) return;
    const BedExtent extent = bed_extent(picture_.values, picture_.scale);
    const auto layers = seen_layers({settings_.layers,
                                     *settings_.placed_layers,
                                     {0.0, 0.0, 1.0, 1.0},
                                     extent.width,
                                     extent.height,
                                     true},
                                    FlatGround());
    draw_layers(canvas, frame, settings_.layers, in_box(layers, frame), {}, {page_pixel});
}

std::vector<Corner> MapPanel::taken_corners() const {
    std::vector<Corner> taken;
    if (settings_.scale_bar) taken.push_back(settings_.scale_bar_corner);
    if (!settings_.label.empty()) taken.push_back(settings_.label_corner);
    if (settings_.compass) taken.push_back(settings_.compass_corner);
    return taken;
}

void MapPanel::draw_furniture(Canvas& canvas, const CanvasBox& frame) const {
    const double margin = furniture_inset_em * canvas.font_size();
    const auto plate = [&](Corner corner, const FurnitureSize& size) {
        const CanvasBox box = corner_box(frame, corner, size, margin);
        draw_plate(canvas, box);
        return box;
    };
    std::optional<Corner> legend;
    if (settings_.placed_layers && has_legend(settings_.layers)) {
        legend = emptiest_corner(picture_, frame, layer_legend_size(canvas, settings_.layers),
                                 margin, taken_corners());
    }
    if (settings_.scale_bar) {
        const BedExtent extent = bed_extent(picture_.values, picture_.scale);
        const ScaleBar bar = round_scale_bar(picture_.scale.in_metres, frame.width / extent.width,
                                             longest_bar_share_of_frame * frame.width);
        draw_scale_bar(canvas, bar, plate(settings_.scale_bar_corner, scale_bar_size(canvas, bar)));
    }
    if (!settings_.label.empty()) {
        const auto [width, height] = canvas.text_size(settings_.label, label_text_size_em);
        const CanvasBox box = plate(settings_.label_corner, {width, height});
        canvas.write(settings_.label, {box.x, box.y}, {0.0, 0.0}, {}, label_text_size_em);
    }
    if (settings_.arrow) {
        const FurnitureSize size = ground_arrow_size(canvas, *settings_.arrow, map_axes());
        std::vector<Corner> taken = taken_corners();
        if (legend) taken.push_back(*legend);
        const Corner corner = arrow_corner(picture_.values, frame, size, margin, taken);
        draw_ground_arrow(canvas, *settings_.arrow, map_axes(), plate(corner, size));
    }
    if (legend) {
        const CanvasBox box = plate(*legend, layer_legend_size(canvas, settings_.layers));
        draw_layer_legend(canvas, {box.x, box.y}, settings_.layers, *settings_.placed_layers,
                          page_pixel);
    }
    if (settings_.compass)
        draw_compass(canvas, map_axes(),
                     plate(settings_.compass_corner, compass_size(canvas, map_axes())));
}

void MapPanel::draw(Canvas& canvas, const CanvasBox& frame) const {
    canvas.draw(map_image(picture_, settings_.blank, settings_.most_pixels), frame);
    const Axes axes = axes_in(frame);
    const double thin = 0.5 * canvas.line_width();
    PanelMargins room{thin, thin, thin, thin};
    if (settings_.contours) draw_contours_over(canvas, frame);
    draw_layers_over(canvas, frame);
    if (settings_.flow) draw_flow(canvas, axes);
    draw_lines(canvas, frame);
    draw_furniture(canvas, frame);
    if (settings_.axes) {
        const Axes shown = shown_axes(frame);
        room = shown.margins(canvas);
        shown.draw(canvas);
    } else {
        outline(canvas, frame, canvas.line_width());
    }
    draw_placed_bar(canvas, frame, room, settings_.colour_bar, picture_.colours);
}

}  // namespace fumon
