#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/quantity_text.h"
#include "figure/charts/heat_map.h"
#include "figure/words/words.h"
#include "files/csv_table.h"
#include "measure/shared/undefined.h"
#include "numerics/distribution.h"
#include "paper/curve_rows.h"
#include "paper/figure_tables.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"
#include "paper/plot_parts.h"

namespace fumon {

namespace {

using Values = PanelColours::Values;

/// The columns or rows of a heat map, as a column of its table gives them.
struct AxisCategories {
    std::vector<std::string> names;
    std::vector<double> values;        ///< empty where they are words
    std::vector<std::size_t> of_rows;  ///< the place of each row of the table, from 0
};

std::string number_text(double value, const char* format = "{:g}") {
    std::string text = fmt::format(fmt::runtime(format), value == 0.0 ? 0.0 : value);
    if (text.front() == '-') text.replace(0, 1, "\u2212");
    return text;
}

/// Words in the order in which they come up, numbers rising; no place for missing ones.
AxisCategories categories_of(const TableColumn& column, const TableRows& rows, double offset,
                             double scale) {
    constexpr auto nowhere = static_cast<std::size_t>(-1);
    AxisCategories places;
    places.of_rows.assign(column.values.size(), nowhere);
    const bool words = std::ranges::any_of(rows, [&](std::size_t row) {
        return !std::isfinite(column.values[row]) && !column.text(row).empty();
    });
    if (!words) {
        std::set<double> all;
        for (const std::size_t row : rows) {
            if (std::isfinite(column.values[row])) all.insert(column.values[row]);
        }
        const std::vector<double> rising(all.begin(), all.end());
        for (const std::size_t row : rows) {
            if (!std::isfinite(column.values[row])) continue;
            places.of_rows[row] = static_cast<std::size_t>(
                std::ranges::lower_bound(rising, column.values[row]) - rising.begin());
        }
        for (const double value : rising) {
            places.values.push_back((value + offset) * scale);
            places.names.push_back(number_text(places.values.back()));
        }
        return places;
    }
    for (const std::size_t row : rows) {
        const std::string name = column.text(row);
        if (name.empty()) continue;
        const auto known = std::ranges::find(places.names, name);
        places.of_rows[row] = static_cast<std::size_t>(known - places.names.begin());
        if (known == places.names.end()) places.names.push_back(name);
    }
    return places;
}

/// What the rows of each cell come to.
struct Cells {
    Grid means;
    Grid counts;  ///< runs
};

Cells cells_of(const CurvePlan& curve, const Table& table, const TableRows& rows,
               const AxisCategories& x, const AxisCategories& y) {
    const TableColumn& z = *table.find(curve.settings.z);
    const std::vector<std::size_t> runs = runs_of_rows(curve, table);
    const int nx = static_cast<int>(x.names.size());
    const int ny = static_cast<int>(y.names.size());
    Cells cells{Grid(nx, ny), Grid(nx, ny)};
    Grid values(nx, ny);
    std::vector<std::set<std::size_t>> behind(values.size());
    for (const std::size_t row : rows) {
        if (x.of_rows[row] >= x.names.size() || y.of_rows[row] >= y.names.size() ||
            !std::isfinite(z.values[row]))
            continue;
        const std::size_t cell = y.of_rows[row] * x.names.size() + x.of_rows[row];
        cells.means.values()[cell] += z.values[row];
        values.values()[cell] += 1.0;
        behind[cell].insert(runs[row]);
    }
    for (std::size_t i = 0; i < behind.size(); ++i) {
        const auto count = static_cast<std::int64_t>(behind[i].size());
        cells.counts.values()[i] = static_cast<double>(count);
        double& mean = cells.means.values()[i];
        mean = count == 0 || count < curve.settings.least ? undefined : mean / values.values()[i];
    }
    return cells;
}

Values values_of(const Grid& means) {
    Values values;
    for (const double mean : means.values()) {
        if (!std::isfinite(mean)) continue;
        values = values ? std::pair{std::min(values->first, mean), std::max(values->second, mean)}
                        : std::pair{mean, mean};
    }
    return values;
}

std::vector<std::string> texts_of(const Cells& cells, CellText asked) {
    std::vector<std::string> texts;
    if (asked == CellText::none) return texts;
    for (std::size_t i = 0; i < cells.means.size(); ++i) {
        const double mean = cells.means.values()[i];
        const std::string count = fmt::format("{:g}", cells.counts.values()[i]);
        if (!std::isfinite(mean)) {
            texts.emplace_back();
        } else if (asked == CellText::count) {
            texts.push_back(count);
        } else {
            std::string value = number_text(mean, "{:#.3g}");  // 2.40
            if (value.ends_with('.')) value.pop_back();
            texts.push_back(asked == CellText::value ? value
                                                     : fmt::format("{}\n({})", value, count));
        }
    }
    return texts;
}

/// As many even parts of a palette as there are classes.
Palette classes_of(const Palette& palette, std::size_t classes) {
    Palette parts{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t part = i * classes / parts.size();
        parts[i] = palette[(2 * part + 1) * (palette.size() - 1) / (2 * classes)];
    }
    return parts;
}

/// "flat below 0.1, ripples from 0.1, dunes from 0.3 m".
std::string classes_text(const ChartSettings& chart, const std::string& unit) {
    std::string text = fmt::format("{} below {:g}", chart.classes[0], chart.levels[0]);
    for (std::size_t i = 0; i < chart.levels.size(); ++i)
        text += fmt::format(", {} from {:g}", chart.classes[i + 1], chart.levels[i]);
    return unit.empty() ? text : fmt::format("{} {}", text, unit_word(unit));
}

void add_lines(HeatMap& map, const PanelSettings& settings, const Values& values,
               std::vector<std::string>& remarks, const std::string& unit) {
    const std::string of = unit.empty() ? "" : fmt::format(" {}", unit_word(unit));
    const auto add = [&](const std::vector<double>& levels, const std::string& remark) {
        const std::size_t before = map.lines.size();
        for (const double level : levels) {
            std::vector<ContourLine> lines = cell_lines(map.values, level);
            map.lines.insert(map.lines.end(), lines.begin(), lines.end());
        }
        if (map.lines.size() > before) remarks.push_back(remark + of);
    };
    const std::vector<double>& levels = settings.chart.levels;
    if (!levels.empty() && settings.chart.classes.empty())  // classes part cell by cell
        add(levels, phrase("lines at {}", fmt::format("{:g}", fmt::join(levels, ", "))));
    const bool every = !settings.contours.is_word() || settings.contours.word != "none";
    if (every && values && values->second > values->first) {
        constexpr int most = 8;
        constexpr double most_levels = 100.0;
        const double interval = settings.contours.is_word()
                                    ? contour_interval(values->first, values->second, most)
                                    : settings.contours.value;
        if ((values->second - values->first) / interval > most_levels)
            throw InputError(fmt::format("contours every {:g} would be more than {:g} levels",
                                         interval, most_levels));
        std::vector<double> multiples;
        for (double k = std::ceil(values->first / interval); k * interval <= values->second;
             k += 1.0)
            multiples.push_back(k * interval);
        add(multiples, phrase("lines every {}", fmt::format("{:g}", interval)));
    }
    map.name_lines = settings.chart.cell_text == CellText::none;
}

void add_count_remarks(std::vector<std::string>& remarks, const Cells& cells,
                       const ChartSettings& chart) {
    double fewest = INFINITY;
    double most = 0.0;
    std::size_t empty = 0;
    for (std::size_t i = 0; i < cells.means.size(); ++i) {
        if (!std::isfinite(cells.means.values()[i])) {
            ++empty;
            continue;
        }
        fewest = std::min(fewest, cells.counts.values()[i]);
        most = std::max(most, cells.counts.values()[i]);
    }
    std::string text = fewest < most ? phrase("n = {} to {} in a cell", fewest, most)
                                     : phrase("n = {} in each cell", most);
    if (chart.cell_text == CellText::value) text += word("; numbers are means");
    if (chart.cell_text == CellText::count) text += word("; numbers are n");
    if (chart.cell_text == CellText::value_and_count) text += word("; numbers are means (and n)");
    remarks.push_back(text);
    if (empty > 0)
        remarks.push_back(
            phrase("{} of {} cells are without a value (crossed)", empty, cells.means.size()));
}

std::string csv_of(const CurveSettings& settings, const Table& table, const AxisCategories& x,
                   const AxisCategories& y, const Cells& cells) {
    const auto heading = [&](const std::string& name, bool with_unit) {
        const std::string& unit = table.find(name)->unit;
        return unit.empty() || !with_unit ? name : fmt::format("{} ({})", name, unit);
    };
    std::string text =
        csv_line({heading(settings.x, settings.scale_x == 1.0),
                  heading(settings.y, settings.scale_y == 1.0), heading(settings.z, true), "runs"});
    const auto place = [](const AxisCategories& places, std::size_t i) {
        return places.values.empty() ? places.names[i] : fmt::format("{}", places.values[i]);
    };
    for (std::size_t row = 0; row < y.names.size(); ++row) {
        for (std::size_t column = 0; column < x.names.size(); ++column) {
            const std::size_t cell = row * x.names.size() + column;
            text +=
                csv_line({place(x, column), place(y, row), csv_number(cells.means.values()[cell]),
                          fmt::format("{:g}", cells.counts.values()[cell])});
        }
    }
    return text;
}

HeatAxis axis_of(const AxisCategories& places, const PanelSettings& settings, bool logarithmic,
                 const std::string& label) {
    const bool even = settings.chart.even_cells || places.values.empty();
    if (logarithmic && !places.values.empty() && !(places.values.front() > 0.0))
        throw InputError("a logarithmic axis takes only values above 0");
    HeatAxis axis =
        even ? even_axis(places.names) : value_axis(places.values, places.names, logarithmic);
    axis.label = label;
    return axis;
}

ColourScale colours_of(const PanelSettings& settings, const Scene& scene, const Grid& means) {
    std::vector<double> known;
    std::ranges::copy_if(means.values(), std::back_inserter(known),
                         [](double mean) { return std::isfinite(mean); });
    std::ranges::sort(known);
    return chart_colours(settings, scene, known);
}

MadePanel heat_map_of(const CurvePlan& curve, const PanelSettings& settings,
                      const PanelTools& tools) {
    const CurveSettings& asked = curve.settings;
    const Table table = curve_table(curve, tools.runs, tools.store);
    const TableRows rows = chosen_rows(table, asked);
    const TableColumn& x_column = *table.find(asked.x);
    const TableColumn& y_column = *table.find(asked.y);
    const TableColumn& z_column = *table.find(asked.z);
    const AxisCategories x = categories_of(x_column, rows, 0.0, asked.scale_x);
    const AxisCategories y = categories_of(y_column, rows, asked.offset_y, asked.scale_y);
    constexpr std::size_t most_cells = 100'000;
    if (x.names.size() * y.names.size() > most_cells)
        throw InputError(fmt::format("a heat map has up to {} cells, and these are {} × {}",
                                     most_cells, x.names.size(), y.names.size()));
    const bool any = !x.names.empty() && !y.names.empty();
    const Cells cells = any ? cells_of(curve, table, rows, x, y) : Cells{Grid(1, 1), Grid(1, 1)};
    const Values values = any ? values_of(cells.means) : std::nullopt;
    if (!values) throw InputError("no row has x, y and a number in z and meets the conditions");
    const ChartSettings& chart = settings.chart;
    HeatMap map;
    map.x = axis_of(x, settings, settings.x_logarithmic,
                    axis_label(settings.x_label, asked.x, x_column.unit));
    map.y = axis_of(y, settings, settings.y_logarithmic,
                    axis_label(settings.y_label, asked.y, y_column.unit));
    map.values = cells.means;
    map.texts = texts_of(cells, chart.cell_text);
    map.colours = colours_of(settings, tools.plan.scene, cells.means);
    map.bar = settings.colour_bar ? BarPosition::right : BarPosition::none;
    MadePanel made;
    if (chart.classes.empty()) {
        map.colours.label = label_or(settings.bar_label, quantity_in_words(asked.z, z_column.unit));
        mark_range_ends(map.colours, values);
        if (!chart.share_colours) made.remarks.push_back(range_sentence(map.colours, values));
    } else {
        map.bounds = chart.levels;
        map.colours.classes = chart.classes;
        map.colours.palette = classes_of(map.colours.palette, chart.classes.size());
        map.colours.label = settings.bar_label;
        made.remarks.push_back(phrase("colours by {}: {}", name_in_words(asked.z),
                                      classes_text(chart, z_column.unit)));
    }
    add_lines(map, settings, values, made.remarks, z_column.unit);
    add_count_remarks(made.remarks, cells, chart);
    made.data.push_back({"-1.csv", csv_of(asked, table, x, y, cells)});
    const auto range_of = [](const HeatAxis& axis) {
        return fmt::format("{}: {} at {}", axis.label, fmt::join(axis.names, ", "),
                           fmt::join(axis.middles, ", "));
    };
    const std::string x_range = range_of(map.x);
    const std::string y_range = range_of(map.y);
    auto content = std::make_unique<HeatMapPanel>(std::move(map));
    if (chart.share_axes) made.axes = {&content->x_axis(), &content->y_axis(), x_range, y_range};
    if (chart.share_colours && chart.classes.empty())
        made.shared = {&content->colours(), &content->colour_bar(), values};
    made.content = std::move(content);
    return made;
}

std::vector<MadePanel> make_heat_maps(const PanelSubject& subject, PanelTools& tools) {
    const CurvePlan& curve = subject.panel.curves.front();
    std::vector<MadePanel> made;
    try {
        made.push_back(heat_map_of(curve, subject.panel.settings, tools));
    } catch (const InputError& fault) {
        throw placed(tools.plan.scene.at(curve.path + ".z"), fault);
    }
    return made;
}

}  // namespace

const PanelMaker panels::heat_map{nullptr, make_heat_maps};

}  // namespace fumon
