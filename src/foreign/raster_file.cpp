#include "foreign/raster_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "files/input_file.h"
#include "files/terrain/terrain_file.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view blanks = " \t,;\r";
constexpr std::string_view of_numbers = "0123456789+-.eEnNaA \t,;\r\n";

/// The numbers of a line.
void read_line(std::string_view line, const fs::path& file, std::size_t number,
               std::vector<double>& values) {
    while (true) {
        const std::size_t begin = line.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return;
        line.remove_prefix(begin);
        double value = 0.0;
        const char* const text = line.data() + (line.front() == '+' ? 1 : 0);
        const auto [end, fault] = std::from_chars(text, line.data() + line.size(), value);
        if (fault != std::errc{})
            throw InputError(fmt::format("{}:{}: \"{}\" is not a number", file.string(), number,
                                         line.substr(0, line.find_first_of(blanks))));
        values.push_back(value);
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    }
}

Grid read_matrix(const fs::path& file) {
    const std::string text = read_input_file(file);
    std::vector<double> values;
    std::size_t columns = 0;
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::size_t before = values.size();
        read_line(std::string_view(text).substr(at, end - at), file, ++number, values);
        const std::size_t found = values.size() - before;
        if (columns == 0) columns = found;
        if (found != 0 && found != columns)
            throw InputError(fmt::format("{}:{}: the line has {} numbers, those before it {}",
                                         file.string(), number, found, columns));
        if (values.size() > static_cast<std::size_t>(largest_grid_cells))
            throw InputError(fmt::format("{}: has more than {} numbers; at most that many are read",
                                         file.string(), largest_grid_cells));
        at = end + 1;
    }
    const std::size_t rows = columns == 0 ? 0 : values.size() / columns;
    Grid grid(static_cast<int>(columns), static_cast<int>(rows));
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column)
            grid(static_cast<int>(column), static_cast<int>(rows - 1 - row)) =
                values[row * columns + column];
    }
    return grid;
}

}  // namespace

bool is_bare_matrix(const fs::path& file) {
    constexpr std::size_t looked_at = 512;
    const std::string start = start_of_input_file(file, looked_at);
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    if (first == std::string::npos || start.find_first_not_of(of_numbers) != std::string::npos)
        return false;
    return start[first] == '-' || start[first] == '+' || start[first] == '.' ||
           (start[first] >= '0' && start[first] <= '9');
}

RasterFile read_raster_file(const fs::path& file, const std::string& variable, Quantity quantity,
                            double cell_size) {
    RasterFile raster;
    if (cell_size > 0.0) raster.scale = {cell_size, cell_size, 1.0, true};
    if (is_bare_matrix(file)) {
        raster.values = read_matrix(file);
        return raster;
    }
    TerrainQuery query;
    query.variable = variable;
    const std::string_view unit = facts_of(quantity).unit;
    query.any_unit = unit != "m" || quantity == Quantity::depth;
    if (query.any_unit) query.wanted_unit = unit;
    Terrain terrain = read_terrain(file, query);
    raster.values = std::move(terrain.heights);
    for (std::size_t i = 0; i < terrain.nodata.size(); ++i)
        if (terrain.nodata.values()[i] != 0)
            raster.values.values()[i] = std::numeric_limits<double>::quiet_NaN();
    if (terrain.dx > 0.0) raster.scale = {terrain.dx, terrain.dy, 1.0, true};
    raster.scale.place = std::move(terrain.place);
    raster.note = std::move(terrain.note);
    return raster;
}

}  // namespace fumon
