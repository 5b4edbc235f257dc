#include "foreign/mesh_maps.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/limits.h"
#include "base/number_text.h"
#include "files/netcdf/netcdf_cells.h"
#include "foreign/netcdf_times.h"

namespace fumon {

namespace {

/// A variable over nodes or faces, and over records at most; nothing for any other.
std::optional<ForeignMap> mesh_map(const NetcdfInput& input, const MeshLayout& mesh, int variable) {
    if (!input.is_numeric(variable) || variable == mesh.node_x || variable == mesh.node_y ||
        variable == mesh.connectivity)
        return std::nullopt;
    ForeignMap map;
    map.variable.variable = variable;
    map.variable.name = input.variable_name(variable);
    int place = -1;
    for (const int dimension : input.dimensions(variable)) {
        map.dimensions += (map.dimensions.empty() ? "" : ", ") + input.dimension_name(dimension);
        const bool of_mesh = dimension == mesh.faces || dimension == mesh.nodes;
        if (of_mesh && place >= 0) return std::nullopt;
        if (of_mesh) {
            place = dimension;
        } else if (input.dimension_length(dimension) != 1 || map.variable.records < 0) {
            if (map.variable.records >= 0 && input.dimension_length(map.variable.records) != 1)
                return std::nullopt;
            map.variable.records = dimension;
        }
    }
    if (place < 0) return std::nullopt;
    map.variable.x = map.variable.y = place;
    map.side = input.dimension_name(place);
    map.variable.has_records = map.variable.records >= 0;
    map.place = place == mesh.faces ? MapPlace::faces : MapPlace::nodes;
    map.standard_name = input.text(variable, "standard_name").value_or("");
    map.unit = input.text(variable, "units").value_or("");
    map.positive = input.text(variable, "positive").value_or("");
    // Models call their mesh what they like, and its variables after it.
    const std::string prefix = mesh.name + "_";
    const bool after_mesh = !mesh.name.empty() && map.variable.name.starts_with(prefix);
    map.known_as =
        after_mesh ? "mesh2d_" + map.variable.name.substr(prefix.size()) : map.variable.name;
    return map;
}

bool is_coordinate(const ForeignMap& map) {
    return map.standard_name.ends_with("_x_coordinate") ||
           map.standard_name.ends_with("_y_coordinate") || map.standard_name == "longitude" ||
           map.standard_name == "latitude";
}

struct Unpacking {
    double factor = 1.0;
    double offset = 0.0;
};

Unpacking unpacking_of(const NetcdfInput& input, int variable) {
    const auto factors = input.numbers(variable, "scale_factor");
    const auto offsets = input.numbers(variable, "add_offset");
    return {factors.empty() ? 1.0 : factors.front(), offsets.empty() ? 0.0 : offsets.front()};
}

/// Half the median edge, or what makes four million cells.
double default_cell(const FaceMesh& mesh, double width, double height) {
    constexpr double most_cells = 4e6;
    return std::max(cell_of_edges(mesh), std::sqrt(width * height / most_cells));
}

}  // namespace

int records_of_mesh(const NetcdfInput& input, const MeshLayout& mesh) {
    std::map<int, std::size_t> counts;
    for (int variable = 0; variable < input.variables(); ++variable) {
        const auto map = mesh_map(input, mesh, variable);
        if (!map || !map->variable.has_records || map->variable.records == mesh.corners) continue;
        constexpr std::size_t of_time = 1'000'000;  // more than any file has maps
        const bool of_times = time_variable(input, map->variable.records) ||
                              input.dimension_name(map->variable.records) == "time";
        counts[map->variable.records] += of_times ? of_time : 1;
    }
    const auto most =
        std::ranges::max_element(counts, {}, &std::pair<const int, std::size_t>::second);
    return most == counts.end() ? -1 : most->first;
}

std::vector<ForeignMap> maps_of_mesh(const NetcdfInput& input, const MeshLayout& mesh,
                                     int records) {
    std::vector<ForeignMap> maps;
    for (int variable = 0; variable < input.variables(); ++variable) {
        auto map = mesh_map(input, mesh, variable);
        if (!map || is_coordinate(*map)) continue;
        map->over_time = map->variable.has_records && map->variable.records == records;
        if (map->variable.has_records && !map->over_time &&
            input.dimension_length(map->variable.records) != 1)
            continue;
        maps.push_back(*std::move(map));
    }
    return maps;
}

RawTimes times_of_mesh(const NetcdfInput& input, const MeshLayout& mesh, int records,
                       const std::string& unit) {
    RawTimes times = netcdf_times(input, records, {}, mesh.anuga ? "s" : unit);
    const auto variable = time_variable(input, records);
    if (!mesh.anuga || !variable || !input.text(*variable, "units").value_or("").empty())
        return times;
    const auto start = input.numbers(NC_GLOBAL, "starttime");
    constexpr double first_date = 1e8;  // seconds since 1970; below, a start on no date
    constexpr double last_date = 1e11;
    if (!start.empty() && start.front() > first_date && start.front() < last_date)
        times.origin = static_cast<std::int64_t>(start.front());
    return times;
}

std::vector<double> LaidMesh::values(const NetcdfInput& input, const ForeignMap& map,
                                     std::size_t record) const {
    const auto variable = input.find_variable(map.variable.name);
    const bool of_faces = map.place == MapPlace::faces;
    const std::size_t wanted = of_faces ? faces : nodes;
    std::vector<std::size_t> start;
    std::vector<std::size_t> count;
    std::size_t length = 0;
    if (variable && input.is_numeric(*variable)) {
        for (const int dimension : input.dimensions(*variable)) {
            const std::string name = input.dimension_name(dimension);
            const bool along_mesh =
                length == 0 && name == map.side && input.dimension_length(dimension) == wanted;
            if (along_mesh) length = wanted;
            start.push_back(along_mesh || input.dimension_length(dimension) == 1 ? 0 : record);
            count.push_back(along_mesh ? wanted : 1);
        }
    }
    if (length != wanted)
        input.refuse(fmt::format("has no {} for the {} {} of the first file", map.variable.name,
                                 with_commas(static_cast<std::int64_t>(wanted)),
                                 of_faces ? "faces" : "nodes"),
                     "all files of a run need the same mesh; join partitions first (dfmoutput "
                     "mapmerge)");
    std::vector<double> numbers(wanted);
    check_netcdf(
        nc_get_vara_double(input.id(), *variable, start.data(), count.data(), numbers.data()));
    const MissingValues missing = missing_values(input, *variable);
    const Unpacking unpacking = unpacking_of(input, *variable);
    for (double& number : numbers)
        number = missing.holds(number) ? std::numeric_limits<double>::quiet_NaN()
                                       : number * unpacking.factor + unpacking.offset;
    return numbers;
}

Grid LaidMesh::laid(const ForeignMap& map, std::span<const double> values) const {
    return map.place == MapPlace::faces ? grid.of_faces(values) : grid.of_nodes(values);
}

std::shared_ptr<const LaidMesh> lay_mesh(const NetcdfInput& input, const MeshLayout& mesh,
                                         double cell) {
    PlacedMesh placed = read_mesh(input, mesh);
    const double width = *std::ranges::max_element(placed.mesh.x);
    const double height = *std::ranges::max_element(placed.mesh.y);
    const bool chosen = !(cell > 0.0);
    const double of_edges = cell_of_edges(placed.mesh);
    if (chosen) cell = default_cell(placed.mesh, width, height);
    const double columns = width / cell;
    const double rows = height / cell;
    if (!(std::max(columns, 1.0) * std::max(rows, 1.0) <= static_cast<double>(largest_grid_cells)))
        input.refuse(fmt::format("its mesh of {:.6g} x {:.6g} m on cells of {:g} m makes more than "
                                 "{} cells",
                                 width, height, cell, largest_grid_cells),
                     "take a larger --cell-size");
    const std::size_t nodes = placed.mesh.x.size();
    const std::size_t faces = placed.mesh.faces();
    auto laid = std::make_shared<LaidMesh>(
        LaidMesh{MeshGrid(std::move(placed.mesh), cell), nodes, faces, {}});
    laid->scale = {cell, cell, 1.0, true};
    laid->scale.place = GeoReference{placed.west, placed.south, cell / placed.metres_per_x,
                                     cell / placed.metres_per_y, placed.degrees};
    std::string why;
    if (chosen)
        why = cell > of_edges ? ", so that there are four million at most (--cell-size)"
                              : ", half the mesh's median edge (--cell-size)";
    laid->notes.push_back(fmt::format("{} faces on {} nodes, laid on {} x {} cells of {:.6g} m{}",
                                      with_commas(static_cast<std::int64_t>(faces)),
                                      with_commas(static_cast<std::int64_t>(nodes)),
                                      laid->grid.nx(), laid->grid.ny(), cell, why));
    if (!placed.note.empty()) laid->notes.push_back(placed.note);
    return laid;
}

}  // namespace fumon
