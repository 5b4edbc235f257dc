#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "figure/plot/plot.h"

namespace fumon {

/// The smallest and largest of some values, none at first.
struct ValueRange {
    double low = INFINITY;
    double high = -INFINITY;

    void add(double value) {
        low = value < low ? value : low;
        high = value > high ? value : high;
    }
    [[nodiscard]] bool empty() const { return !(low <= high); }
};

/// From values to shares of an axis's length.
struct PlotScale {
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;

    /// 0 at the low end, 1 at the high one; −infinity for what a logarithmic axis cannot show.
    [[nodiscard]] double share(double value) const;
    /// Whether the axis can show a value at all.
    [[nodiscard]] bool shows(double value) const;
};

/// The range of an axis over some values: what its settings say, else out to round numbers, with 0
/// where it is near. `room`: the share of the range to keep between the values and the ends.
PlotScale plot_scale(const PlotAxis& axis, const ValueRange& values, double room);

/// A scale whose high end lies that share of its length further up, at a round number.
PlotScale stretched(const PlotScale& scale, double share);

/// The ranges of the values that a plot shows along its axes.
struct PlotRanges {
    ValueRange x;
    ValueRange y;
    ValueRange right;
};
PlotRanges plot_ranges(const Plot& plot);

/// The room that a plot keeps between its values and the ends of the x axis: none where curves
/// only reach them. As a share of the range.
double room_along_x(const Plot& plot);
constexpr double room_along_y_share = 0.03;

/// The marks of a plot's axis.
struct PlotTicks {
    std::vector<double> values;
    std::vector<std::string> labels;  ///< as many
    std::vector<double> minor;        ///< without labels
    int power = 0;                    ///< of ten, which all labels are to be taken times
};

/// Marks with no more than `most` labels (at least 2).
PlotTicks plot_ticks(const PlotScale& scale, int most);

}  // namespace fumon
