#include "wind/wind_rose.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"
#include "files/csv_table.h"
#include "wind/direction.h"

namespace fumon {

namespace {

constexpr double metres_per_second_per_knot = 1852.0 / 3600.0;
constexpr double highest_speed = 150.0;             // m/s
constexpr double highest_friction_velocity = 10.0;  // m/s
constexpr double largest_number = 1e12;
constexpr double rounding_of_shares = 1e-3;  // a table's frequencies are rounded

constexpr std::string_view header_help =
    "the header is direction,speed,frequency (or speed_knots or friction_velocity; percent or "
    "hours), or direction,flux";

const TableColumn& column_of(const TextSource& source, const Table& table, std::string_view name) {
    if (const TableColumn* found = table.find(name)) return *found;
    throw InputError(fmt::format("{}: has no column \"{}\"; {}", source.name, name, header_help));
}

/// The share of the time of each row.
std::vector<double> shares(const TextSource& source, const Table& table) {
    const auto given = std::ranges::count_if(table.columns, [](const TableColumn& column) {
        return column.name == "frequency" || column.name == "percent" || column.name == "hours";
    });
    if (given > 1)
        throw InputError(fmt::format(
            "{}: frequency, percent and hours give the same quantity; keep one", source.name));
    std::vector<double> values(table.rows(), 1.0);
    double whole = static_cast<double>(table.rows());
    if (const TableColumn* frequency = table.find("frequency")) {
        values = numbers_of(source, table, *frequency, 0.0, 1.0);
        whole = 1.0;
    } else if (const TableColumn* percent = table.find("percent")) {
        constexpr double all = 100.0;
        values = numbers_of(source, table, *percent, 0.0, all);
        whole = all;
    } else if (const TableColumn* hours = table.find("hours")) {
        values = numbers_of(source, table, *hours, 0.0, largest_number);
        whole = 0.0;
        for (const double value : values) whole += value;
    }
    double sum = 0.0;
    for (double& value : values) sum += value /= whole;
    if (sum > 1.0 + rounding_of_shares)
        throw InputError(
            fmt::format("{}: the winds blow for {:.1f} % of the time, which is more than 100 % "
                        "(hours may be given instead)",
                        source.name, 100.0 * sum));
    return values;
}

/// A direction from 0 up to 360.
double direction_of(double degrees) {
    return degrees >= full_turn ? degrees - full_turn : degrees;
}

}  // namespace

WindTable read_wind_table(const TextSource& source) {
    const Table table = parse_csv_table(source, {{}, std::string(header_help)});
    for (const TableColumn& column : table.columns) {
        constexpr std::array<std::string_view, 8> known{
            "direction", "speed",   "speed_knots", "friction_velocity",
            "frequency", "percent", "hours",       "flux"};
        if (std::ranges::find(known, column.name) == known.end())
            throw InputError(
                fmt::format("{}: column {}: {}", source.name, shown(column.name), header_help));
    }
    const std::vector<double>& from =
        numbers_of(source, table, column_of(source, table, "direction"), 0.0, full_turn);
    const bool in_knots = table.find("speed_knots") != nullptr;
    const bool of_friction = table.find("friction_velocity") != nullptr;
    const TableColumn* flux = table.find("flux");
    if (flux != nullptr && table.columns.size() > 2)
        throw InputError(
            fmt::format("{}: a table with flux has no column beside direction", source.name));
    if (in_knots && table.find("speed") != nullptr)
        throw InputError(
            fmt::format("{}: speed and speed_knots give the same quantity; keep one", source.name));
    if (of_friction && (in_knots || table.find("speed") != nullptr))
        throw InputError(fmt::format(
            "{}: speed and friction_velocity give the same quantity; keep one", source.name));
    WindTable read;
    if (flux != nullptr) {
        const std::vector<double>& amounts = numbers_of(source, table, *flux, 0.0, largest_number);
        for (std::size_t row = 0; row < amounts.size(); ++row) {
            if (amounts[row] > 0.0)
                read.fluxes.push_back({opposite(direction_of(from[row])), amounts[row]});
        }
    } else {
        const double unit = in_knots ? metres_per_second_per_knot : 1.0;
        const char* column = of_friction ? "friction_velocity" : in_knots ? "speed_knots" : "speed";
        const std::vector<double>& speeds =
            numbers_of(source, table, column_of(source, table, column), 0.0,
                       of_friction ? highest_friction_velocity : highest_speed / unit);
        const std::vector<double> share = shares(source, table);
        for (std::size_t row = 0; row < speeds.size(); ++row) {
            if (speeds[row] == 0.0 || share[row] == 0.0) continue;
            const double speed = speeds[row] * unit;
            read.rose.push_back({direction_of(from[row]), of_friction ? 0.0 : speed, share[row],
                                 of_friction ? speed : 0.0});
        }
    }
    if (read.rose.empty() && read.fluxes.empty())
        throw InputError(fmt::format("{}: no wind blows in this table", source.name));
    return read;
}

}  // namespace fumon
