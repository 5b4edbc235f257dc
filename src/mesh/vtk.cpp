#include "mesh/vtk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/snapshot_lookup.h"
#include "mesh/little_endian.h"

namespace fumon {

namespace {

constexpr std::uint8_t hidden_point = 2;  // vtkDataSetAttributes::HIDDENPOINT

/// Arrays of a file: their elements, and the bytes that they point to.
class Arrays {
  public:
    /// An array whose bytes `fill` appends.
    template <class Fill>
    void add(std::string& elements, const char* type, const std::string& name, int components,
             const Fill& fill) {
        elements += fmt::format(
            "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
            "offset=\"{}\"/>\n",
            type, name, components, bytes_.size());
        std::string values;
        fill(values);
        append_number<std::uint64_t>(bytes_, values.size());
        bytes_ += values;
    }

    [[nodiscard]] const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

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
    Arrays arrays;
    std::string points;
    arrays.add(points, "Float64", "points", 3, [&](std::string& values) {
        std::size_t cell = 0;
        for (int y = 0; y < bed.ny(); ++y) {
            for (int x = 0; x < bed.nx(); ++x, ++cell) {
                const double height = hidden(snapshot, cell) ? lowest : bed(x, y);
                append_number<double>(values, corner.west + (x + 0.5) * scale.dx);
                append_number<double>(values, corner.south + (y + 0.5) * scale.dy);
                append_number<double>(values, height * scale.height_unit * exaggeration);
            }
        }
    });
    std::string data;
    const auto add_field = [&](const std::string& name, const Grid& field, double factor) {
        arrays.add(data, "Float64", name, 1, [&](std::string& values) {
            for (std::size_t cell = 0; cell < field.size(); ++cell)
                append_number<double>(
                    values, hidden(snapshot, cell) ? no_value : field.values()[cell] * factor);
        });
    };
    add_field("bed_height", bed, scale.height_unit);
    for (const SnapshotField& field : snapshot.fields) {
        if (field.values.size() == bed.size()) add_field(field.name, field.values, 1.0);
    }
    const Grid* u = field_of(snapshot.fields, "velocity_x");
    const Grid* v = field_of(snapshot.fields, "velocity_y");
    if (u != nullptr && v != nullptr && u->size() == bed.size() && v->size() == bed.size()) {
        arrays.add(data, "Float64", "velocity", 3, [&](std::string& values) {
            for (std::size_t cell = 0; cell < bed.size(); ++cell) {
                const bool none = hidden(snapshot, cell);
                append_number<double>(values, none ? no_value : u->values()[cell]);
                append_number<double>(values, none ? no_value : v->values()[cell]);
                append_number<double>(values, 0.0);
            }
        });
    }
    if (!snapshot.nodata.empty()) {
        arrays.add(data, "UInt8", "vtkGhostType", 1, [&](std::string& values) {
            for (std::size_t cell = 0; cell < bed.size(); ++cell)
                append_number<std::uint8_t>(values, hidden(snapshot, cell) ? hidden_point : 0);
        });
    }
    const std::string extent = fmt::format("0 {} 0 {} 0 0", bed.nx() - 1, bed.ny() - 1);
    return fmt::format(
               "<?xml version=\"1.0\"?>\n"
               "<VTKFile type=\"StructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
               "header_type=\"UInt64\">\n"
               "<StructuredGrid WholeExtent=\"{0}\">\n"
               "<FieldData>\n"
               "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
               "format=\"ascii\">{1}</DataArray>\n"
               "</FieldData>\n"
               "<Piece Extent=\"{0}\">\n"
               "<Points>\n{2}</Points>\n"
               "<PointData Scalars=\"bed_height\">\n{3}</PointData>\n"
               "</Piece>\n</StructuredGrid>\n"
               "<AppendedData encoding=\"raw\">\n_",
               extent, snapshot.time, points, data) +
           arrays.bytes() + "\n</AppendedData>\n</VTKFile>\n";
}

std::string pvd_file(std::span<const VtkMoment> moments) {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<Collection>\n";
    for (const VtkMoment& moment : moments)
        text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", moment.time,
                            moment.file);
    return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace fumon
