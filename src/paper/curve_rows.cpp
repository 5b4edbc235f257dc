#include "paper/curve_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "base/error.h"
#include "base/quantity_text.h"
#include "figure/words/words.h"
#include "files/text_source.h"
#include "scene/placeholders.h"

namespace fumon {

namespace {

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
            "\"{}\" is not a condition; write column=value, column>=value, column<value …", text));
    }
    return condition;
}

/// Whether a row has numbers in x and y, else it is missing data.
bool has_point(const Table& table, const CurveSettings& settings, std::size_t row) {
    return std::isfinite(table.find(settings.x)->values[row]) &&
           std::isfinite(table.find(settings.y)->values[row]);
}

}  // namespace

TableRows chosen_rows(const Table& table, const CurveSettings& settings) {
    std::vector<Condition> conditions;
    for (const std::string& text : settings.where)
        conditions.push_back(read_condition(text, table));
    TableRows rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (std::all_of(conditions.begin(), conditions.end(),
                        [&](const Condition& condition) { return condition.holds(row); }))
            rows.push_back(row);
    }
    return rows;
}

std::vector<TableRows> groups_of_rows(const Table& table, const CurveSettings& settings,
                                      const TableRows& rows) {
    const auto is_point = [&](std::size_t row) { return has_point(table, settings, row); };
    if (settings.group_by.empty()) {
        if (std::ranges::none_of(rows, is_point)) return {};
        return {rows};
    }
    const TableColumn& by = *table.find(settings.group_by);
    std::map<std::string, std::size_t> places;
    std::vector<TableRows> groups;
    for (const std::size_t row : rows) {
        const auto [place, is_new] = places.emplace(by.text(row), groups.size());
        if (is_new) groups.emplace_back();
        groups[place->second].push_back(row);
    }
    std::erase_if(groups,
                  [&](const TableRows& group) { return std::ranges::none_of(group, is_point); });
    return groups;
}

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

void refuse_infinities(const Table& table, const CurveSettings& settings, const std::string& file) {
    for (const std::string& name : {settings.x, settings.y, settings.z}) {
        const TableColumn* column = table.find(name);
        if (column == nullptr) continue;
        for (const auto& [row, written] : column->not_finite) {
            if (written.find_first_of("aA") != std::string::npos) continue;  // nan
            throw InputError(fmt::format(
                "{}:{}: {} is {}; it takes a finite number, or an empty cell where there is none",
                file, table.lines[row], name, written));
        }
    }
}

std::string curve_name(const CurvePlan& curve, const Table& table, const TableRows& rows) {
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

}  // namespace fumon
