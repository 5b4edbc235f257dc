#include "paper/figure_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "base/error.h"
#include "figure/words/words.h"
#include "files/text_source.h"
#include "measure/shared/undefined.h"
#include "scene/placeholders.h"

namespace fumon {

namespace {

using Rows = std::vector<std::size_t>;

/// "column>=value".
struct Condition {
    const TableColumn* column = nullptr;
    std::string relation;
    std::string text;
    double value = 0.0;
    bool is_number = false;

    [[nodiscard]] bool holds(std::size_t row) const {
        if (!is_number) return (column->text(row) == text) == (relation == "=");
        const double cell = column->values[row];
        if (relation == "=") return cell == value;
        if (relation == "!=") return cell != value;
        if (relation == "<") return cell < value;
        if (relation == "<=") return cell <= value;
        return relation == ">" ? cell > value : cell >= value;
    }
};

Condition read_condition(const std::string& text, const Table& table) {
    const std::size_t start = std::min(text.find_first_of("=<>!"), text.size());
    const std::size_t after = std::min(text.find_first_not_of("=<>!", start), text.size());
    Condition condition{table.find(text.substr(0, start)), text.substr(start, after - start),
                        text.substr(after), 0.0, false};
    if (condition.relation == "==") condition.relation.pop_back();
    const std::vector<std::string> known{"=", "!=", "<", "<=", ">", ">="};
    const ParsedNumber number = parse_number(condition.text);
    condition.is_number =
        number.kind == NumberKind::finite && number.length == condition.text.size();
    condition.value = number.value;
    const bool compares = condition.relation != "=" && condition.relation != "!=";
    if (condition.column == nullptr || condition.text.empty() ||
        std::find(known.begin(), known.end(), condition.relation) == known.end() ||
        (compares && !condition.is_number)) {
        throw InputError(fmt::format(
            "\"{}\" is no condition; write column=value, column>=value, column<value …", text));
    }
    return condition;
}

/// Whether a row has numbers in x and y, else it is missing data.
bool has_point(const Table& table, const CurveSettings& settings, std::size_t row) {
    return std::isfinite(table.find(settings.x)->values[row]) &&
           std::isfinite(table.find(settings.y)->values[row]);
}

/// The rows that meet the conditions, missing data among them.
Rows chosen_rows(const Table& table, const CurveSettings& settings) {
    std::vector<Condition> conditions;
    for (const std::string& text : settings.where)
        conditions.push_back(read_condition(text, table));
    Rows rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (std::all_of(conditions.begin(), conditions.end(),
                        [&](const Condition& condition) { return condition.holds(row); }))
            rows.push_back(row);
    }
    return rows;
}

/// The rows of each value of settings.group_by, in the order in which the values come up; no group
/// without a point.
std::vector<Rows> groups_of(const Table& table, const CurveSettings& settings, const Rows& rows) {
    const auto is_point = [&](std::size_t row) { return has_point(table, settings, row); };
    if (settings.group_by.empty()) {
        if (std::ranges::none_of(rows, is_point)) return {};
        return {rows};
    }
    const TableColumn& by = *table.find(settings.group_by);
    std::map<std::string, std::size_t> places;
    std::vector<Rows> groups;
    for (const std::size_t row : rows) {
        const auto [place, is_new] = places.emplace(by.text(row), groups.size());
        if (is_new) groups.emplace_back();
        groups[place->second].push_back(row);
    }
    std::erase_if(groups, [&](const Rows& group) { return std::ranges::none_of(group, is_point); });
    return groups;
}

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

/// Which run each row comes from; of a file's, each row its own.
std::vector<std::size_t> runs_of_rows(const CurvePlan& curve, const Table& table) {
    std::vector<std::size_t> runs(table.rows());
    if (!curve.sweep) {
        std::iota(runs.begin(), runs.end(), std::size_t{0});
        return runs;
    }
    std::vector<std::string> names = varied_keys(*curve.sweep);
    names.emplace_back("seed");
    std::map<std::string, std::size_t> known;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        std::string run;
        for (const std::string& name : names) run += table.find(name)->text(row) + '\n';
        runs[row] = known.emplace(std::move(run), known.size()).first->second;
    }
    return runs;
}

void add_points(CurvePoints& points, const CurvePlan& curve, const Table& table, const Rows& rows) {
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

std::string curve_name(const CurvePlan& curve, const Table& table, const Rows& rows) {
    const CurveSettings& settings = curve.settings;
    std::string text = settings.name;
    if (text.empty() && !settings.group_by.empty()) {
        const std::string& group = settings.group_by;
        text = name_in_words(group.substr(group.rfind('.') + 1)) + " = {" + group + "}";
    }
    return fill_placeholders(text, [&](const std::string& name) -> std::optional<std::string> {
        if (const TableColumn* column = table.find(name)) return column->text(rows.front());
        return key_text(curve.scene, name);
    });
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
    const Rows rows = chosen_rows(table, settings);
    const std::vector<Rows> groups = groups_of(table, settings, rows);
    if (groups.empty()) throw InputError("no row has numbers in x and y and meets the conditions");
    std::vector<CurvePoints> curves;
    for (const Rows& group : groups) {
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
        throw InputError(
            fmt::format("no point is of {} runs or more, as least says", settings.least));
    }
    return curves;
}

std::string curve_csv(const CurvePoints& points) {
    std::string text;
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
