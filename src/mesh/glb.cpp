#include "mesh/glb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "mesh/little_endian.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;
using Vector = std::array<double, 3>;

// Numbers of the glTF 2.0 specification.
constexpr int type_float = 5126;
constexpr int type_uint32 = 5125;
constexpr int target_vertices = 34962;
constexpr int target_indices = 34963;
constexpr int filter_linear = 9729;
constexpr int filter_mipmaps = 9987;
constexpr int clamp_to_edge = 33071;

/// A mean of the normals of the triangles around each point, by their areas.
std::vector<Vector> normals_of(const Mesh& mesh) {
    std::vector<Vector> normals(mesh.points.size(), Vector{});
    for (const auto& triangle : mesh.triangles) {
        const MeshPoint& a = mesh.points[triangle[0]];
        const MeshPoint& b = mesh.points[triangle[1]];
        const MeshPoint& c = mesh.points[triangle[2]];
        const Vector u{b.x - a.x, b.y - a.y, b.z - a.z};
        const Vector v{c.x - a.x, c.y - a.y, c.z - a.z};
        const Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                       u[0] * v[1] - u[1] * v[0]};
        for (const std::uint32_t point : triangle) {
            for (std::size_t k = 0; k < 3; ++k) normals[point][k] += n[k];
        }
    }
    for (Vector& n : normals) {
        const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (double& part : n) part /= length;
    }
    return normals;
}

struct Bounds {
    Vector low{};
    Vector high{};
};

Bounds bounds_of(const Mesh& mesh) {
    const MeshPoint& first = mesh.points.front();
    Bounds bounds{{first.x, first.y, first.z}, {first.x, first.y, first.z}};
    for (const MeshPoint& point : mesh.points) {
        const Vector at{point.x, point.y, point.z};
        for (std::size_t k = 0; k < 3; ++k) {
            bounds.low[k] = std::min(bounds.low[k], at[k]);
            bounds.high[k] = std::max(bounds.high[k], at[k]);
        }
    }
    return bounds;
}

void pad(std::string& bytes, char with) {
    while (bytes.size() % 4 != 0) bytes += with;
}

/// The binary part, and what the JSON says of it.
class Buffer {
  public:
    std::string bytes;
    Json views = Json::array();

    /// Notes what was appended since `begin` as a view; returns its number.
    int add_view(std::size_t begin, int target) {
        Json view{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size() - begin}};
        if (target != 0) view["target"] = target;
        views.push_back(std::move(view));
        pad(bytes, '\0');
        return static_cast<int>(views.size()) - 1;
    }
};

}  // namespace

std::string glb_file(const HeightMesh& surface, std::span<const std::uint8_t> texture_png) {
    const Mesh& mesh = surface.top;
    const Bounds bounds = bounds_of(mesh);
    const double middle_x = 0.5 * (bounds.low[0] + bounds.high[0]);
    const double middle_y = 0.5 * (bounds.low[1] + bounds.high[1]);
    Buffer buffer;
    Json accessors = Json::array();
    const auto append_vector = [&](double x, double y, double z) {
        for (const double value : {x, y, z})
            append_number<float>(buffer.bytes, static_cast<float>(value));
    };
    const auto add_accessor = [&](std::size_t begin, int target, int component, std::size_t count,
                                  const char* type) {
        accessors.push_back({{"bufferView", buffer.add_view(begin, target)},
                             {"componentType", component},
                             {"count", count},
                             {"type", type}});
    };

    std::array<float, 3> least{INFINITY, INFINITY, INFINITY};
    std::array<float, 3> most{-INFINITY, -INFINITY, -INFINITY};
    std::size_t begin = buffer.bytes.size();
    for (const MeshPoint& point : mesh.points) {
        const Vector at{point.x - middle_x, point.z - bounds.low[2], -(point.y - middle_y)};
        append_vector(at[0], at[1], at[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], static_cast<float>(at[k]));
            most[k] = std::max(most[k], static_cast<float>(at[k]));
        }
    }
    add_accessor(begin, target_vertices, type_float, mesh.points.size(), "VEC3");
    accessors.back()["min"] = least;
    accessors.back()["max"] = most;

    begin = buffer.bytes.size();
    for (const Vector& n : normals_of(mesh)) append_vector(n[0], n[2], -n[1]);
    add_accessor(begin, target_vertices, type_float, mesh.points.size(), "VEC3");

    begin = buffer.bytes.size();
    for (const auto& place : surface.places) {  // from the texture's upper left corner
        append_number<float>(buffer.bytes, static_cast<float>(place[0]));
        append_number<float>(buffer.bytes, static_cast<float>(1.0 - place[1]));
    }
    add_accessor(begin, target_vertices, type_float, mesh.points.size(), "VEC2");

    begin = buffer.bytes.size();
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t point : triangle)
            append_number<std::uint32_t>(buffer.bytes, point);
    }
    add_accessor(begin, target_indices, type_uint32, 3 * mesh.triangles.size(), "SCALAR");

    begin = buffer.bytes.size();
    for (const std::uint8_t byte : texture_png) buffer.bytes += static_cast<char>(byte);
    const int texture = buffer.add_view(begin, 0);

    const Json primitive{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}},
                         {"indices", 3},
                         {"material", 0}};
    const Json material{
        {"pbrMetallicRoughness",
         {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}},
        {"extensions", {{"KHR_materials_unlit", Json::object()}}}};
    const Json sampler{{"magFilter", filter_linear},
                       {"minFilter", filter_mipmaps},
                       {"wrapS", clamp_to_edge},
                       {"wrapT", clamp_to_edge}};
    const auto list_of = [](Json item) { return Json::array({std::move(item)}); };
    Json root;
    root["asset"] = {{"version", "2.0"}, {"generator", "fumon"}};
    root["extensionsUsed"] = list_of("KHR_materials_unlit");
    root["scene"] = 0;
    root["scenes"] = list_of({{"nodes", list_of(0)}});
    root["nodes"] = list_of({{"mesh", 0}, {"name", "terrain"}});
    root["meshes"] = list_of({{"primitives", list_of(primitive)}});
    root["materials"] = list_of(material);
    root["textures"] = list_of({{"sampler", 0}, {"source", 0}});
    root["images"] = list_of({{"bufferView", texture}, {"mimeType", "image/png"}});
    root["samplers"] = list_of(sampler);
    root["accessors"] = std::move(accessors);
    root["bufferViews"] = std::move(buffer.views);
    root["buffers"] = list_of({{"byteLength", buffer.bytes.size()}});
    std::string json = root.dump();
    pad(json, ' ');

    constexpr std::uint32_t magic = 0x46546C67;  // "glTF"
    constexpr std::uint32_t json_chunk = 0x4E4F534A;
    constexpr std::uint32_t binary_chunk = 0x004E4942;
    constexpr std::size_t heads = 12 + 8 + 8;
    std::string file;
    const auto append_word = [&](std::size_t word) {
        append_number<std::uint32_t>(file, static_cast<std::uint32_t>(word));
    };
    append_word(magic);
    append_word(2);
    append_word(heads + json.size() + buffer.bytes.size());
    append_word(json.size());
    append_word(json_chunk);
    file += json;
    append_word(buffer.bytes.size());
    append_word(binary_chunk);
    file += buffer.bytes;
    return file;
}

}  // namespace fumon
