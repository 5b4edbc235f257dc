#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "figure/words/words.h"
#include "files/csv_table.h"
#include "numerics/distribution.h"
#include "paper/curve_rows.h"
#include "paper/figure_tables.h"
#include "paper/panel_makers.h"
#include "paper/plot_limits.h"
#include "paper/plot_parts.h"

namespace fumon {

namespace {

/// The values of each x of one curve, or of one of its groups.
struct Distributions {
    std::string name;  ///< in the legend
    std::string x_name, x_unit;
    std::string y_name, y_unit;
    std::map<std::string, std::vector<double>> values;  ///< by x as it is written
    std::size_t colour = 0;  ///< number in the cycle, from 1; 0: the next
};

/// What x is called, as the table has it; numbers in the unit of the axis.
std::string place_name(const TableColumn& column, std::size_t row, double scale) {
    return std::isfinite(column.values[row]) ? fmt::format("{:g}", column.values[row] * scale)
                                             : column.text(row);
}

std::vector<Distributions> distributions_of(const CurvePlan& curve, const PanelTools& tools,
                                            std::vector<std::pair<double, std::string>>& places) {
    const CurveSettings& settings = curve.settings;
    CurveSettings of_values = settings;  // x may be words
    of_values.x = settings.y;
    const Table table = curve_table(curve, tools.runs, tools.store);
    const TableColumn& x = *table.find(settings.x);
    const TableColumn& y = *table.find(settings.y);
    std::vector<Distributions> all;
    for (const TableRows& group : groups_of_rows(table, of_values, chosen_rows(table, of_values))) {
        Distributions one{curve_name(curve, table, group),          settings.x,
                          settings.scale_x == 1.0 ? x.unit : "",    settings.y,
                          settings.scale_y == 1.0 ? y.unit : "",    {},
                          static_cast<std::size_t>(settings.colour)};
        for (const std::size_t row : group) {
            const std::string name = place_name(x, row, settings.scale_x);
            if (name.empty() || !std::isfinite(y.values[row])) continue;
            if (std::ranges::find(places, name, &std::pair<double, std::string>::second) ==
                places.end())
                places.emplace_back(x.values[row] * settings.scale_x, name);
            one.values[name].push_back((y.values[row] + settings.offset_y) * settings.scale_y);
        }
        if (!one.values.empty()) all.push_back(std::move(one));
    }
    if (all.empty()) throw InputError("no row has a number in y and meets the conditions");
    return all;
}

/// The series that draw one box or violin around a place.
class Drawing {
  public:
    Drawing(Plot& plot, const ChartSettings& chart, const Ink& ink, double place, double half)
        : plot_(plot), chart_(chart), ink_(ink), place_(place), half_(half) {}

    void add(const std::vector<double>& values, const BoxStatistics& box, const DensityCurve& curve,
             const std::string& label) {
        if (chart_.shape == DistributionShape::violin && !curve.value.empty()) {
            violin(curve, label);
            line({place_, place_}, {box.lower_quartile, box.upper_quartile}, 3.0);
        } else {
            boxed(box, label);
        }
        median(box);
        if (chart_.show_values) {
            points(values);
        } else if (chart_.shape == DistributionShape::box) {
            points(box.beyond);
        }
    }

  private:
    PlotSeries& next(SeriesKind kind, std::vector<double> x, std::vector<double> y) {
        PlotSeries series;
        series.kind = kind;
        series.x = std::move(x);
        series.y = std::move(y);
        series.ink = ink_;
        series.dashes = LineDashes{};
        plot_.series.push_back(std::move(series));
        return plot_.series.back();
    }

    void line(std::vector<double> x, std::vector<double> y, double width) {
        next(SeriesKind::line, std::move(x), std::move(y)).width = width_of_line * width;
    }

