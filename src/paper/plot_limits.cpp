#include "paper/plot_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"

namespace fumon {

namespace {

/// The values of both quantities that something covers.
struct Extent {
    double x_low = INFINITY, x_high = -INFINITY;
    double y_low = INFINITY, y_high = -INFINITY;

    void add(double x, double y) {
        x_low = std::min(x_low, x);
        x_high = std::max(x_high, x);
        y_low = std::min(y_low, y);
        y_high = std::max(y_high, y);
    }
    [[nodiscard]] bool empty() const { return !(x_low <= x_high); }
};

bool may_show(const PlotAxis& axis, double value) {
    return std::isfinite(value) && (!axis.logarithmic || value > 0.0);
}

bool reaches(const PlotAxis& axis, double low, double high) {
    return high >= axis.low.value_or(-INFINITY) && low <= axis.high.value_or(INFINITY);
}

bool is_within(const Plot& plot, const Extent& extent) {
    return !extent.empty() && reaches(plot.x, extent.x_low, extent.x_high) &&
           reaches(plot.y, extent.y_low, extent.y_high);
}

/// Whether a point of a series lies within the axes, or a piece of its line may.
bool is_visible(const Plot& plot, const PlotSeries& series) {
    const bool has_line = series.kind != SeriesKind::points;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        Extent piece;
        const std::size_t last = has_line ? std::min(i + 1, series.x.size() - 1) : i;
        for (std::size_t k = i; k <= last; ++k) {
            if (may_show(plot.x, series.x[k]) && may_show(plot.y, series.y[k]))
                piece.add(series.x[k], series.y[k]);
        }
        if (is_within(plot, piece)) return true;
    }
    return false;
}

Extent extent_of(const Plot& plot) {
    Extent all;
    for (const PlotSeries& series : plot.series) {
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            if (may_show(plot.x, series.x[i]) && may_show(plot.y, series.y[i]))
                all.add(series.x[i], series.y[i]);
        }
    }
    for (const PlotBox& box : plot.boxes) {
        all.add(box.x_low, box.y_low);
        all.add(box.x_high, box.y_high);
    }
    return all;
}

/// The first limit that the scene gives, else the kind of axis.
std::string key_of_limits(const PanelSettings& panel) {
    const std::array<std::pair<const char*, const WordOrReal*>, 4> limits{
        {{".x_low", &panel.x_low},
         {".x_high", &panel.x_high},
         {".y_low", &panel.y_low},
         {".y_high", &panel.y_high}}};
    for (const auto& [key, limit] : limits) {
        if (!limit->is_word()) return key;
    }
    return panel.x_logarithmic ? ".x_logarithmic" : ".y_logarithmic";
}

}  // namespace

std::vector<std::string> check_limits(const PanelPlan& panel, const Plot& plot,
                                      const Scene& scene) {
    std::vector<std::string> warnings;
    bool anything = std::ranges::any_of(plot.boxes, [&](const PlotBox& box) {
        Extent extent;
        extent.add(box.x_low, box.y_low);
        extent.add(box.x_high, box.y_high);
        return is_within(plot, extent);
    });
    std::size_t number = 0;
    for (const PlotSeries& series : plot.series) {
        if (series.kind == SeriesKind::fit || series.kind == SeriesKind::band) continue;
        ++number;
        if (is_visible(plot, series)) {
            anything = true;
            continue;
        }
        warnings.push_back(fmt::format(
            "the curve{} lies outside the axes",
            series.label.empty() ? fmt::format(" {}", number) : " \"" + series.label + "\""));
    }
    if (anything) return warnings;
    const std::string key = panel.path + key_of_limits(panel.settings);
    const Extent all = extent_of(plot);
    const std::string where = all.empty()
                                  ? "no value is above 0"
                                  : fmt::format("x is {:.6g} to {:.6g}, y is {:.6g} to {:.6g}",
                                                all.x_low, all.x_high, all.y_low, all.y_high);
    throw InputError(scene.at(key) +
                     fmt::format("{}: nothing lies within the axes: {}", key, where));
}

}  // namespace fumon
