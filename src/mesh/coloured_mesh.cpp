#include "mesh/coloured_mesh.h"

#include <fmt/format.h>

#include <iterator>

#include "mesh/little_endian.h"

namespace fumon {

std::string ply_file(const Mesh& mesh, std::span<const PointColour> colours) {
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment fumon\n"
        "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        mesh.points.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const MeshPoint& point = mesh.points[i];
        for (const double value : {point.x, point.y, point.z})
            append_number<float>(bytes, static_cast<float>(value));
        for (const std::uint8_t part : colours[i]) append_number<std::uint8_t>(bytes, part);
    }
    for (const auto& triangle : mesh.triangles) {
        append_number<std::uint8_t>(bytes, 3);
        for (const std::uint32_t corner : triangle) append_number<std::uint32_t>(bytes, corner);
    }
    return bytes;
}

std::string obj_file(const Mesh& mesh, std::span<const PointColour> colours) {
    constexpr double full = 255.0;
    std::string text = "# fumon: x east, y north, z up; colours after the coordinates\n";
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const MeshPoint& point = mesh.points[i];
        const PointColour& colour = colours[i];
        fmt::format_to(std::back_inserter(text), "v {:.9g} {:.9g} {:.9g} {:.4f} {:.4f} {:.4f}\n",
                       point.x, point.y, point.z, colour[0] / full, colour[1] / full,
                       colour[2] / full);
    }
    for (const auto& triangle : mesh.triangles)  // counted from 1
        fmt::format_to(std::back_inserter(text), "f {} {} {}\n", triangle[0] + 1, triangle[1] + 1,
                       triangle[2] + 1);
    return text;
}

}  // namespace fumon