    void boxed(const BoxStatistics& box, const std::string& label) {
        const double left = place_ - half_;
        const double right = place_ + half_;
        next(SeriesKind::area, {left, right, right, left},
             {box.lower_quartile, box.lower_quartile, box.upper_quartile, box.upper_quartile})
            .label = label;
        const double cap = 0.5 * half_;
        for (const auto& [from, to] : {std::pair{box.lower_quartile, box.lower_whisker},
                                       {box.upper_quartile, box.upper_whisker}}) {
            if (from == to) continue;
            line({place_, place_}, {from, to}, 1.3);
            line({place_ - cap, place_ + cap}, {to, to}, 1.3);
        }
    }

    void violin(const DensityCurve& curve, const std::string& label) {
        const double most = *std::ranges::max_element(curve.density);
        std::vector<double> x;
        std::vector<double> y = curve.value;
        for (const double density : curve.density) x.push_back(place_ - half_ * density / most);
        for (std::size_t i = curve.value.size(); i-- > 0;) {
            x.push_back(place_ + half_ * curve.density[i] / most);
            y.push_back(curve.value[i]);
        }
        next(SeriesKind::area, std::move(x), std::move(y)).label = label;
    }

    void median(const BoxStatistics& box) {
        const double half = chart_.shape == DistributionShape::violin ? 0.4 * half_ : half_;
        line({place_ - half, place_ + half}, {box.median, box.median}, 2.5);
    }

    void points(const std::vector<double>& values) {
        if (values.empty()) return;
        next(SeriesKind::points, std::vector<double>(values.size(), place_), values).marker =
            Marker::dot;
    }

    static constexpr double width_of_line = 0.4;  // points

