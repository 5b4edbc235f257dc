#include "files/netcdf/netcdf_section_record.h"

#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "files/netcdf/netcdf_section.h"

namespace fumon {

namespace {

double spacing(const NetcdfInput& input, int coordinate) {
    const std::size_t second = 1;
    double place = 0.0;
    check_netcdf(nc_get_var1_double(input.id(), coordinate, &second, &place));
    return place;
}

/// One record's values, the last dimension fastest.
std::vector<double> values_of(const NetcdfInput& input, int variable, std::size_t record) {
    const std::vector<int> over = input.dimensions(variable);
    if (over.empty()) return {};
    std::vector<std::size_t> start(over.size(), 0);
    std::vector<std::size_t> count{1};
    start.front() = record;
    for (std::size_t i = 1; i < over.size(); ++i) count.push_back(input.dimension_length(over[i]));
    std::vector<double> values(input.values_over(std::span(over).subspan(1)));
    if (values.empty()) return values;
    check_netcdf(
        nc_get_vara_double(input.id(), variable, start.data(), count.data(), values.data()));
    return values;
}

Grid grid_of(const std::vector<double>& values, std::size_t nx) {
    Grid grid(static_cast<int>(nx), static_cast<int>(values.size() / nx));
    std::ranges::copy(values, grid.values().begin());
    return grid;
}

std::vector<GrainPath> read_paths(const NetcdfInput& input, std::size_t record) {
    const auto launch_angle = input.find_variable("launch_angle");
    const auto path_x = input.find_variable("path_x");
    const auto path_z = input.find_variable("path_z");
    if (!launch_angle || !path_x || !path_z) return {};
    const std::vector<double> x = values_of(input, *path_x, record);
    const std::vector<double> z = values_of(input, *path_z, record);
    std::vector<GrainPath> paths;
    for (const double angle : values_of(input, *launch_angle, record))
        paths.push_back({angle, {}, {}});
    const std::size_t points = paths.empty() ? 0 : std::min(x.size(), z.size()) / paths.size();
    for (std::size_t path = 0; path < paths.size(); ++path) {
        for (std::size_t i = path * points; i < (path + 1) * points && !std::isnan(x[i]); ++i) {
            paths[path].x.push_back(x[i]);
            paths[path].z.push_back(z[i]);
        }
    }
    return paths;
}

}  // namespace

std::shared_ptr<const SnapshotSection> read_section(const NetcdfInput& input, std::size_t record) {
    const auto x = input.find_variable("section_x");
    const auto z = input.find_variable("z");
    if (!x || !z || input.dimensions(*x).size() != 1 || input.dimensions(*z).size() != 1)
        return nullptr;
    const int along = input.dimensions(*x).front();
    const int up = input.dimensions(*z).front();
    auto section = std::make_shared<SnapshotSection>();
    section->dx = spacing(input, *x);
    section->dz = spacing(input, *z);
    for (int variable = 0; variable < input.variables(); ++variable) {
        const std::vector<int> over = input.dimensions(variable);
        const bool is_field = over.size() == 3 && over[1] == up && over[2] == along;
        const bool is_curve = over.size() == 2 && over[1] == along;
        if (!is_field && !is_curve) continue;
        const std::string name =
            input.text(variable, own_name_attribute)
                .value_or(section_name_in_snapshot(input.variable_name(variable)));
        const std::string long_name = input.text(variable, "long_name").value_or(name);
        const std::string unit = input.text(variable, "units").value_or("1");
        std::vector<double> values = values_of(input, variable, record);
        if (is_curve) {
            section->curves.push_back({name, long_name, unit, std::move(values)});
        } else {
            section->fields.push_back(
                {name, long_name, unit, grid_of(values, input.dimension_length(along))});
        }
    }
    if (section->fields.empty()) return nullptr;
    section->paths = read_paths(input, record);
    return section;
}

}  // namespace fumon
