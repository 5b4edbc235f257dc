#include "figure/section_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "measure/snapshot_lookup.h"
#include "terrain/elementary.h"
#include "terrain/elementary_power.h"

namespace fumon {

namespace {

constexpr Ink black{0.0, 0.0, 0.0, 1.0};

/// The range of a panel's values and 0, with a little air beyond them.
AxisRange range_of(const std::vector<LineSeries>& series, std::string label) {
    double low = 0.0;
    double high = 0.0;
    for (const LineSeries& line : series) {
        for (const auto& point : line.points) {
            low = std::min(low, point.y);
            high = std::max(high, point.y);
        }
    }
    if (!(high > low)) high = low + 1.0;
    const double margin = 0.05 * (high - low);
    return {low < 0.0 ? low - margin : 0.0, high + margin, std::move(label)};
}

double width_of(const Snapshot& snapshot, double unit) {
    return snapshot.bed.nx() * snapshot.section->dx / unit;
}

std::string degrees(const SectionCurve& curve, const std::string& prefix) {
    return curve.name.substr(prefix.size()) + "°";
}

}  // namespace

std::vector<const SectionCurve*> section_curves(const SnapshotSection& section,
                                                const std::string& prefix) {
    std::vector<const SectionCurve*> found;
    for (const SectionCurve& curve : section.curves) {
        if (curve.name.starts_with(prefix)) found.push_back(&curve);
    }
    return found;
}

Ink series_ink(std::size_t n, std::size_t count) {
    // Okabe & Ito 2008: told apart by readers of any colour vision.
    constexpr std::array<std::array<int, 3>, 7> inks{{{0, 114, 178},
                                                      {230, 159, 0},
                                                      {0, 158, 115},
                                                      {213, 94, 0},
                                                      {204, 121, 167},
                                                      {86, 180, 233},
                                                      {60, 60, 60}}};
    constexpr double full = 255.0;
    if (count > inks.size()) {
        const double share = static_cast<double>(n) / static_cast<double>(count - 1);
        return {0.1 + 0.8 * share, 0.3, 0.7 - 0.6 * share, 1.0};
    }
    return {inks[n][0] / full, inks[n][1] / full, inks[n][2] / full, 1.0};
}

LinePanel stress_panel(const Snapshot& snapshot, double unit, const std::string& symbol) {
    const auto curves = section_curves(*snapshot.section, "bed_shear_stress");
    LineSeries stress{"", series_ink(0, 1), {}, false};
    for (std::size_t i = 0; i < curves.front()->values.size(); ++i) {
        stress.points.emplace_back(static_cast<double>(i) * snapshot.section->dx / unit,
                                   curves.front()->values[i]);
    }
    LinePanel panel;
    const std::size_t columns = stress.points.size();
    panel.series.push_back(std::move(stress));
    const auto mean = number_of(snapshot, "stress_mean");
    const auto amplitude = number_of(snapshot, "stress_amplitude");
    const auto phase = number_of(snapshot, "stress_phase");
    const auto waves = number_of(snapshot, "bed_waves");
    if (mean && amplitude && phase && waves) {
        panel.series.front().label = "stress";
        LineSeries fit{"cosine fit", black, {}, false};
        for (std::size_t i = 0; i <= columns; ++i) {
            const double place = static_cast<double>(i);
            const double angle =
                2.0 * std::numbers::pi * *waves * place / static_cast<double>(columns);
            fit.points.emplace_back(place * snapshot.section->dx / unit,
                                    *mean + *amplitude * elementary::cos(angle + *phase));
        }
        panel.series.push_back(std::move(fit));
    }
    panel.x = {0.0, width_of(snapshot, unit), fmt::format("x ({})", symbol)};
    panel.y = range_of(panel.series, "τ (Pa)");
    return panel;
}

LinePanel flights_panel(const Snapshot& snapshot, double unit, const std::string& symbol) {
    const std::string prefix = "flight_length_";
    const auto curves = section_curves(*snapshot.section, prefix);
    LinePanel panel;
    for (const SectionCurve* curve : curves) {
        LineSeries line{
            degrees(*curve, prefix), series_ink(panel.series.size(), curves.size()), {}, true};
        for (std::size_t i = 0; i < curve->values.size(); ++i) {
            line.points.emplace_back(static_cast<double>(i) * snapshot.section->dx / unit,
                                     curve->values[i] / unit);
        }
        panel.series.push_back(std::move(line));
    }
    panel.x = {0.0, width_of(snapshot, unit), fmt::format("x ({})", symbol)};
    panel.y = range_of(panel.series, fmt::format("flight length ({})", symbol));
    return panel;
}

LinePanel flight_law_panel(const Snapshot& snapshot, double unit, const std::string& symbol) {
    const std::string prefix = "flight_length_";
    const auto curves = section_curves(*snapshot.section, prefix);
    LinePanel panel;
    double lowest = INFINITY;
    double highest = -INFINITY;
    for (const SectionCurve* curve : curves) {
        LineSeries line{
            degrees(*curve, prefix), series_ink(panel.series.size(), curves.size()), {}, true};
        for (std::size_t i = 0; i < curve->values.size(); ++i) {
            const double height =
                snapshot.bed(static_cast<int>(i), 0) * snapshot.scale.height_unit / unit;
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
            line.points.emplace_back(height, curve->values[i] / unit);
        }
        panel.series.push_back(std::move(line));
    }
    if (!(highest > lowest)) highest = lowest + 1.0;
    const auto base = number_of(snapshot, "hop_base");
    if (base && std::isfinite(*base)) {
        constexpr double millimetre = 1e-3;
        LineSeries law{fmt::format("{:.3g}^h − 1", *base), black, {}, false};
        constexpr int pieces = 100;
        for (int i = 0; i <= pieces; ++i) {
            const double height = std::lerp(lowest, highest, static_cast<double>(i) / pieces);
            law.points.emplace_back(
                height,
                (elementary::pow(*base, height * unit / millimetre) - 1.0) * millimetre / unit);
        }
        panel.series.push_back(std::move(law));
    }
    panel.x = {lowest, highest, fmt::format("height h of the launch ({})", symbol)};
    panel.y = range_of(panel.series, fmt::format("flight length ({})", symbol));
    return panel;
}

void draw_series(Canvas& canvas, const Axes& axes, const std::vector<LineSeries>& series) {
    const double font = canvas.font_size();
    const double thick = std::max(1.0, 0.12 * font);
    for (const LineSeries& line : series) {
        std::vector<CanvasPoint> points;
        points.reserve(line.points.size());
        for (const auto& point : line.points) {
            if (std::isfinite(point.y)) points.push_back(axes.at(point.x, point.y));
        }
        if (!line.dots) {
            canvas.stroke(points, thick, line.ink);
            continue;
        }
        for (const CanvasPoint& point : points)
            canvas.stroke(std::array<CanvasPoint, 2>{point, point}, 1.3 * thick, line.ink);
    }
}

double draw_legend(Canvas& canvas, const Axes& axes, const std::vector<LineSeries>& series,
                   double longest) {
    const double font = canvas.font_size();
    constexpr double size = 0.85;
    double length = 0.0;
    for (const LineSeries& line : series) {
        if (!line.label.empty()) length += canvas.text_size(line.label, size)[0] + 2.6 * font;
    }
    if (length == 0.0) return 0.0;
    const double shrink = std::min(1.0, longest / length);
    double right = axes.frame().x + axes.frame().width;
    const double y = axes.frame().y - 0.8 * font;
    for (auto line = series.rbegin(); line != series.rend(); ++line) {
        if (line->label.empty()) continue;
        const double text = canvas.text_size(line->label, size * shrink)[0];
        canvas.write(line->label, {right, y}, {1.0, 0.5}, black, size * shrink);
        right -= text + 0.4 * font * shrink;
        canvas.stroke(std::array<CanvasPoint, 2>{{{right - 1.2 * font * shrink, y}, {right, y}}},
                      std::max(1.0, 0.15 * font), line->ink);
        right -= 2.2 * font * shrink;
    }
    return length * shrink;
}

}  // namespace fumon