    Plot& plot_;
    const ChartSettings& chart_;
    Ink ink_;
    double place_;
    double half_;
};

std::string csv_of(const Distributions& one,
                   const std::vector<std::pair<double, std::string>>& places) {
    const auto column = [](const std::string& name, const std::string& unit) {
        return unit.empty() ? name : fmt::format("{} ({})", name, unit);
    };
    std::string text = fmt::format(
        "# of {}: quartiles linear between values, whiskers within 1.5 times their "
        "range\n",
        column(one.y_name, one.y_unit));
    text += csv_line({column(one.x_name, one.x_unit), "n", "mean", "lower_whisker",
                      "lower_quartile", "median", "upper_quartile", "upper_whisker", "beyond"});
    for (const auto& [at, name] : places) {
        const auto values = one.values.find(name);
        if (values == one.values.end()) continue;
        const BoxStatistics box = box_statistics(values->second);
        std::vector<std::string> cells{name, fmt::format("{}", box.count)};
        for (const double value : {box.mean, box.lower_whisker, box.lower_quartile, box.median,
                                   box.upper_quartile, box.upper_whisker})
            cells.push_back(fmt::format("{}", value));
        cells.push_back(fmt::format("{}", box.beyond.size()));
        text += csv_line(cells);
    }
    return text;
}

/// The places along the densities, and the densities, of every x.
std::string density_csv(const Distributions& one,
                        const std::vector<std::pair<double, std::string>>& places) {
    std::string text = csv_line({one.x_name, one.y_name, "density"});
    for (const auto& [at, name] : places) {
        const auto values = one.values.find(name);
        if (values == one.values.end()) continue;
        const DensityCurve curve = gaussian_density(values->second);
        for (std::size_t i = 0; i < curve.value.size(); ++i)
            text += csv_line(
                {name, fmt::format("{}", curve.value[i]), fmt::format("{}", curve.density[i])});
    }
    return text;
}

std::string values_csv(const Distributions& one,
                       const std::vector<std::pair<double, std::string>>& places) {
    std::string text = csv_line({one.x_name, one.y_name});
    for (const auto& [at, name] : places) {
        const auto values = one.values.find(name);
        if (values == one.values.end()) continue;
        for (const double value : values->second)
            text += csv_line({name, fmt::format("{}", value)});
    }
    return text;
}

std::string count_remark(const std::vector<Distributions>& all) {
    std::set<std::size_t> counts;
    for (const Distributions& one : all) {
        for (const auto& [name, values] : one.values) counts.insert(values.size());
    }
    const std::string range = *counts.begin() < *counts.rbegin()
                                  ? phrase("{} to {}", *counts.begin(), *counts.rbegin())
                                  : fmt::format("{}", *counts.begin());
    return phrase("n = {} for each", range);
}

std::vector<MadePanel> make_box_plots(const PanelSubject& subject, PanelTools& tools) {
    const PanelSettings& settings = subject.panel.settings;
    const ChartSettings& chart = settings.chart;
    std::vector<Distributions> all;
    std::vector<std::pair<double, std::string>> places;
    for (const CurvePlan& curve : subject.panel.curves) {
        try {
            for (Distributions& one : distributions_of(curve, tools, places))
                all.push_back(std::move(one));
        } catch (const InputError& fault) {
            throw placed(tools.plan.scene.at(curve.path + ".y"), fault);
        }
    }
    const bool numbers =
        std::ranges::all_of(places, [](const auto& place) { return std::isfinite(place.first); });
    if (numbers) std::ranges::sort(places);
    std::vector<MadePanel> made(1);
    Plot plot;
    constexpr double all_of_place = 0.7;  // what the boxes of one x take
    const double room = all_of_place / static_cast<double>(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Distributions& one = all[k];
        const Ink ink = series_look(one.colour > 0 ? one.colour - 1 : k).ink;
        bool named = false;
        for (std::size_t p = 0; p < places.size(); ++p) {
            const auto values = one.values.find(places[p].second);
            if (values == one.values.end()) continue;
            const double place = static_cast<double>(p) + 1.0 - 0.5 * all_of_place +
                                 (static_cast<double>(k) + 0.5) * room;
            Drawing(plot, chart, ink, place, 0.4 * room)
                .add(values->second, box_statistics(values->second),
                     gaussian_density(values->second), named ? "" : one.name);
            named = true;
        }
        const std::size_t number = k + 1;
        made[0].data.push_back({fmt::format("-{}.csv", number), csv_of(one, places)});
        if (chart.shape == DistributionShape::violin)
            made[0].data.push_back(
                {fmt::format("-{}-density.csv", number), density_csv(one, places)});
        made[0].data.push_back({fmt::format("-{}-values.csv", number), values_csv(one, places)});
    }
    plot.x = x_axis_of(settings, all.front().x_name, all.front().x_unit);
    plot.x.low = 0.5;
    plot.x.high = static_cast<double>(places.size()) + 0.5;
    for (std::size_t p = 0; p < places.size(); ++p)
        plot.x.named.emplace_back(static_cast<double>(p) + 1.0, places[p].second);
    plot.y = y_axis_of(settings, all.front().y_name, all.front().y_unit);
    plot.legend = legend_of(settings.legend);
    made[0].warnings = check_limits(subject.panel, plot, tools.plan.scene);
    made[0].remarks.push_back(
        chart.shape == DistributionShape::box
            ? word("boxes from the lower to the upper quartile (linear between values) with the "
                   "median; whiskers to the farthest values within 1.5 times the box's length")
            : word("outlines are densities (normal distributions as wide as Scott's rule says), "
                   "each as wide as the others; thick lines from the lower to the upper quartile, "
                   "across them the median"));
    if (chart.show_values) made[0].remarks.push_back(word("points are all values"));
    if (!chart.show_values && chart.shape == DistributionShape::box)
        made[0].remarks.push_back(word("points are values beyond the whiskers"));
    made[0].remarks.push_back(count_remark(all));
    made[0].content = std::make_unique<PlotPanel>(std::move(plot));
    return made;
}

}  // namespace

const PanelMaker panels::box_plot{nullptr, make_box_plots};

}  // namespace fumon
