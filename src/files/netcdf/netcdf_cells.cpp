#include "files/netcdf/netcdf_cells.h"

#include <netcdf.h>

#include <algorithm>
#include <cmath>

namespace fumon {

namespace {

/// The default fill value of a type, as a double; none for bytes, which use every value.
std::vector<double> default_fill(int type) {
    switch (type) {
        case NC_SHORT:
            return {NC_FILL_SHORT};
        case NC_USHORT:
            return {NC_FILL_USHORT};
        case NC_INT:
            return {NC_FILL_INT};
        case NC_UINT:
            return {NC_FILL_UINT};
        case NC_INT64:
            return {static_cast<double>(NC_FILL_INT64)};
        case NC_UINT64:
            return {static_cast<double>(NC_FILL_UINT64)};
        case NC_FLOAT:
            return {static_cast<double>(NC_FILL_FLOAT)};
        case NC_DOUBLE:
            return {NC_FILL_DOUBLE};
        default:
            return {};
    }
}

/// How many numbers a signed integer's type has where `_Unsigned` says that it has no sign; else 0.
double wrap_of(const NetcdfInput& input, int variable) {
    const std::string flag = input.text(variable, "_Unsigned").value_or("");
    if (flag != "true" && flag != "True" && flag != "TRUE") return 0.0;
    switch (input.type(variable)) {
        case NC_BYTE:
            return 0x1p8;
        case NC_SHORT:
            return 0x1p16;
        case NC_INT:
            return 0x1p32;
        default:
            return 0.0;
    }
}

/// The values of one plane of a variable; `record` along `records`, 0 along all others.
Grid read_values(const NetcdfInput& input, int variable, int y, int x, int records,
                 std::size_t record, const ValuesReader& read = {}) {
    const std::vector<int> over = input.dimensions(variable);
    std::vector<std::size_t> start(over.size(), 0);
    std::vector<std::size_t> count(over.size(), 1);
    bool columns_first = false;
    bool y_seen = false;
    for (std::size_t k = 0; k < over.size(); ++k) {
        if (over[k] == records) start[k] = record;
        if (over[k] != x && over[k] != y) continue;
        count[k] = input.dimension_length(over[k]);
        if (over[k] == x) columns_first = !y_seen;
        y_seen = y_seen || over[k] == y;
    }
    const auto nx = static_cast<int>(input.dimension_length(x));
    const auto ny = static_cast<int>(input.dimension_length(y));
    Grid values(columns_first ? ny : nx, columns_first ? nx : ny);
    if (read) {
        read(start, count, values.data());
    } else {
        check_netcdf(
            nc_get_vara_double(input.id(), variable, start.data(), count.data(), values.data()));
    }
    const double wrap = wrap_of(input, variable);
    for (double& value : values.values()) {
        if (wrap > 0.0 && value < 0.0) value += wrap;
    }
    if (!columns_first) return values;
    Grid turned(nx, ny);
    for (int row = 0; row < ny; ++row) {
        for (int column = 0; column < nx; ++column) turned(column, row) = values(row, column);
    }
    return turned;
}

constexpr int no_dimension = -1;

}  // namespace

bool MissingValues::holds(double raw) const {
    if (std::isnan(raw) || raw < lowest || raw > highest) return true;
    return std::find(values.begin(), values.end(), raw) != values.end();
}

MissingValues missing_values(const NetcdfInput& input, int variable) {
    const int type = input.type(variable);
    const double wrap = wrap_of(input, variable);
    const auto numbers = [&](const char* attribute) {
        std::vector<double> values = input.numbers(variable, attribute);
        for (double& value : values) {
            if (wrap > 0.0 && value < 0.0) value += wrap;
            constexpr double largest = std::numeric_limits<float>::max();
            if (type == NC_FLOAT && std::abs(value) <= largest)
                value = static_cast<double>(static_cast<float>(value));
        }
        return values;
    };
    MissingValues missing{numbers("_FillValue")};
    if (missing.values.empty()) missing.values = default_fill(type);
    if (wrap > 0.0) {
        for (double& value : missing.values) value += value < 0.0 ? wrap : 0.0;
    }
    for (const double value : numbers("missing_value")) missing.values.push_back(value);
    const auto range = numbers("valid_range");
    const auto low = numbers("valid_min");
    const auto high = numbers("valid_max");
    if (range.size() == 2) {
        missing.lowest = range[0];
        missing.highest = range[1];
    }
    if (low.size() == 1) missing.lowest = low[0];
    if (high.size() == 1) missing.highest = high[0];
    return missing;
}

Grid read_cells(const NetcdfInput& input, const BedVariable& bed, const ValuesReader& values) {
    return read_values(input, bed.variable, bed.y, bed.x, bed.records, bed.record, values);
}

Grid read_plane(const NetcdfInput& input, int variable, int y, int x) {
    return read_values(input, variable, y, x, no_dimension, 0);
}

}  // namespace fumon
