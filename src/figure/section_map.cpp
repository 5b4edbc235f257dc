#include "figure/section_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "figure/streamlines.h"
#include "terrain/elementary_angle.h"
#include "terrain/elementary_power.h"

namespace fumon {

namespace {

constexpr Ink dark{0.05, 0.05, 0.05, 1.0};
constexpr Ink halo{1.0, 1.0, 1.0, 0.55};
constexpr Ink ground{0.80, 0.74, 0.64, 1.0};

double value_at(const SectionAir& air, MapQuantity quantity, double x, double z) {
    switch (quantity) {
        case MapQuantity::velocity_x:
            return air.value(*air.find("velocity_x"), x, z);
        case MapQuantity::velocity_z:
            return air.value(*air.find("velocity_z"), x, z);
        case MapQuantity::pressure:
            return air.value_of_air(*air.find("pressure"), x, z);
        case MapQuantity::speed:
            break;
    }
    return elementary::hypot(air.value(*air.find("velocity_x"), x, z),
                             air.value(*air.find("velocity_z"), x, z));
}

const char* label_of(MapQuantity quantity) {
    switch (quantity) {
        case MapQuantity::velocity_x:
            return "u (m/s)";
        case MapQuantity::velocity_z:
            return "w (m/s)";
        case MapQuantity::pressure:
            return "p (Pa)";
        case MapQuantity::speed:
            break;
    }
    return "speed (m/s)";
}

/// The least and the greatest value in the air.
std::array<double, 2> extremes(const SectionAir& air, MapQuantity quantity) {
    const char* name = quantity == MapQuantity::pressure ? "pressure" : "velocity_x";
    const Grid& nodes = air.find(name)->values;
    std::array<double, 2> found{INFINITY, -INFINITY};
    for (int i = 0; i < nodes.nx(); ++i) {
        const double x = air.length() * i / nodes.nx();
        for (int k = 0; k < nodes.ny(); ++k) {
            const double z = air.height() * k / (nodes.ny() - 1);
            if (z <= air.bed(x)) continue;
            const double value = value_at(air, quantity, x, z);
            found = {std::min(found[0], value), std::max(found[1], value)};
        }
    }
    return found;
}

void draw_arrow(Canvas& canvas, const CanvasPoint& tail, double dx, double dy, double font) {
    const double length = elementary::hypot(dx, dy);
    if (length < 0.08 * font) return;
    const double head = std::min(0.35 * font, 0.45 * length) / length;
    const CanvasPoint tip{tail.x + dx, tail.y + dy};
    const std::array<CanvasPoint, 2> shaft{tail, tip};
    const std::array<CanvasPoint, 3> barbs{
        {{tip.x - head * (dx - 0.45 * dy), tip.y - head * (dy + 0.45 * dx)},
         tip,
         {tip.x - head * (dx + 0.45 * dy), tip.y - head * (dy - 0.45 * dx)}}};
    const double thin = std::max(0.8, 0.07 * font);
    for (const auto& [width, ink] : {std::pair{2.4 * thin, halo}, std::pair{thin, dark}}) {
        canvas.stroke(shaft, width, ink);
        canvas.stroke(barbs, width, ink);
    }
}

/// The greatest of 1, 2 and 5 times a power of ten up to a value above 0.
double round_below(double value) {
    const double power = elementary::pow(10.0, std::floor(elementary::log10(value)));
    for (const double step : {5.0, 2.0}) {
        if (step * power <= value) return step * power;
    }
    return power;
}

double draw_arrows(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air) {
    const double font = canvas.font_size();
    const CanvasBox& frame = axes.frame();
    const double fastest = extremes(air, MapQuantity::speed)[1];
    if (!(fastest > 0.0)) return 0.0;
    const int columns = std::max(4, static_cast<int>(frame.width / (1.8 * font)));
    const int rows = std::max(2, static_cast<int>(frame.height / (0.8 * font)));
    const double apart = frame.width / columns;
    const double pixels = 0.9 * apart / fastest;  // a metre per second
    const double stretch = (frame.height / (axes.y().high - axes.y().low)) /
                           (frame.width / (axes.x().high - axes.x().low));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const CanvasPoint middle{frame.x + (column + 0.5) * apart,
                                     frame.y + (row + 0.5) * frame.height / rows};
            const auto [x, z] = axes.value(middle);
            if (z * unit <= air.bed(x * unit)) continue;
            const double u = air.value(*air.find("velocity_x"), x * unit, z * unit);
            const double w = air.value(*air.find("velocity_z"), x * unit, z * unit);
            const double shown = elementary::hypot(u, stretch * w);
            if (!(shown > 0.0)) continue;
            const double length = pixels * elementary::hypot(u, w) / shown;
            const double dx = length * u;
            const double dy = -length * stretch * w;
            draw_arrow(canvas, {middle.x - 0.5 * dx, middle.y - 0.5 * dy}, dx, dy, font);
        }
    }
    const double reference = round_below(fastest);
    const std::string text = fmt::format("{:g} m/s", reference);
    const double right = frame.x + frame.width;
    const double above = frame.y - 0.8 * font;
    const double wanted = canvas.text_size(text, 0.85)[0];
    const double width = std::min(wanted, 0.3 * frame.width);
    write_within(canvas, text, width, {right, above}, {1.0, 0.5}, 0.85);
    const double length = pixels * reference;
    draw_arrow(canvas, {right - width - 0.4 * font - length, above}, length, 0.0, font);
    return width + 0.8 * font + length;
}

