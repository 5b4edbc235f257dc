#include "figure/panels/section_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "base/elementary.h"
#include "base/elementary_power.h"
#include "base/snapshot_lookup.h"
#include "figure/words/words.h"

namespace fumon {

namespace {

constexpr double frame_top_ratio = 1.08;  // of the highest value, up to the frame's top

const std::string length_prefix = "flight_length_";

/// An axis from 0 along the whole section.
PlotAxis axis_along(const Snapshot& snapshot, const LengthUnit& unit) {
    PlotAxis axis;
    axis.label = labelled("x", unit.symbol);
    axis.low = 0.0;
    axis.high = snapshot.bed.nx() * snapshot.section->dx / unit.length;
    return axis;
}

/// An axis of values that are seldom below 0, with 0 in it.
PlotAxis axis_from_zero(const std::vector<PlotSeries>& series, std::string label) {
    double low = 0.0;
    double high = 0.0;
    for (const PlotSeries& one : series) {
        for (const double value : one.y) {
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (!(high > low)) high = low + 1.0;
    PlotAxis axis;
    axis.label = std::move(label);
    axis.low = frame_top_ratio * low;
    axis.high = frame_top_ratio * high;
    return axis;
}

/// A series of dots, named by the angle at the end of its curve's name.
PlotSeries dots_of(const SectionCurve& curve) {
    PlotSeries series;
    series.label = curve.name.substr(length_prefix.size()) + "°";
    series.kind = SeriesKind::points;
    return series;
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

double highest_bed(const Snapshot& snapshot) {
    const auto heights = snapshot.bed.values();
    return *std::max_element(heights.begin(), heights.end()) * snapshot.scale.height_unit;
}

Plot stress_plot(const Snapshot& snapshot, const LengthUnit& unit) {
    const SectionCurve& curve = *section_curves(*snapshot.section, "bed_shear_stress").front();
    const double dx = snapshot.section->dx / unit.length;
    PlotSeries stress;
    stress.y = curve.values;
    for (std::size_t i = 0; i < curve.values.size(); ++i)
        stress.x.push_back(static_cast<double>(i) * dx);
    Plot plot;
    const std::size_t columns = stress.x.size();
    plot.series.push_back(std::move(stress));
    const auto mean = number_of(snapshot, "stress_mean");
    const auto amplitude = number_of(snapshot, "stress_amplitude");
    const auto phase = number_of(snapshot, "stress_phase");
    const auto waves = number_of(snapshot, "bed_waves");
    if (mean && amplitude && phase && waves) {
        plot.series.front().label = word("stress");
        PlotSeries fit;
        fit.label = word("cosine fit");
        fit.kind = SeriesKind::fit;
        for (std::size_t i = 0; i <= columns; ++i) {
            const double place = static_cast<double>(i);
            const double angle =
                2.0 * std::numbers::pi * *waves * place / static_cast<double>(columns);
            fit.x.push_back(place * dx);
            fit.y.push_back(*mean + *amplitude * elementary::cos(angle + *phase));
        }
        plot.series.push_back(std::move(fit));
    }
    plot.x = axis_along(snapshot, unit);
    plot.y = axis_from_zero(plot.series, "τ (Pa)");
    return plot;
}

Plot flights_plot(const Snapshot& snapshot, const LengthUnit& unit) {
    Plot plot;
    for (const SectionCurve* curve : section_curves(*snapshot.section, length_prefix)) {
        PlotSeries series = dots_of(*curve);
        for (std::size_t i = 0; i < curve->values.size(); ++i) {
            series.x.push_back(static_cast<double>(i) * snapshot.section->dx / unit.length);
            series.y.push_back(curve->values[i] / unit.length);
        }
        plot.series.push_back(std::move(series));
    }
    plot.x = axis_along(snapshot, unit);
    plot.y = axis_from_zero(plot.series, labelled("flight length", unit.symbol));
    return plot;
}

Plot flight_law_plot(const Snapshot& snapshot, const LengthUnit& unit) {
    Plot plot;
    double lowest = INFINITY;
    double highest = -INFINITY;
    for (const SectionCurve* curve : section_curves(*snapshot.section, length_prefix)) {
        PlotSeries series = dots_of(*curve);
        for (std::size_t i = 0; i < curve->values.size(); ++i) {
            const double height =
                snapshot.bed(static_cast<int>(i), 0) * snapshot.scale.height_unit / unit.length;
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
            series.x.push_back(height);
            series.y.push_back(curve->values[i] / unit.length);
        }
        plot.series.push_back(std::move(series));
    }
    if (!(highest > lowest)) highest = lowest + 1.0;
    const auto base = number_of(snapshot, "hop_base");
    if (base && std::isfinite(*base)) {
        constexpr double millimetre = 1e-3;
        PlotSeries law;
        law.label = fmt::format("{:.3g}^{{h}} − 1", *base);
        law.kind = SeriesKind::fit;
        constexpr int pieces = 100;
        for (int i = 0; i <= pieces; ++i) {
            const double height = std::lerp(lowest, highest, static_cast<double>(i) / pieces);
            law.x.push_back(height);
            law.y.push_back((elementary::pow(*base, height * unit.length / millimetre) - 1.0) *
                            millimetre / unit.length);
        }
        plot.series.push_back(std::move(law));
    }
    plot.x.label = labelled("launch height h", unit.symbol);
    plot.x.low = lowest;
    plot.x.high = highest;
    plot.y = axis_from_zero(plot.series, labelled("flight length", unit.symbol));
    return plot;
}

}  // namespace fumon
