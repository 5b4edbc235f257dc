#include "files/netcdf/netcdf_section.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "files/netcdf/netcdf_calls.h"
#include "files/netcdf/netcdf_definition.h"

namespace fumon {

namespace {

constexpr std::string_view own_bed = "bed_height";
constexpr std::string_view own_bed_in_file = "section_bed_height";
constexpr std::size_t chunk_points = 512;  // of a path
constexpr std::size_t chunk_paths = 256;   // so that a chunk has 1 MiB at most
constexpr std::size_t path_index = 32;     // values' room for a chunk's place in the file
constexpr std::size_t curve_values = 512;  // of a chunk, 4 KiB, where a curve has fewer

std::size_t as_count(int nodes) {
    return static_cast<std::size_t>(nodes);
}

std::size_t columns_of(const SnapshotSection& section) {
    return as_count(section.fields.front().values.nx());
}

std::size_t longest_path(const SnapshotSection& section) {
    std::size_t points = 0;
    for (const GrainPath& path : section.paths) points = std::max(points, path.x.size());
    return points;
}

std::size_t curve_records(std::size_t columns) {
    return std::max(std::size_t{1}, curve_values / columns);
}

int define_curve(int file, int time, int x, const std::string& name, std::size_t columns) {
    const std::array<int, 2> over{time, x};
    int variable = 0;
    check_netcdf(nc_def_var(file, name.c_str(), NC_DOUBLE, 2, over.data(), &variable));
    const std::array<std::size_t, 2> chunk{curve_records(columns), columns};
    check_netcdf(nc_def_var_chunking(file, variable, NC_CHUNKED, chunk.data()));
    protect(file, variable);
    fill_with_nan(file, variable, chunk[0] * chunk[1]);
    return variable;
}

int define_path_axis(int file, const std::array<int, 3>& over, const char* name,
                     const char* long_name, std::size_t paths) {
    int variable = 0;
    check_netcdf(nc_def_var(file, name, NC_DOUBLE, 3, over.data(), &variable));
    const std::array<std::size_t, 3> chunk{1, std::min(paths, chunk_paths), chunk_points};
    check_netcdf(nc_def_var_chunking(file, variable, NC_CHUNKED, chunk.data()));
    compress(file, variable);
    protect(file, variable);
    fill_with_nan(file, variable, chunk[1] * chunk[2]);
    describe(file, variable, long_name, "m");
    return variable;
}

SectionLayout::Paths define_paths(int file, int time, std::size_t paths) {
    int path = 0;
    int point = 0;
    check_netcdf(nc_def_dim(file, "path", paths, &path));
    check_netcdf(nc_def_dim(file, "path_point", NC_UNLIMITED, &point));
    SectionLayout::Paths layout;
    layout.launch_angle = define_curve(file, time, path, "launch_angle", paths);
    describe(file, layout.launch_angle, "angle of the grain's launch to the local bed", "degrees");
    const std::array<int, 3> over{time, path, point};
    layout.x = define_path_axis(file, over, "path_x", "the grain's place along the section", paths);
    layout.z = define_path_axis(file, over, "path_z", "the grain's height", paths);
    return layout;
}

void put_nodes(int file, int variable, std::size_t count, double spacing) {
    std::vector<double> nodes(count);
    for (std::size_t i = 0; i < count; ++i) nodes[i] = static_cast<double>(i) * spacing;
    check_netcdf(nc_put_var_double(file, variable, nodes.data()));
}

void write_line(RecordValues& file, int variable, std::size_t record,
                const std::vector<double>& values) {
    const std::array<std::size_t, 2> start{record, 0};
    const std::array<std::size_t, 2> count{1, values.size()};
    file.put(variable, start, count, values.data());
}

void write_path_axis(RecordValues& file, int variable, std::size_t record,
                     const SnapshotSection& section, std::vector<double> GrainPath::*axis) {
    const std::size_t points = longest_path(section);
    if (points == 0) return;
    std::vector<double> block(section.paths.size() * points,
                              std::numeric_limits<double>::quiet_NaN());
    for (std::size_t path = 0; path < section.paths.size(); ++path) {
        std::ranges::copy(section.paths[path].*axis,
                          block.begin() + static_cast<std::ptrdiff_t>(path * points));
    }
    const std::array<std::size_t, 3> start{record, 0, 0};
    const std::array<std::size_t, 3> count{1, section.paths.size(), points};
    file.put(variable, start, count, block.data());
}

void write_paths(RecordValues& file, const SectionLayout::Paths& layout, std::size_t record,
                 const SnapshotSection& section) {
    std::vector<double> angles;
    angles.reserve(section.paths.size());
    for (const GrainPath& path : section.paths) angles.push_back(path.launch_angle);
    write_line(file, layout.launch_angle, record, angles);
    write_path_axis(file, layout.x, record, section, &GrainPath::x);
    write_path_axis(file, layout.z, record, section, &GrainPath::z);
}

std::size_t whole_chunks(std::size_t count, std::size_t chunk) {
    return (count + chunk - 1) / chunk * chunk;
}

}  // namespace

std::string section_name_in_file(const std::string& name) {
    if (name == own_bed) return std::string(own_bed_in_file);
    std::string in_file = name;
    std::ranges::replace(in_file, '.', '_');
    return in_file;
}

std::string section_name_in_snapshot(const std::string& name) {
    return name == own_bed_in_file ? std::string(own_bed) : name;
}

std::vector<std::string> section_variable_names(const SnapshotSection& section) {
    std::vector<std::string> names{"section_x", "z"};
    for (const SnapshotField& field : section.fields)
        names.push_back(section_name_in_file(field.name));
    for (const SectionCurve& curve : section.curves)
        names.push_back(section_name_in_file(curve.name));
    if (!section.paths.empty())
        names.insert(names.end(), {"path", "path_point", "launch_angle", "path_x", "path_z"});
    return names;
}

SectionLayout define_section(int file, int time, const SnapshotSection& section) {
    const std::size_t columns = columns_of(section);
    int x = 0;
    int z = 0;
    check_netcdf(nc_def_dim(file, "z", as_count(section.fields.front().values.ny()), &z));
    check_netcdf(nc_def_dim(file, "section_x", columns, &x));
    SectionLayout layout;
    layout.z = define_coordinate(file, "z", z, as_count(section.fields.front().values.ny()));
    describe(file, layout.z, "height", "m");
    put_text(file, layout.z, "axis", "Z");
    put_text(file, layout.z, "positive", "up");
    layout.x = define_coordinate(file, "section_x", x, columns);
    describe(file, layout.x, "distance along the section", "m");
    for (const SnapshotField& field : section.fields) {
        layout.fields.push_back(
            define_field(file, {time, z, x}, section_name_in_file(field.name), field.values));
        describe(file, layout.fields.back(), field.long_name, field.unit);
    }
    for (const SectionCurve& curve : section.curves) {
        layout.curves.push_back(
            define_curve(file, time, x, section_name_in_file(curve.name), columns));
        if (curve.name.find('.') != std::string::npos)
            put_text(file, layout.curves.back(), own_name_attribute, curve.name);
        describe(file, layout.curves.back(), curve.long_name, curve.unit);
    }
    if (!section.paths.empty()) layout.paths = define_paths(file, time, section.paths.size());
    return layout;
}

void put_section_coordinates(int file, const SectionLayout& layout,
                             const SnapshotSection& section) {
    put_nodes(file, layout.z, as_count(section.fields.front().values.ny()), section.dz);
    put_nodes(file, layout.x, columns_of(section), section.dx);
}

void write_section(RecordValues& file, const SectionLayout& layout, std::size_t record,
                   const SnapshotSection& section) {
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
        const Grid& values = section.fields[i].values;
        const std::array<std::size_t, 3> start{record, 0, 0};
        const std::array<std::size_t, 3> count{1, as_count(values.ny()), as_count(values.nx())};
        file.put(layout.fields[i], start, count, values.data());
    }
    for (std::size_t i = 0; i < layout.curves.size(); ++i)
        write_line(file, layout.curves[i], record, section.curves[i].values);
    if (layout.paths) write_paths(file, *layout.paths, record, section);
}

std::int64_t section_record_bytes(const SnapshotSection& section) {
    const Grid& field = section.fields.front().values;
    const std::size_t columns = columns_of(section);
    const std::size_t nodes =
        whole_chunks(as_count(field.ny()), as_count(rows_of_chunk(field))) * columns;
    const std::size_t paths = section.paths.size();
    std::size_t values = section.fields.size() * nodes;
    values += section.curves.size() * curve_records(columns) * columns;
    if (paths > 0) {
        const std::size_t together = std::min(paths, chunk_paths);
        const std::size_t in_path_chunks =
            whole_chunks(paths, together) * whole_chunks(longest_path(section), chunk_points);
        const std::size_t chunks = in_path_chunks / (together * chunk_points);
        values += curve_records(paths) * paths + 2 * (in_path_chunks + chunks * path_index);
    }
    return static_cast<std::int64_t>(values * sizeof(double));
}

}  // namespace fumon