void draw_streamlines(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air) {
    const double font = canvas.font_size();
    StreamlineSettings settings;
    settings.pixels_per_metre_x = axes.frame().width / (axes.x().high - axes.x().low) / unit;
    settings.pixels_per_metre_z = axes.frame().height / (axes.y().high - axes.y().low) / unit;
    settings.separation = std::max(3.0, 0.9 * font);
    for (const Streamline& line : streamlines(air, settings)) {
        std::vector<CanvasPoint> points;
        points.reserve(line.size());
        for (const auto& place : line) points.push_back(axes.at(place.x / unit, place.y / unit));
        const double thin = std::max(0.8, 0.06 * font);
        canvas.stroke(points, 2.4 * thin, halo);
        canvas.stroke(points, thin, dark);
        const std::size_t middle = points.size() / 2;
        if (middle == 0) continue;
        const double dx = points[middle].x - points[middle - 1].x;
        const double dy = points[middle].y - points[middle - 1].y;
        const double length = elementary::hypot(dx, dy);
        if (!(length > 0.0)) continue;
        const double head = 0.55 * font / length;
        const std::array<CanvasPoint, 3> tip{{points[middle],
                                              {points[middle].x - head * (dx - 0.35 * dy),
                                               points[middle].y - head * (dy + 0.35 * dx)},
                                              {points[middle].x - head * (dx + 0.35 * dy),
                                               points[middle].y - head * (dy - 0.35 * dx)}}};
        canvas.fill(tip, dark);
    }
}

}  // namespace

ColourScale map_scale(const SectionAir& air, MapQuantity quantity, const LookSettings& look,
                      const WordOrReal& low, const WordOrReal& high) {
    auto [least, greatest] = extremes(air, quantity);
    const bool both_signs = least < 0.0 && greatest > 0.0;
    if (both_signs) {
        greatest = std::max(-least, greatest);
        least = -greatest;
    } else if (least >= 0.0) {
        least = 0.0;
    } else {
        greatest = 0.0;
    }
    ColourScale scale;
    scale.low = low.is_word() ? least : low.value;
    scale.high = high.is_word() ? greatest : high.value;
    if (!(scale.high > scale.low)) scale.high = scale.low + std::max(1.0, std::abs(scale.low));
    scale.label = label_of(quantity);
    const char* automatic = both_signs ? "vik" : "viridis";
    scale.palette = read_palette(look.palette == "sand" ? automatic : look.palette);
    if (look.palette_reversed) std::reverse(scale.palette.begin(), scale.palette.end());
    return scale;
}

void draw_section_bed(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air) {
    const CanvasBox& frame = axes.frame();
    std::vector<CanvasPoint> surface;
    for (int column = 0; column <= static_cast<int>(frame.width); ++column) {
        const double x = axes.value({frame.x + column, frame.y}).x;
        surface.push_back(axes.at(x, air.bed(x * unit) / unit));
    }
    std::vector<CanvasPoint> body = surface;
    body.push_back({frame.x + frame.width, frame.y + frame.height});
    body.push_back({frame.x, frame.y + frame.height});
    canvas.fill(body, ground);
    canvas.stroke(surface, std::max(1.0, 0.09 * canvas.font_size()), dark);
}

void draw_section_map(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air,
                      MapQuantity quantity, const ColourScale& scale) {
    const CanvasBox& frame = axes.frame();
    for (int row = 0; row < static_cast<int>(frame.height); ++row) {
        for (int column = 0; column < static_cast<int>(frame.width); ++column) {
            const CanvasBox pixel{frame.x + column, frame.y + row, 1.0, 1.0};
            const auto [x, z] = axes.value({pixel.x + 0.5, pixel.y + 0.5});
            canvas.fill(pixel, scale.ink(value_at(air, quantity, x * unit, z * unit)));
        }
    }
    draw_section_bed(canvas, axes, unit, air);
}

double draw_section_flow(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air,
                         SectionArrows arrows) {
    if (arrows == SectionArrows::arrows) return draw_arrows(canvas, axes, unit, air);
    if (arrows == SectionArrows::streamlines) draw_streamlines(canvas, axes, unit, air);
    return 0.0;
}

}  // namespace fumon
