#include "figure/panels/arrow_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/elementary_angle.h"
#include "base/truncation.h"
#include "figure/canvas/picture_inks.h"
#include "figure/panels/scale_bar.h"

namespace fumon {

namespace {

constexpr double arrow_key_text_size_em = 0.85;
constexpr double longest_arrow_share = 0.9;  // of the distance of neighbouring arrows
constexpr double reference_height_em = 0.8;  // the reference's middle over the frame, font sizes

void draw_arrow(Canvas& canvas, const CanvasPoint& tail, double dx, double dy) {
    const double font = canvas.font_size();
    const double length = elementary::hypot(dx, dy);
    if (length < 0.08 * font) return;
    const double head = std::min(0.35 * font, 0.45 * length) / length;
    const CanvasPoint tip{tail.x + dx, tail.y + dy};
    const std::array<CanvasPoint, 2> shaft{tail, tip};
    const std::array<CanvasPoint, 3> barbs{
        {{tip.x - head * (dx - 0.45 * dy), tip.y - head * (dy + 0.45 * dx)},
         tip,
         {tip.x - head * (dx + 0.45 * dy), tip.y - head * (dy - 0.45 * dx)}}};
    const double thin = 0.07 * font;
    for (const auto& [width, ink] : {std::pair{2.4 * thin, halo}, std::pair{thin, dark_ink}}) {
        canvas.stroke(shaft, width, ink);
        canvas.stroke(barbs, width, ink);
    }
}

struct ArrowGrid {
    int columns = 1;
    int rows = 1;
    double units_per_speed = 0.0;
};

ArrowGrid arrow_grid(const Canvas& canvas, const CanvasBox& frame, const ArrowField& field) {
    constexpr int most_arrows = 4096;  // along a side
    const double font = canvas.font_size();
    ArrowGrid grid;
    grid.columns = truncated_within(frame.width / (field.apart_x * font), 4, most_arrows);
    grid.rows = truncated_within(frame.height / (field.apart_y * font), 2, most_arrows);
    grid.units_per_speed = longest_arrow_share * frame.width / grid.columns / field.fastest;
    return grid;
}

}  // namespace

void draw_arrow_field(Canvas& canvas, const Axes& axes, const ArrowField& field) {
    if (!(field.fastest > 0.0)) return;
    const CanvasBox& frame = axes.frame();
    const ArrowGrid grid = arrow_grid(canvas, frame, field);
    const double stretch = (frame.height / (axes.y().high - axes.y().low)) /
                           (frame.width / (axes.x().high - axes.x().low));
    const CanvasClip clip(canvas, frame);
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const CanvasPoint middle{frame.x + (column + 0.5) * frame.width / grid.columns,
                                     frame.y + (row + 0.5) * frame.height / grid.rows};
            const auto [x, y] = axes.value(middle);
            const auto velocity = field.velocity(x, y);
            if (!velocity) continue;
            const double shown = elementary::hypot(velocity->x, stretch * velocity->y);
            if (!(shown > 0.0)) continue;
            const double length = grid.units_per_speed * glm::length(*velocity) / shown;
            const double dx = length * velocity->x;
            const double dy = -length * stretch * velocity->y;
            draw_arrow(canvas, {middle.x - 0.5 * dx, middle.y - 0.5 * dy}, dx, dy);
        }
    }
}

double draw_reference_arrow(Canvas& canvas, const Axes& axes, const ArrowField& field) {
    if (!(field.fastest > 0.0)) return 0.0;
    const double font = canvas.font_size();
    const CanvasBox& frame = axes.frame();
    const double speed = round_length(field.fastest);
    const std::string text = fmt::format("{:g} {}", speed, field.unit);
    const double y = frame.y - reference_height_em * font;
    const double width =
        std::min(canvas.text_size(text, arrow_key_text_size_em)[0], 0.3 * frame.width);
    write_within(canvas, text, width, {frame.right(), y}, {1.0, 0.5}, arrow_key_text_size_em);
    const double length = arrow_grid(canvas, frame, field).units_per_speed * speed;
    draw_arrow(canvas, {frame.right() - width - 0.4 * font - length, y}, length, 0.0);
    return width + 0.8 * font + length;
}

}  // namespace fumon
