#include "figure/panels/section_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/elementary_angle.h"
#include "figure/canvas/picture_inks.h"
#include "figure/panels/arrow_field.h"
#include "figure/words/words.h"
#include "render/air/streamlines.h"

namespace fumon {

namespace {

double value_at(const SectionAir& air, SectionQuantity quantity, double x, double z) {
    switch (quantity) {
        case SectionQuantity::velocity_x:
            return air.value(*air.find("velocity_x"), x, z);
        case SectionQuantity::velocity_z:
            return air.value(*air.find("velocity_z"), x, z);
        case SectionQuantity::pressure:
            return air.value_of_air(*air.find("pressure"), x, z);
        case SectionQuantity::speed:
            break;
    }
    return elementary::hypot(air.value(*air.find("velocity_x"), x, z),
                             air.value(*air.find("velocity_z"), x, z));
}

std::string label_of(SectionQuantity quantity) {
    switch (quantity) {
        case SectionQuantity::velocity_x:
            return "u (m/s)";
        case SectionQuantity::velocity_z:
            return "w (m/s)";
        case SectionQuantity::pressure:
            return "p (Pa)";
        case SectionQuantity::speed:
            break;
    }
    return labelled("speed", "m/s");
}

/// The least and the greatest value in the air.
std::array<double, 2> extremes(const SectionAir& air, SectionQuantity quantity) {
    const char* name = quantity == SectionQuantity::pressure ? "pressure" : "velocity_x";
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

}  // namespace

ColourScale map_scale(const SectionAir& air, SectionQuantity quantity, const LookSettings& look,
                      const WordOrReal& low, const WordOrReal& high) {
    const auto [smallest, largest] = extremes(air, quantity);
    double least = smallest;
    double greatest = largest;
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
    scale.values_below = smallest < scale.low;
    scale.values_above = largest > scale.high;
    scale.label = label_of(quantity);
    const char* automatic = both_signs ? "vik" : "viridis";
    scale.palette = read_palette(look.palette == "sand" ? automatic : look.palette);
    if (look.palette_reversed) std::reverse(scale.palette.begin(), scale.palette.end());
    return scale;
}

void draw_section_bed(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air) {
    constexpr int pieces = 600;
    const CanvasBox& frame = axes.frame();
    const CanvasClip clip(canvas, frame);
    std::vector<CanvasPoint> surface;
    for (int i = 0; i <= pieces; ++i) {
        const double x = std::lerp(axes.x().low, axes.x().high, static_cast<double>(i) / pieces);
        surface.push_back(axes.at(x, air.bed(x * unit) / unit));
    }
    std::vector<CanvasPoint> body = surface;
    body.push_back({frame.right(), frame.bottom()});
    body.push_back({frame.x, frame.bottom()});
    canvas.fill(body, ground_ink);
    canvas.stroke(surface, 0.09 * canvas.font_size(), dark_ink);
}

void draw_section_map(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air,
                      SectionQuantity quantity, const ColourScale& scale) {
    constexpr int columns = 1000;
    const CanvasBox& frame = axes.frame();
    Image image(columns,
                std::clamp(static_cast<int>(std::lround(columns * frame.height / frame.width)), 2,
                           2 * columns));
    for (int row = 0; row < image.height; ++row) {
        std::uint8_t* pixel = image.row(row);
        for (int column = 0; column < columns; ++column, pixel += 3) {
            const auto [x, z] = axes.value({frame.x + (column + 0.5) * frame.width / columns,
                                            frame.y + (row + 0.5) * frame.height / image.height});
            const auto& colour =
                scale.palette[scale.place(value_at(air, quantity, x * unit, z * unit))];
            std::copy(colour.begin(), colour.end(), pixel);
        }
    }
    canvas.draw(image, frame);
    draw_section_bed(canvas, axes, unit, air);
}

void draw_section_streamlines(Canvas& canvas, const Axes& axes, double unit,
                              const SectionAir& air) {
    const double font = canvas.font_size();
    StreamlineSettings settings;
    settings.pixels_per_metre_x = axes.frame().width / (axes.x().high - axes.x().low) / unit;
    settings.pixels_per_metre_z = axes.frame().height / (axes.y().high - axes.y().low) / unit;
    settings.separation = std::max(3.0, 0.9 * font);
    for (const Streamline& line : streamlines(air, settings)) {
        std::vector<CanvasPoint> points;
        points.reserve(line.size());
        for (const auto& place : line) points.push_back(axes.at(place.x / unit, place.y / unit));
        const double thin = 0.06 * font;
        canvas.stroke(points, 2.4 * thin, halo);
        canvas.stroke(points, thin, dark_ink);
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
        canvas.fill(tip, dark_ink);
    }
}

ArrowField section_arrows(const SectionAir& air, double unit) {
    ArrowField field;
    field.fastest = extremes(air, SectionQuantity::speed)[1];
    const SnapshotField& u = *air.find("velocity_x");
    const SnapshotField& w = *air.find("velocity_z");
    field.velocity = [&air, &u, &w, unit](double x, double z) -> std::optional<glm::dvec2> {
        if (z * unit <= air.bed(x * unit)) return std::nullopt;
        return glm::dvec2(air.value(u, x * unit, z * unit), air.value(w, x * unit, z * unit));
    };
    return field;
}

}  // namespace fumon
