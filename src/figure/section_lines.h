#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "figure/axes.h"
#include "models/model.h"

namespace fumon {

/// One quantity over another, as a line or as dots.
struct LineSeries {
    std::string label;  ///< for the legend
    Ink ink;
    std::vector<glm::dvec2> points;
    bool dots = false;
};

/// What a panel of lines shows, and over which ranges.
struct LinePanel {
    AxisRange x;
    AxisRange y;
    std::vector<LineSeries> series;
};

/// The shear stress along the bed, in Pa, and the cosine fitted to it, where the snapshot has the
/// numbers of the fit. `unit` is what lengths are shown in, in metres, and
/// `symbol` its name.
LinePanel stress_panel(const Snapshot& snapshot, double unit, const std::string& symbol);

/// The flight length over the launch place, per launch angle.
LinePanel flights_panel(const Snapshot& snapshot, double unit, const std::string& symbol);

/// The flight length over the bed's height at the launch place, per launch angle, with the law
/// l = a^h - 1 (Terada 2025, section 4; millimetres) where the snapshot has the number "hop_base".
LinePanel flight_law_panel(const Snapshot& snapshot, double unit, const std::string& symbol);

/// The curves of that prefix: "flight_length_" …
std::vector<const SectionCurve*> section_curves(const SnapshotSection& section,
                                                const std::string& prefix);

/// Colours that differ, from dark to light, for the n-th of `count` angles.
Ink series_ink(std::size_t n, std::size_t count);

/// Draws the series within their axes' frame.
void draw_series(Canvas& canvas, const Axes& axes, const std::vector<LineSeries>& series);

/// Writes the labels of the series beside samples of them in a row above the frame, flush right,
/// no longer than `longest` pixels. Returns the row's length.
double draw_legend(Canvas& canvas, const Axes& axes, const std::vector<LineSeries>& series,
                   double longest);

}  // namespace fumon
