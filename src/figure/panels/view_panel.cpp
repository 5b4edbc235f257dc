#include "figure/panels/view_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "figure/layers/draw_layers.h"
#include "figure/panels/block_coordinates.h"
#include "figure/words/words.h"

namespace fumon {

namespace {

constexpr double corner_text_size_em = 0.95;  // of the font size
constexpr double furniture_gap_em = 0.4;      // pieces of furniture, font sizes
constexpr double bar_offset_share = 0.04;     // of the block's longer side
constexpr double farthest_bar_share = 0.8;    // likewise, where coordinates stand along the edge
constexpr double longest_bar_share_of_edge = 0.4;  // of the edge

/// An edge of the block on the ground, in metres or sites, and which way is out.
struct GroundEdge {
    glm::dvec2 from;
    glm::dvec2 along;  ///< a unit vector
    glm::dvec2 outward;
    double length = 0.0;
};

/// The south-west and north-east corners of the ground that is there: of all cells with data.
std::pair<glm::dvec2, glm::dvec2> drawn_ground(const Block& block) {
    const glm::dvec2 whole(block.width_x, block.width_y);
    if (block.outline.empty()) return {{0.0, 0.0}, whole * block.side};
    glm::dvec2 low = block.outline.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& corner : block.outline) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    return {(low + 0.5 * whole) * block.side, (high + 0.5 * whole) * block.side};
}

/// The edge along x or y that faces the camera most.
GroundEdge facing_edge(const ViewPicture& picture) {
    const auto [low, high] = drawn_ground(picture.block);
    const double width = high.x - low.x;
    const double height = high.y - low.y;
    const std::array<GroundEdge, 4> edges{{{low, {1.0, 0.0}, {0.0, -1.0}, width},
                                           {{low.x, high.y}, {1.0, 0.0}, {0.0, 1.0}, width},
                                           {low, {0.0, 1.0}, {-1.0, 0.0}, height},
                                           {{high.x, low.y}, {0.0, 1.0}, {1.0, 0.0}, height}}};
    const glm::dvec2 to_camera(-picture.camera.forward.x, -picture.camera.forward.y);
    return *std::max_element(
        edges.begin(), edges.end(), [&](const GroundEdge& a, const GroundEdge& b) {
            // A little in favour of x, the wind's direction.
            const auto facing = [&](const GroundEdge& edge) {
                return glm::dot(edge.outward, to_camera) + 0.1 * std::abs(edge.along.x);
            };
            return facing(a) < facing(b);
        });
}

/// The same of ground with data whose hull is no rectangle along x and y: of its edges the one that
/// faces the camera most over the longest way.
std::optional<GroundEdge> facing_hull_edge(const ViewPicture& picture) {
    const Block& block = picture.block;
    if (block.outline.empty()) return std::nullopt;
    const std::vector<glm::dvec2> hull = hull_of(block.outline);
    const glm::dvec2 whole(block.width_x, block.width_y);
    const glm::dvec2 to_camera(-picture.camera.forward.x, -picture.camera.forward.y);
    std::optional<GroundEdge> best;
    double most = 0.0;
    bool oblique = false;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 from = (hull[i] + 0.5 * whole) * block.side;
        const glm::dvec2 to = (hull[(i + 1) % hull.size()] + 0.5 * whole) * block.side;
        const double length = glm::length(to - from);
        if (!(length > 0.0)) continue;
        const glm::dvec2 along = (to - from) / length;
        constexpr double rounding = 1e-9;
        oblique |= std::min(std::abs(along.x), std::abs(along.y)) > rounding;
        const glm::dvec2 outward(along.y, -along.x);
        const double facing = length * glm::dot(outward, to_camera);
        if (facing <= most) continue;
        most = facing;
        best = GroundEdge{from, along, outward, length};
    }
    return oblique ? best : std::nullopt;
}

}  // namespace

/// Where the furniture stands.
struct ViewPanel::Placement {
    double bar_off = bar_offset_share;
    GroundBar bar;
    CanvasBox bar_box;
    CanvasBox label;
    CanvasBox heights;  ///< the exaggeration's text
    CanvasBox arrow;
    CanvasBox compass;
    CanvasBox legend;
    PanelMargins margins;  ///< without the colour bar
};

ViewPanel::ViewPanel(ViewPicture picture, ViewSettings settings)
    : picture_(std::move(picture)), settings_(std::move(settings)) {}

