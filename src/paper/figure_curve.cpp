#include "paper/figure_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "measure/shared/undefined.h"
#include "paper/curve_rows.h"

namespace fumon {

namespace {

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Standard deviation of a sample, or of its mean; a single value has none.
double spread_of(const std::vector<double>& values, CurveSpread spread) {
    if (values.size() < 2) return undefined;
    const auto count = static_cast<double>(values.size());
    const double mean = mean_of(values);
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double deviation = std::sqrt(squares / (count - 1.0));
    return spread == CurveSpread::standard_error ? deviation / std::sqrt(count) : deviation;
}

void add_points(CurvePoints& points, const CurvePlan& curve, const Table& table,
                const TableRows& rows) {
    const CurveSettings& settings = curve.settings;
    const TableColumn& x = *table.find(settings.x);
    const TableColumn& y = *table.find(settings.y);
    const auto shown = [&](double value) { return (value + settings.offset_y) * settings.scale_y; };
    if (!settings.average) {
        for (const std::size_t row : rows) {
            points.x.push_back(x.values[row] * settings.scale_x);
            points.y.push_back(shown(y.values[row]));
        }
        return;
    }
    struct Averaged {
        std::vector<double> values;
        std::set<std::size_t> runs;
    };
    std::map<double, Averaged> by_x;
    const std::vector<std::size_t> runs = runs_of_rows(curve, table);
    for (const std::size_t row : rows) {
        if (!std::isfinite(x.values[row])) continue;
        Averaged& averaged = by_x[x.values[row]];
        if (!std::isfinite(y.values[row])) continue;
        averaged.values.push_back(shown(y.values[row]));
        averaged.runs.insert(runs[row]);
    }
    const bool pooled = curve.sweep && settings.table == CurveTable::avalanche_sizes;
    const bool spreads = settings.spread != CurveSpread::none;
    for (const auto& [place, averaged] : by_x) {
        const std::int64_t count =
            pooled ? curve.sweep->seeds.count() : static_cast<std::int64_t>(averaged.runs.size());
        const bool left_out = averaged.values.empty() || count < settings.least;
        points.x.push_back(place * settings.scale_x);
        points.y.push_back(left_out ? undefined : mean_of(averaged.values));
        points.counts.push_back(static_cast<std::int64_t>(averaged.values.size()));
        if (curve.sweep || spreads) points.runs.push_back(count);
        if (spreads) points.spread.push_back(spread_of(averaged.values, settings.spread));
    }
}

void fit(CurvePoints& points, const CurveSettings& settings) {
    if (settings.fit == CurveFit::none) return;
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        if (!std::isfinite(points.x[i]) || !std::isfinite(points.y[i])) continue;
        if (!settings.fit_low.is_word() && points.x[i] < settings.fit_low.value) continue;
        if (!settings.fit_high.is_word() && points.x[i] > settings.fit_high.value) continue;
        x.push_back(points.x[i]);
        y.push_back(points.y[i]);
    }
    points.law = fit_law(settings.fit, x, y);
    points.law_low = *std::min_element(x.begin(), x.end());
    points.law_high = *std::max_element(x.begin(), x.end());
}

}  // namespace

std::vector<CurvePoints> curve_points(const CurvePlan& curve, const Table& table) {
    const CurveSettings& settings = curve.settings;
    const TableRows rows = chosen_rows(table, settings);
    const std::vector<TableRows> groups = groups_of_rows(table, settings, rows);
    if (groups.empty()) throw InputError("no row has numbers in x and y and meets the conditions");
    std::vector<CurvePoints> curves;
    for (const TableRows& group : groups) {
        CurvePoints points;
        points.name = curve_name(curve, table, group);
        points.x_name = settings.x;
        points.y_name = settings.y;
        if (settings.scale_x == 1.0) points.x_unit = table.find(settings.x)->unit;
        if (settings.scale_y == 1.0) points.y_unit = table.find(settings.y)->unit;
        add_points(points, curve, table, group);
        if (std::ranges::none_of(points.y, [](double y) { return std::isfinite(y); })) continue;
        fit(points, settings);
        curves.push_back(std::move(points));
    }
    if (curves.empty()) {
        throw InputError(fmt::format("no point is the mean of {} runs or more, as `least` demands",
                                     settings.least));
    }
    return curves;
}

std::string curve_csv(const CurvePoints& points) {
    std::string text;
    if (!points.formula.empty()) text += fmt::format("# y = {}\n", points.formula);
    if (points.law) {
        text += fmt::format("# fitted to x from {} to {}: {}\n", points.law_low, points.law_high,
                            points.law->text());
        for (const auto& [name, value] : points.law->values)
            text += fmt::format("# {} = {}\n", name, value);
    }
    const auto column = [](const std::string& name, const std::string& unit) {
        return unit.empty() ? name : fmt::format("{} ({})", name, unit);
    };
    std::vector<std::string> header{column(points.x_name, points.x_unit),
                                    column(points.y_name, points.y_unit)};
    if (!points.spread.empty()) header.push_back("spread");
    if (!points.counts.empty()) header.push_back("rows");
    text += csv_line(header);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        if (!std::isfinite(points.x[i]) || !std::isfinite(points.y[i])) continue;
        std::vector<std::string> cells{fmt::format("{}", points.x[i]),
                                       fmt::format("{}", points.y[i])};
        if (!points.spread.empty()) cells.push_back(csv_number(points.spread[i]));
        if (!points.counts.empty()) cells.push_back(fmt::format("{}", points.counts[i]));
        text += csv_line(cells);
    }
    return text;
}

}  // namespace fumon
