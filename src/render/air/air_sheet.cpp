#include "render/air/air_sheet.h"

#include <algorithm>
#include <cmath>

#include "base/elementary_angle.h"
#include "base/grid.h"
#include "base/truncation.h"
#include "base/worker_pool.h"
#include "render/air/streamlines.h"

namespace fumon {

namespace {

constexpr double slowest_share = 0.10;  // of the palette: its very ends are black and white
constexpr double fastest_share = 0.72;
constexpr double opacity = 0.80;       // at the bed
constexpr double top_opacity = 0.16;   // at the section's top
constexpr double fading_from = 0.42;   // of the sheet's height
constexpr double separations = 52.0;   // of streamlines along the sheet
constexpr double line_width = 0.0013;  // of the sheet's width
constexpr double line_strength = 0.85;
constexpr double taper = 0.02;  // of the sheet's width: over which a line's ends fade

/// The thickness of the air as it is painted at a share of the sheet's height.
double opacity_at(double share) {
    const double t = std::clamp((share - fading_from) / (1.0 - fading_from), 0.0, 1.0);
    return std::lerp(opacity, top_opacity, t * t * (3.0 - 2.0 * t));
}

double distance_to_segment(glm::dvec2 at, glm::dvec2 from, glm::dvec2 to) {
    const glm::dvec2 along = to - from;
    const double share =
        std::clamp(glm::dot(at - from, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
    return glm::distance(at, from + share * along);
}

/// Covers the pixels within half a width of a segment, softly over one pixel.
void stroke(Field<float>& cover, glm::dvec2 from, glm::dvec2 to, double width, double strength) {
    const double reach = 0.5 * width + 0.5;
    const auto first = [&](double a, double b) {
        constexpr int most = 1 << 30;
        return truncated_within(std::floor(std::min(a, b) - reach), 0, most);
    };
    const auto last = [&](double a, double b, int size) {
        return truncated_within(std::ceil(std::max(a, b) + reach), -1, size - 1);
    };
    for (int y = first(from.y, to.y); y <= last(from.y, to.y, cover.ny()); ++y) {
        for (int x = first(from.x, to.x); x <= last(from.x, to.x, cover.nx()); ++x) {
            const double away = distance_to_segment({x + 0.5, y + 0.5}, from, to);
            const double covered = strength * std::clamp(reach - away, 0.0, 1.0);
            cover(x, y) = std::max(cover(x, y), static_cast<float>(covered));
        }
    }
}

/// How much of each pixel a streamline covers, 0 … 1.
Field<float> streamline_cover(const SectionAir& air, const AirSheet& sheet, double half_cell) {
    Field<float> cover(sheet.width, sheet.height);
    const glm::dvec2 scale(sheet.width / air.length(), sheet.height / (sheet.high - sheet.low));
    const double separation = sheet.width / separations;
    for (const Streamline& line : streamlines(air, {scale.x, scale.y, separation})) {
        const auto pixel = [&](std::size_t i) {
            return (line[i] + glm::dvec2(half_cell, -sheet.low)) * scale;
        };
        const double step = glm::distance(pixel(0), pixel(1));
        // Ends within the air fade, those at the section's ends do not.
        const auto ends_within = [&](glm::dvec2 end) {
            return std::min(end.x, air.length() - end.x) * scale.x > 0.5 * separation;
        };
        const double faded = taper * sheet.width;
        const auto fade = [&](glm::dvec2 end, std::size_t steps) {
            return ends_within(end) ? static_cast<double>(steps) * step / faded : 1.0;
        };
        const auto strength = [&](std::size_t i) {
            return std::min({fade(line.front(), i), fade(line.back(), line.size() - 1 - i), 1.0});
        };
        const double width = line_width * sheet.width;
        for (std::size_t i = 1; i < line.size(); ++i)
            stroke(cover, pixel(i - 1), pixel(i), width, strength(i));
        // The sheet begins half a cell before the section, and a line's last step may miss its end.
        const auto prolong = [&](glm::dvec2 end, glm::dvec2 before) {
            const double steps = 1.0 + half_cell * scale.x / step;
            stroke(cover, end, end + steps * (end - before), width, 1.0);
        };
        const std::size_t last = line.size() - 1;
        if (!ends_within(line.front())) prolong(pixel(0), pixel(1));
        if (!ends_within(line.back())) prolong(pixel(last), pixel(last - 1));
    }
    return cover;
}

}  // namespace

double air_palette_share(double speed, double fastest) {
    return std::lerp(slowest_share, fastest_share,
                     fastest > 0.0 ? std::clamp(speed / fastest, 0.0, 1.0) : 0.0);
}

double fastest_air(const SectionAir& air) {
    const SnapshotField* u = air.find("velocity_x");
    const SnapshotField* w = air.find("velocity_z");
    double fastest = 0.0;
    if (u == nullptr || w == nullptr) return fastest;
    for (std::size_t i = 0; i < u->values.values().size(); ++i)
        fastest =
            std::max(fastest, elementary::hypot(u->values.values()[i], w->values.values()[i]));
    return fastest;
}

AirSheet paint_air_sheet(const SectionAir& air, const Palette& palette, int width, double low,
                         double rise, WorkerPool& pool) {
    AirSheet sheet;
    sheet.width = width;
    sheet.low = low;
    sheet.high = std::max(air.height(), low);
    sheet.height = std::clamp(
        static_cast<int>(std::ceil(width * rise * (sheet.high - low) / air.length())), 2, width);
    const auto columns = static_cast<std::size_t>(width);
    sheet.rgba.assign(4 * columns * static_cast<std::size_t>(sheet.height), 0);
    const SnapshotField* u = air.find("velocity_x");
    const SnapshotField* w = air.find("velocity_z");
    if (u == nullptr || w == nullptr || !(sheet.high > low)) return sheet;
    const double half_cell = 0.5 * air.length() / u->values.nx();
    const double fastest = fastest_air(air);
    const Field<float> lines = streamline_cover(air, sheet, half_cell);
    const auto paint_row = [&](int row) {
        const double share = (row + 0.5) / sheet.height;
        const double z = std::lerp(low, sheet.high, share);
        for (int column = 0; column < width; ++column) {
            const double x = (column + 0.5) / width * air.length() - half_cell;
            const double speed = elementary::hypot(air.value(*u, x, z), air.value(*w, x, z));
            const auto& colour =
                palette[static_cast<std::size_t>(255.0 * air_palette_share(speed, fastest))];
            const double line = line_strength * static_cast<double>(lines(column, row));
            const double thickness = opacity_at(share);
            std::uint8_t* texel = &sheet.rgba[4 * (static_cast<std::size_t>(row) * columns +
                                                   static_cast<std::size_t>(column))];
            for (std::size_t c = 0; c < 3; ++c)
                texel[c] =
                    static_cast<std::uint8_t>(std::lround(std::lerp(colour[c], 255.0, line)));
            texel[3] = static_cast<std::uint8_t>(
                std::lround(255.0 * std::lerp(thickness, std::sqrt(thickness), line)));
        }
    };
    pool.for_ranges(sheet.height, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) paint_row(row);
    });
    return sheet;
}

}  // namespace fumon
