#include "foreign/mesh/mesh_file.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "files/netcdf/netcdf_cells.h"
#include "files/terrain/geographic.h"
#include "files/unit_conversion.h"

namespace fumon {

namespace {

int named_variable(const NetcdfInput& input, const std::string& mesh, const std::string& name) {
    if (const auto found = input.find_variable(name)) return *found;
    input.refuse(fmt::format("its mesh {} names the variable \"{}\", which it has not", mesh, name),
                 "is it a copy of some variables only? copy all of them");
}

/// The mesh of a topology variable; nothing for one of lines.
std::optional<MeshLayout> ugrid_mesh(const NetcdfInput& input, int topology) {
    MeshLayout layout;
    layout.name = input.variable_name(topology);
    const std::string faces = input.text(topology, "face_node_connectivity").value_or("");
    if (faces.empty()) return std::nullopt;
    std::istringstream coordinates(input.text(topology, "node_coordinates").value_or(""));
    std::string x;
    std::string y;
    coordinates >> x >> y;
    if (y.empty())
        input.refuse(fmt::format("its mesh {} has no node_coordinates", layout.name),
                     "UGRID needs the names of two variables there");
    layout.node_x = named_variable(input, layout.name, x);
    layout.node_y = named_variable(input, layout.name, y);
    layout.connectivity = named_variable(input, layout.name, faces);
    const std::vector<int> over = input.dimensions(layout.connectivity);
    const std::vector<int> nodes = input.dimensions(layout.node_x);
    if (over.size() != 2 || nodes.size() != 1 || nodes != input.dimensions(layout.node_y))
        input.refuse(fmt::format("its mesh {} is none of UGRID", layout.name),
                     "it takes nodes over one dimension, and faces over two");
    layout.nodes = nodes.front();
    const std::string of_faces = input.text(topology, "face_dimension").value_or("");
    const bool turned = input.dimension_name(over[1]) == of_faces && over[0] != over[1];
    layout.faces = turned ? over[1] : over[0];
    layout.corners = turned ? over[0] : over[1];
    return layout;
}

/// As ANUGA writes its results.
std::optional<MeshLayout> anuga_mesh(const NetcdfInput& input) {
    const auto volumes = input.find_variable("volumes");
    const auto x = input.find_variable("x");
    const auto y = input.find_variable("y");
    if (!volumes || !x || !y || !input.find_variable("stage")) return std::nullopt;
    const std::vector<int> over = input.dimensions(*volumes);
    const std::vector<int> points = input.dimensions(*x);
    if (over.size() != 2 || points.size() != 1 || input.dimensions(*y) != points)
        return std::nullopt;
    MeshLayout layout;
    layout.anuga = true;
    layout.node_x = *x;
    layout.node_y = *y;
    layout.connectivity = *volumes;
    layout.nodes = points.front();
    layout.faces = over[0];
    layout.corners = over[1];
    return layout;
}

std::vector<double> coordinate(const NetcdfInput& input, int variable, int dimension) {
    std::vector<double> values(input.values_over(std::vector<int>{dimension}));
    check_netcdf(nc_get_var_double(input.id(), variable, values.data()));
    const MissingValues missing = missing_values(input, variable);
    for (const double value : values) {
        if (std::isfinite(value) && !missing.holds(value)) continue;
        input.refuse(fmt::format("{} has no value at some nodes", input.variable_name(variable)),
                     "write the coordinates of all nodes");
    }
    return values;
}

/// The number of the first node: as the file says, else 0, or 1 where only that fits.
double first_node(const NetcdfInput& input, int connectivity, const std::vector<double>& numbers,
                  const MissingValues& missing, double nodes) {
    const auto said = input.numbers(connectivity, "start_index");
    if (!said.empty() && std::isfinite(said.front())) return said.front();
    double low = nodes;
    double high = 0.0;
    for (const double number : numbers) {
        if (missing.holds(number) || number < 0.0) continue;
        low = std::min(low, number);
        high = std::max(high, number);
    }
    return low >= 1.0 && high == nodes ? 1.0 : 0.0;
}

/// The nodes of each face. Throws for those that are none.
void read_faces(const NetcdfInput& input, const MeshLayout& layout, FaceMesh& mesh) {
    const std::size_t faces = input.dimension_length(layout.faces);
    const std::size_t corners = input.dimension_length(layout.corners);
    const bool turned = input.dimensions(layout.connectivity).front() == layout.corners;
    std::vector<double> numbers(input.values_over(std::vector<int>{layout.faces, layout.corners}));
    check_netcdf(nc_get_var_double(input.id(), layout.connectivity, numbers.data()));
    const MissingValues missing = missing_values(input, layout.connectivity);
    const auto nodes = static_cast<double>(mesh.x.size());
    const double start = first_node(input, layout.connectivity, numbers, missing, nodes);
    for (std::size_t face = 0; face < faces; ++face) {
        const std::size_t begin = mesh.corners.size();
        for (std::size_t k = 0; k < corners; ++k) {
            const double raw = numbers[turned ? k * faces + face : face * corners + k];
            const double node = raw - start;
            // Corners that a face has not are filled, by some without saying with what.
            if (missing.holds(raw) || node < 0.0) continue;
            if (node >= nodes)
                input.refuse(fmt::format("face {} has the node {:g}, of {:g} nodes that count from "
                                         "{:g}",
                                         face + 1, raw, nodes, start),
                             "its start_index is wrong, or it is cut short");
            const auto number = static_cast<std::int32_t>(node);
            if (mesh.corners.size() > begin && mesh.corners.back() == number) continue;
            mesh.corners.push_back(number);
        }
        if (mesh.corners.size() > begin + 1 && mesh.corners.back() == mesh.corners[begin])
            mesh.corners.pop_back();
        mesh.ends.push_back(mesh.corners.size());
    }
}

double first_or(const std::vector<double>& numbers, double otherwise) {
    return numbers.empty() ? otherwise : numbers.front();
}

void shift(std::vector<double>& values, double from, double factor) {
    for (double& value : values) value = (value - from) * factor;
}

}  // namespace

std::optional<MeshLayout> find_mesh(const NetcdfInput& input) {
    bool of_lines = false;
    for (int variable = 0; variable < input.variables(); ++variable) {
        if (input.text(variable, "cf_role").value_or("") != "mesh_topology") continue;
        if (auto layout = ugrid_mesh(input, variable)) return layout;
        of_lines = true;
    }
    if (of_lines)
        input.refuse("holds a network of lines and no mesh with faces",
                     "name the file of the model's map of two dimensions");
    return anuga_mesh(input);
}

PlacedMesh read_mesh(const NetcdfInput& input, const MeshLayout& layout) {
    PlacedMesh placed;
    FaceMesh& mesh = placed.mesh;
    mesh.x = coordinate(input, layout.node_x, layout.nodes);
    mesh.y = coordinate(input, layout.node_y, layout.nodes);
    read_faces(input, layout, mesh);
    double east = -std::numeric_limits<double>::infinity();
    double north = east;
    placed.west = placed.south = -east;
    for (const std::int32_t node : mesh.corners) {
        const auto at = static_cast<std::size_t>(node);
        placed.west = std::min(placed.west, mesh.x[at]);
        placed.south = std::min(placed.south, mesh.y[at]);
        east = std::max(east, mesh.x[at]);
        north = std::max(north, mesh.y[at]);
    }
    if (!(east > placed.west) || !(north > placed.south))
        input.refuse("its mesh has no face with an area", "is it cut short?");
    const std::string unit = input.text(layout.node_x, "units").value_or("");
    placed.degrees = is_degrees(unit);
    if (placed.degrees) {
        const double middle = 0.5 * (placed.south + north);
        if (std::abs(middle) >= 90.0)
            input.refuse(fmt::format("the middle latitude of its nodes is {:.6g}°", middle),
                         "latitudes lie between -90 and 90");
        const DegreeLengths metres = degree_lengths(middle);
        placed.metres_per_x = metres.east;
        placed.metres_per_y = metres.north;
        placed.note =
            fmt::format("its nodes are in degrees: metres are those at latitude {:.4g}", middle);
    } else if (const auto metres = metres_per_unit(unit)) {
        placed.metres_per_x = placed.metres_per_y = *metres;
    }
    shift(mesh.x, placed.west, placed.metres_per_x);
    shift(mesh.y, placed.south, placed.metres_per_y);
    if (layout.anuga) {  // whose coordinates count from a corner of its own
        placed.west += first_or(input.numbers(NC_GLOBAL, "xllcorner"), 0.0);
        placed.south += first_or(input.numbers(NC_GLOBAL, "yllcorner"), 0.0);
    }
    return placed;
}

}  // namespace fumon