double ViewPanel::aspect() const {
    return static_cast<double>(picture_.image.width) / picture_.image.height;
}

GroundBar ViewPanel::ground_bar(const CanvasBox& frame) const {
    return bar_beside(frame, bar_offset_share);
}

GroundBar ViewPanel::bar_beside(const CanvasBox& frame, double off) const {
    const GroundEdge edge = facing_hull_edge(picture_).value_or(facing_edge(picture_));
    const glm::dvec2 from = edge.from + off * picture_.block.side * edge.outward;
    return ground_scale_bar(picture_.in(frame), picture_.in_metres, from, edge.along,
                            longest_bar_share_of_edge * edge.length, picture_.block.base);
}

bool ViewPanel::empty(const CanvasBox& frame, const CanvasBox& box) const {
    const Image& image = picture_.image;
    const auto column = [&](double x) {
        return std::clamp(static_cast<int>((x - frame.x) / frame.width * image.width), 0,
                          image.width - 1);
    };
    const auto row = [&](double y) {
        return std::clamp(static_cast<int>((y - frame.y) / frame.height * image.height), 0,
                          image.height - 1);
    };
    constexpr int white = 250;
    for (int y = row(box.y); y <= row(box.bottom()); ++y) {
        for (int x = column(box.x); x <= column(box.right()); ++x) {
            const std::uint8_t* pixel = image.row(y) + std::ptrdiff_t{3} * x;
            if (std::min({pixel[0], pixel[1], pixel[2]}) < white) return false;
        }
    }
    return true;
}

ViewPanel::Placement ViewPanel::place(const Canvas& canvas, const CanvasBox& frame) const {
    const double gap = furniture_gap_em * canvas.font_size();
    Placement placement;
    std::vector<CanvasBox> taken;
    if (settings_.coordinates) {
        for (const CoordinateMark& mark : marks_in(canvas, frame))
            taken.push_back(grown(mark.box, 0.25 * gap));
    }
    if (settings_.scale_bar) {
        const auto meets = [&] {
            return std::ranges::any_of(taken, [&](const CanvasBox& text) {
                return overlap(grown(placement.bar_box, gap), text);
            });
        };
        do {
            placement.bar = bar_beside(frame, placement.bar_off);
            placement.bar_box = ground_bar_box(canvas, placement.bar);
        } while (meets() && (placement.bar_off += bar_offset_share) < farthest_bar_share);
        taken.push_back(placement.bar_box);
    }
    double next = frame.x;  // of the pieces below the picture
    const auto put = [&](const FurnitureSize& size, std::initializer_list<Corner> corners) {
        for (const Corner corner : corners) {
            const CanvasBox box = corner_box(frame, corner, size, 0.0);
            const bool free = std::none_of(taken.begin(), taken.end(), [&](const CanvasBox& other) {
                return overlap(grown(box, gap), other);
            });
            if (!free || !within(box, frame) || !empty(frame, grown(box, gap))) continue;
            taken.push_back(box);
            return box;
        }
        double top = frame.bottom() + gap;
        for (const CanvasBox& other : taken) {
            if (other.x < next + size.width + gap && other.right() > next - gap)
                top = std::max(top, other.bottom() + gap);
        }
        const CanvasBox box{next, top, size.width, size.height};
        next = box.right() + gap;
        taken.push_back(box);
        return box;
    };
    const auto text = [&](const std::string& words, std::initializer_list<Corner> corners) {
        const auto [width, height] = canvas.text_size(words, corner_text_size_em);
        return put({width, height}, corners);
    };
    using enum Corner;
    if (!settings_.label.empty())
        placement.label = text(settings_.label, {upper_left, upper_right, lower_left, lower_right});
    if (settings_.arrow) {
        placement.arrow =
            put(ground_arrow_size(canvas, *settings_.arrow, visible_axes(picture_.in(frame))),
                {upper_right, lower_left, lower_right, upper_left});
    }
    if (settings_.compass) {
        placement.compass = put(compass_size(canvas, visible_axes(picture_.in(frame))),
                                {upper_left, lower_left, lower_right, upper_right});
    }
    if (has_legend(picture_.layer_settings)) {
        placement.legend = put(layer_legend_size(canvas, picture_.layer_settings),
                               {lower_left, upper_left, lower_right, upper_right});
    }
    if (settings_.exaggeration && picture_.exaggeration != 1.0) {
        placement.heights = text(phrase("heights × {}", fmt::format("{:g}", picture_.exaggeration)),
                                 {lower_left, lower_right, upper_left, upper_right});
    }
    for (const CanvasBox& box : taken) {
        PanelMargins& room = placement.margins;
        room.left = std::max(room.left, frame.x - box.x);
        room.right = std::max(room.right, box.right() - frame.right());
        room.above = std::max(room.above, frame.y - box.y);
        room.below = std::max(room.below, box.bottom() - frame.bottom());
    }
    return placement;
}

