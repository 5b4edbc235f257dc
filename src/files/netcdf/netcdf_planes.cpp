#include "files/netcdf/netcdf_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "files/netcdf/netcdf_cells.h"

namespace fumon {

namespace {

/// Whether a variable is over a bed's y and x, and over others only of length 1.
bool is_plane(const NetcdfInput& input, int variable, const BedVariable& bed) {
    const std::vector<int> over = input.dimensions(variable);
    const auto has = [&](int dimension) { return std::ranges::count(over, dimension) == 1; };
    return variable != bed.variable && input.is_numeric(variable) && has(bed.x) && has(bed.y) &&
           std::ranges::all_of(over, [&](int dimension) {
               return dimension == bed.x || dimension == bed.y ||
                      input.dimension_length(dimension) == 1;
           });
}

std::optional<int> find_plane(const NetcdfInput& input, const BedVariable& bed,
                              bool (*says)(const NetcdfInput&, int)) {
    for (int variable = 0; variable < input.variables(); ++variable) {
        if (is_plane(input, variable, bed) && says(input, variable)) return variable;
    }
    return std::nullopt;
}

/// Whether all rows (or columns, of the turned plane) repeat the first within a twentieth of a
/// cell.
bool repeats(const Grid& plane, bool along_rows) {
    const int count = along_rows ? plane.nx() : plane.ny();
    const int others = along_rows ? plane.ny() : plane.nx();
    const auto at = [&](int k, int other) {
        return along_rows ? plane(k, other) : plane(other, k);
    };
    const double cell = count > 1 ? std::abs(at(count - 1, 0) - at(0, 0)) / (count - 1) : 0.0;
    for (int other = 1; other < others; ++other) {
        for (int k = 0; k < count; ++k) {
            const double off = std::abs(at(k, other) - at(k, 0));
            if (!(off <= evenness * cell || (count == 1 && off == 0.0))) return false;
        }
    }
    return true;
}

}  // namespace

std::optional<std::pair<NetcdfAxis, NetcdfAxis>> axes_of_planes(const NetcdfInput& input,
                                                                const BedVariable& bed) {
    const auto eastward = find_plane(input, bed, is_eastward_variable);
    const auto northward = find_plane(input, bed, is_northward_variable);
    if (!eastward || !northward) return std::nullopt;
    (void)input.values_over(std::vector<int>{bed.y, bed.x});
    const Grid x = read_plane(input, *eastward, bed.y, bed.x);
    const Grid y = read_plane(input, *northward, bed.y, bed.x);
    if (!repeats(x, true) || !repeats(y, false)) {
        input.refuse(
            fmt::format("{} lies on a rotated or curvilinear grid: {} and {} differ along both of "
                        "its sides",
                        bed.name, input.variable_name(*eastward), input.variable_name(*northward)),
            "interpolate it to a regular grid first (cdo remapbil, gdalwarp or xESMF)");
    }
    std::vector<double> columns(static_cast<std::size_t>(x.nx()));
    std::vector<double> rows(static_cast<std::size_t>(y.ny()));
    for (int k = 0; k < x.nx(); ++k) columns[static_cast<std::size_t>(k)] = x(k, 0);
    for (int k = 0; k < y.ny(); ++k) rows[static_cast<std::size_t>(k)] = y(0, k);
    return std::pair(netcdf_axis(input, *eastward, std::move(columns)),
                     netcdf_axis(input, *northward, std::move(rows)));
}

}  // namespace fumon
