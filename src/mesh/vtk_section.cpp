#include "mesh/vtk_section.h"

#include <fmt/format.h>

#include "base/find_named.h"
#include "base/snapshot_lookup.h"
#include "mesh/little_endian.h"
#include "mesh/vtk.h"
#include "mesh/vtk_arrays.h"

namespace fumon {

namespace {

void append_point(std::string& bytes, double x, double z) {
    append_number<double>(bytes, x);
    append_number<double>(bytes, 0.0);
    append_number<double>(bytes, z);
}

std::string bytes_of(const Grid& grid) {
    std::string bytes;
    for (const double value : grid.values()) append_number<double>(bytes, value);
    return bytes;
}

}  // namespace

std::string vts_section_file(const SnapshotSection& section, double time, double exaggeration) {
    const Grid& first = section.fields.front().values;
    VtkArrays arrays;
    std::string points;
    std::string nodes;
    std::string ghosts;
    const SectionCurve* bed = find_named(section.curves, "bed_height");
    for (int z = 0; z < first.ny(); ++z) {
        for (int x = 0; x < first.nx(); ++x) {
            append_point(nodes, x * section.dx, z * section.dz * exaggeration);
            const bool below =
                bed != nullptr && z * section.dz < bed->values[static_cast<std::size_t>(x)];
            append_number<std::uint8_t>(ghosts, below ? vtk_hidden_point : 0);
        }
    }
    arrays.add(points, "Float64", "points", 3, nodes);
    std::string data;
    for (const SnapshotField& field : section.fields)
        arrays.add(data, "Float64", field.name, 1, bytes_of(field.values));
    const Grid* u = field_of(section.fields, "velocity_x");
    const Grid* w = field_of(section.fields, "velocity_z");
    if (u != nullptr && w != nullptr) {
        std::string velocity;
        for (std::size_t node = 0; node < u->size(); ++node)
            append_point(velocity, u->values()[node], w->values()[node]);
        arrays.add(data, "Float64", "velocity", 3, velocity);
    }
    arrays.add(data, "UInt8", "vtkGhostType", 1, ghosts);
    const std::string extent = fmt::format("0 {} 0 0 0 {}", first.nx() - 1, first.ny() - 1);
    return arrays.file("StructuredGrid", fmt::format(" WholeExtent=\"{}\"", extent),
                       fmt::format("{}<Piece Extent=\"{}\">\n<Points>\n{}</Points>\n"
                                   "<PointData>\n{}</PointData>\n</Piece>\n",
                                   vtk_time_element(time), extent, points, data));
}

std::string vtp_paths_file(const SnapshotSection& section, double time, double exaggeration) {
    VtkArrays arrays;
    std::string places;
    std::string connectivity;
    std::string ends;
    std::string angles;
    std::int64_t count = 0;
    std::size_t lines = 0;
    for (const GrainPath& path : section.paths) {
        if (path.x.empty()) continue;
        for (std::size_t i = 0; i < path.x.size(); ++i) {
            append_point(places, path.x[i], path.z[i] * exaggeration);
            append_number<std::int64_t>(connectivity, count++);
        }
        append_number<std::int64_t>(ends, count);
        append_number<double>(angles, path.launch_angle);
        ++lines;
    }
    std::string points;
    std::string cells;
    std::string data;
    arrays.add(points, "Float64", "points", 3, places);
    arrays.add(cells, "Int64", "connectivity", 1, connectivity);
    arrays.add(cells, "Int64", "offsets", 1, ends);
    arrays.add(data, "Float64", "launch_angle", 1, angles);
    return arrays.file("PolyData", "",
                       fmt::format("{}<Piece NumberOfPoints=\"{}\" NumberOfLines=\"{}\">\n"
                                   "<Points>\n{}</Points>\n<Lines>\n{}</Lines>\n"
                                   "<CellData>\n{}</CellData>\n</Piece>\n",
                                   vtk_time_element(time), count, lines, points, cells, data));
}

}  // namespace fumon