/// The coordinates along the block, which stand beside it, in the frame or around it.
std::vector<CoordinateMark> ViewPanel::marks_in(const Canvas& canvas,
                                                const CanvasBox& frame) const {
    const BlockCoordinates shown =
        block_coordinates(picture_.in(frame), picture_.scale, picture_.length_x, picture_.length_y);
    constexpr double anywhere = 1.0;  // of the frame's sides
    return coordinate_marks(canvas, shown.axes, {},
                            grown(frame, anywhere * std::max(frame.width, frame.height)));
}

void ViewPanel::draw_coordinates(Canvas& canvas, const CanvasBox& frame) const {
    const BlockCoordinates shown =
        block_coordinates(picture_.in(frame), picture_.scale, picture_.length_x, picture_.length_y);
    for (const std::vector<CanvasPoint>& line : shown.lines)
        canvas.stroke(line, canvas.line_width(), coordinate_ink);
    draw_coordinate_marks(canvas, marks_in(canvas, frame), 0.0);
}

void ViewPanel::draw_contours_over(Canvas& canvas, const CanvasBox& frame) const {
    if (picture_.contours.empty()) return;
    std::vector<CanvasContour> lines = picture_.contours;
    for (CanvasContour& line : lines) {
        for (CanvasPoint& point : line.points)
            point = {frame.x + frame.width * point.x, frame.y + frame.height * point.y};
    }
    static_cast<void>(draw_contours(canvas, frame, lines, picture_.contour_interval));
}

void ViewPanel::draw_layers_over(Canvas& canvas, const CanvasBox& frame) const {
    if (!picture_.placed_layers) return;
    draw_layers(canvas, frame, picture_.layer_settings, in_box(picture_.layers, frame), {},
                {page_pixel});
}

PanelMargins ViewPanel::margins(const Canvas& canvas, double width, double height) const {
    return with_colour_bar(canvas, place(canvas, {0.0, 0.0, width, height}).margins,
                           settings_.colour_bar, settings_.colours, width, height);
}

void ViewPanel::draw(Canvas& canvas, const CanvasBox& frame) const {
    // As margins() found it, whatever the rounding of the frame's place.
    Placement placement = place(canvas, {0.0, 0.0, frame.width, frame.height});
    for (CanvasBox* box : {&placement.label, &placement.arrow, &placement.compass,
                           &placement.heights, &placement.legend}) {
        box->x += frame.x;
        box->y += frame.y;
    }
    placement.bar = bar_beside(frame, placement.bar_off);
    canvas.draw(picture_.image, frame);
    draw_contours_over(canvas, frame);
    draw_layers_over(canvas, frame);
    if (settings_.coordinates) draw_coordinates(canvas, frame);
    const GroundAxes axes = visible_axes(picture_.in(frame));
    const auto text = [&](const std::string& words, const CanvasBox& box) {
        canvas.write(words, {box.x, box.y}, {0.0, 0.0}, {}, corner_text_size_em);
    };
    if (settings_.scale_bar) draw_ground_bar(canvas, placement.bar);
    if (!settings_.label.empty()) text(settings_.label, placement.label);
    if (settings_.arrow) draw_ground_arrow(canvas, *settings_.arrow, axes, placement.arrow);
    if (settings_.compass) draw_compass(canvas, axes, placement.compass);
    if (has_legend(picture_.layer_settings)) {
        draw_layer_legend(canvas, {placement.legend.x, placement.legend.y}, picture_.layer_settings,
                          *picture_.placed_layers, page_pixel);
    }
    if (settings_.exaggeration && picture_.exaggeration != 1.0)
        text(phrase("heights × {}", fmt::format("{:g}", picture_.exaggeration)), placement.heights);
    draw_placed_bar(canvas, frame, placement.margins, settings_.colour_bar, settings_.colours);
}

}  // namespace fumon
