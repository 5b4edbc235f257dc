#include "mesh/stl.h"

#include <cmath>

#include "mesh/little_endian.h"

namespace fumon {

namespace {

MeshPoint less(const MeshPoint& a, const MeshPoint& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

MeshPoint normal_of(const MeshPoint& a, const MeshPoint& b, const MeshPoint& c) {
    const MeshPoint u = less(b, a);
    const MeshPoint v = less(c, a);
    const MeshPoint n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return length > 0.0 ? MeshPoint{n.x / length, n.y / length, n.z / length} : MeshPoint{};
}

void append_point(std::string& bytes, const MeshPoint& point) {
    for (const double value : {point.x, point.y, point.z})
        append_number<float>(bytes, static_cast<float>(value));
}

}  // namespace

std::string stl_file(const Mesh& mesh) {
    constexpr std::size_t header = 80;
    constexpr std::size_t triangle_bytes = 50;
    std::string bytes = "fumon, millimetres";  // must not begin with "solid"
    bytes.resize(header, ' ');
    bytes.reserve(header + 4 + triangle_bytes * mesh.triangles.size());
    append_number<std::uint32_t>(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        const MeshPoint& a = mesh.points[triangle[0]];
        const MeshPoint& b = mesh.points[triangle[1]];
        const MeshPoint& c = mesh.points[triangle[2]];
        for (const MeshPoint& point : {normal_of(a, b, c), a, b, c}) append_point(bytes, point);
        append_number<std::uint16_t>(bytes, 0);
    }
    return bytes;
}

}  // namespace fumon
