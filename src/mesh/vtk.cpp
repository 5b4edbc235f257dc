#include "mesh/vtk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/snapshot_lookup.h"
#include "mesh/little_endian.h"
#include "mesh/vtk_arrays.h"

namespace fumon {

namespace {

bool hidden(const Snapshot& snapshot, std::size_t cell) {
    return !snapshot.nodata.empty() && snapshot.nodata.values()[cell] != 0;
}

/// Where the grid begins: on its map if that counts metres as the scale does.
GeoReference corner_of(const WorldScale& scale) {
    const bool on_map =
        scale.place && !scale.place->degrees && std::abs(scale.place->dx / scale.dx - 1.0) < 1e-6;
    return on_map ? *scale.place : GeoReference{};
}

}  // namespace

std::string vts_file(const Snapshot& snapshot, double exaggeration) {
    const Grid& bed = snapshot.bed;
    const WorldScale& scale = snapshot.scale;
    const GeoReference corner = corner_of(scale);
    constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
    double lowest = std::numeric_limits<double>::infinity();  // where points without data stand
    for (std::size_t cell = 0; cell < bed.size(); ++cell) {
        if (!hidden(snapshot, cell)) lowest = std::min(lowest, bed.values()[cell]);
    }
    VtkArrays arrays;
    // A section's columns begin at its west end, where the bed's cells have their edge.
    const double half = snapshot.section ? 0.0 : 0.5;
    std::string points;
    const auto add = [&](std::string& elements, const char* type, const std::string& name,
                         int components, const auto& fill) {
        std::string values;
        fill(values);
        arrays.add(elements, type, name, components, values);
    };
    add(points, "Float64", "points", 3, [&](std::string& values) {
        std::size_t cell = 0;
        for (int y = 0; y < bed.ny(); ++y) {
            for (int x = 0; x < bed.nx(); ++x, ++cell) {
                const double height = hidden(snapshot, cell) ? lowest : bed(x, y);
                append_number<double>(values, corner.west + (x + half) * scale.dx);
                append_number<double>(values, corner.south + (y + half) * scale.dy);
                append_number<double>(values, height * scale.height_unit * exaggeration);
            }
        }
    });
    std::string data;
    const auto add_field = [&](const std::string& name, const Grid& field, double factor) {
        add(data, "Float64", name, 1, [&](std::string& values) {
            for (std::size_t cell = 0; cell < field.size(); ++cell)
                append_number<double>(
                    values, hidden(snapshot, cell) ? no_value : field.values()[cell] * factor);
        });
    };
    add_field("bed_height", bed, scale.height_unit);
    for (const SnapshotField& field : snapshot.fields) {
        if (field.values.size() == bed.size()) add_field(field.name, field.values, 1.0);
    }
    if (snapshot.section) {
        for (const SectionCurve& curve : snapshot.section->curves) {
            if (curve.name == "bed_height" || curve.values.size() != bed.size()) continue;
            add(data, "Float64", curve.name, 1, [&](std::string& values) {
                for (const double value : curve.values) append_number<double>(values, value);
            });
        }
    }
    const Grid* u = field_of(snapshot.fields, "velocity_x");
    const Grid* v = field_of(snapshot.fields, "velocity_y");
    if (u != nullptr && v != nullptr && u->size() == bed.size() && v->size() == bed.size()) {
        add(data, "Float64", "velocity", 3, [&](std::string& values) {
            for (std::size_t cell = 0; cell < bed.size(); ++cell) {
                const bool none = hidden(snapshot, cell);
                append_number<double>(values, none ? no_value : u->values()[cell]);
                append_number<double>(values, none ? no_value : v->values()[cell]);
                append_number<double>(values, 0.0);
            }
        });
    }
    if (!snapshot.nodata.empty()) {
        add(data, "UInt8", "vtkGhostType", 1, [&](std::string& values) {
            for (std::size_t cell = 0; cell < bed.size(); ++cell)
                append_number<std::uint8_t>(values, hidden(snapshot, cell) ? vtk_hidden_point : 0);
        });
    }
    const std::string extent = fmt::format("0 {} 0 {} 0 0", bed.nx() - 1, bed.ny() - 1);
    return arrays.file("StructuredGrid", fmt::format(" WholeExtent=\"{}\"", extent),
                       fmt::format("{}<Piece Extent=\"{}\">\n<Points>\n{}</Points>\n"
                                   "<PointData Scalars=\"bed_height\">\n{}</PointData>\n</Piece>\n",
                                   vtk_time_element(snapshot.time), extent, points, data));
}

std::string vtk_time_element(double time) {
    return fmt::format(
        "<FieldData>\n"
        "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
        "format=\"ascii\">{}</DataArray>\n"
        "</FieldData>\n",
        time);
}

std::string pvd_file(std::span<const VtkMoment> moments) {
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<!-- records: {} -->\n"
        "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<Collection>\n",
        moments.size());
    for (const VtkMoment& moment : moments) {
        for (std::size_t part = 0; part < moment.files.size(); ++part)
            text += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", moment.time,
                                part, moment.files[part]);
    }
    return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace fumon
