// Surfaces and solids made of beds: closed, turned outward, within their limits; and their files.

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "mesh/coloured_mesh.h"
#include "mesh/glb.h"
#include "mesh/height_mesh.h"
#include "mesh/stl.h"
#include "mesh/vtk.h"
#include "mesh/vtk_section.h"

namespace fumon::test {
namespace {

/// A hilly bed of cells of 2 m × 3 m, of which a share has no data, at random.
Snapshot ragged_bed(int nx, int ny, double without_data, std::uint64_t seed = 1) {
    Snapshot snapshot;
    snapshot.bed = Grid(nx, ny);
    snapshot.nodata = Mask(nx, ny);
    snapshot.scale = {2.0, 3.0, 0.5, true};
    for (int y = 0; y < ny; ++y) {
        RandomStream stream(seed, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (int x = 0; x < nx; ++x) {
            snapshot.bed(x, y) = 100.0 + 10.0 * std::sin(0.5 * x) * std::cos(0.3 * y);
            if (stream.uniform() < without_data) snapshot.nodata(x, y) = 1;
        }
    }
    return snapshot;
}

/// Edges that do not belong to exactly two triangles that run along them in opposite directions.
int open_edges(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++runs[{triangle[k], triangle[(k + 1) % 3]}];
    }
    int open = 0;
    for (const auto& [edge, count] : runs) {
        const auto back = runs.find({edge.second, edge.first});
        if (count != 1 || back == runs.end() || back->second != 1) ++open;
    }
    return open;
}

/// By the divergence theorem; positive where the triangles face outward.
double volume_of(const Mesh& mesh) {
    double volume = 0.0;
    for (const auto& triangle : mesh.triangles) {
        const MeshPoint& a = mesh.points[triangle[0]];
        const MeshPoint& b = mesh.points[triangle[1]];
        const MeshPoint& c = mesh.points[triangle[2]];
        volume += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
                  a.z * (b.x * c.y - b.y * c.x);
    }
    return volume / 6.0;
}

template <class Number>
Number number_at(const std::string& bytes, std::size_t place) {
    Number number{};
    std::memcpy(&number, bytes.data() + place, sizeof(Number));
    return number;
}

TEST(ClosedSolid, IsWatertightWhateverCellsHaveNoData) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const Snapshot snapshot = ragged_bed(23, 17, 0.02 * static_cast<double>(seed % 10), seed);
        const Mesh solid = closed_solid(height_mesh(snapshot, 1.0, 100000).top, 10.0);
        EXPECT_EQ(open_edges(solid), 0) << seed;
        EXPECT_GT(volume_of(solid), 0.0) << seed;
    }
}

TEST(ClosedSolid, HasTheVolumeUnderItsSurface) {
    Snapshot flat = ragged_bed(11, 6, 0.0);
    for (double& height : flat.bed.values()) height = 20.0;
    const Mesh solid = closed_solid(height_mesh(flat, 3.0, 100000).top, 10.0);
    EXPECT_NEAR(volume_of(solid), (10 * 2.0) * (5 * 3.0) * (20.0 * 0.5 * 3.0 - 10.0), 1e-6);
    EXPECT_EQ(solid.triangles.size(), 2U * 2 * 50 + 2 * 30);
}

TEST(HeightMesh, KeepsToTheTrianglesThatItMayHave) {
    const Snapshot snapshot = ragged_bed(101, 67, 0.0);
    const HeightMesh all = height_mesh(snapshot, 1.0, 1000000);
    EXPECT_EQ(all.top.triangles.size(), 2U * 100 * 66);
    EXPECT_EQ(all.cells_per_point, 1);
    EXPECT_EQ(all.top.points.front().x, 1.0);
    EXPECT_EQ(all.top.points.front().y, 1.5);
    const HeightMesh few = height_mesh(snapshot, 1.0, 500);
    EXPECT_LE(few.top.triangles.size(), 500U);
    EXPECT_GT(few.cells_per_point, 4);
    for (const auto& place : few.places) EXPECT_TRUE(place[0] > 0.0 && place[0] < 1.0);
    Snapshot nothing = ragged_bed(5, 5, 1.1);
    EXPECT_THROW(height_mesh(nothing, 1.0, 1000), InputError);
}

TEST(Stl, HoldsEveryTriangleWithItsNormal) {
    Snapshot flat = ragged_bed(3, 2, 0.0);
    for (double& height : flat.bed.values()) height = 20.0;
    const Mesh mesh = height_mesh(flat, 1.0, 1000).top;
    const std::string bytes = stl_file(mesh);
    ASSERT_EQ(bytes.size(), 84 + 50 * mesh.triangles.size());
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 80), mesh.triangles.size());
    EXPECT_FALSE(bytes.starts_with("solid"));
    EXPECT_EQ(number_at<float>(bytes, 84 + 8), 1.0F) << "up";
    EXPECT_EQ(number_at<float>(bytes, 84 + 12 + 8), 10.0F) << "metres";
}

TEST(Glb, IsOneBufferThatItsJsonDescribes) {
    const HeightMesh mesh = height_mesh(ragged_bed(9, 7, 0.0), 1.0, 1000);
    const std::vector<std::uint8_t> texture{1, 2, 3, 4, 5};
    const std::string bytes = glb_file(mesh, texture);
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 8), bytes.size());
    const auto json_bytes = number_at<std::uint32_t>(bytes, 12);
    EXPECT_EQ(json_bytes % 4, 0U);
    const auto json = nlohmann::json::parse(bytes.substr(20, json_bytes));
    const std::size_t binary = 20 + json_bytes + 8;
    EXPECT_EQ(number_at<std::uint32_t>(bytes, binary - 8), bytes.size() - binary);
    EXPECT_EQ(json["buffers"][0]["byteLength"], bytes.size() - binary);
    EXPECT_EQ(json["accessors"][0]["count"], mesh.top.points.size());
    EXPECT_EQ(json["accessors"][3]["count"], 3 * mesh.top.triangles.size());
    std::size_t end = 0;
    for (const auto& view : json["bufferViews"]) {
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
        EXPECT_GE(view["byteOffset"].get<std::size_t>(), end);
        end = view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>();
    }
    EXPECT_LE(end, bytes.size() - binary);
    const auto& picture = json["bufferViews"][json["images"][0]["bufferView"].get<std::size_t>()];
    EXPECT_EQ(bytes.substr(binary + picture["byteOffset"].get<std::size_t>(), 5),
              std::string("\x01\x02\x03\x04\x05"));
    // The first point: south-west, which is at −x and +z; its texture's lower left.
    EXPECT_EQ(number_at<float>(bytes, binary), -8.0F);
    EXPECT_EQ(number_at<float>(bytes, binary + 8), 9.0F);
    const auto places = json["bufferViews"][2]["byteOffset"].get<std::size_t>();
    EXPECT_NEAR(number_at<float>(bytes, binary + places + 4), 1.0 - 0.5 / 7.0, 1e-6);
}

/// The values of an array of a VTK file, taken apart as vtkZLibDataCompressor's format has it.
std::string vtk_array(const std::string& file, const std::string& name) {
    const std::size_t data = file.find("\n_") + 2;
    const std::size_t at = file.find("offset=\"", file.find("Name=\"" + name + "\"")) + 8;
    std::size_t place = data + static_cast<std::size_t>(std::stoll(file.substr(at)));
    const auto next = [&] {
        const auto number = number_at<std::uint64_t>(file, place);
        place += 8;
        return number;
    };
    const std::uint64_t blocks = next();
    const std::uint64_t block = next();
    const std::uint64_t last = next();
    std::vector<std::uint64_t> lengths;
    for (std::uint64_t i = 0; i < blocks; ++i) lengths.push_back(next());
    libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
    std::string values;
    for (std::uint64_t i = 0; i < blocks; ++i) {
        std::string bytes(i + 1 == blocks && last > 0 ? last : block, '\0');
        std::size_t made = 0;
        EXPECT_EQ(libdeflate_zlib_decompress(decompressor, file.data() + place, lengths[i],
                                             bytes.data(), bytes.size(), &made),
                  LIBDEFLATE_SUCCESS);
        EXPECT_EQ(made, bytes.size());
        place += lengths[i];
        values += bytes;
    }
    libdeflate_free_decompressor(decompressor);
    return values;
}

TEST(Vtk, HoldsCompressedArrays) {
    Snapshot snapshot = ragged_bed(400, 300, 0.0);
    snapshot.nodata(1, 1) = 1;
    snapshot.time = 60.0;
    snapshot.fields = {{"water_depth", "", "m", Grid(400, 300, 0.25)},
                       {"velocity_x", "", "m/s", Grid(400, 300, 2.0)},
                       {"velocity_y", "", "m/s", Grid(400, 300, 3.0)}};
    snapshot.scale.place = GeoReference{1000.0, 2000.0, 2.0, 3.0, false, ""};
    const std::string file = vts_file(snapshot, 2.0);
    const std::string points = vtk_array(file, "points");
    ASSERT_EQ(points.size(), 400U * 300 * 3 * 8) << "three blocks, the last shorter";
    EXPECT_EQ(number_at<double>(points, 0), 1001.0);
    EXPECT_EQ(number_at<double>(points, 8), 2001.5);
    EXPECT_EQ(number_at<double>(points, 16), 2.0 * 0.5 * snapshot.bed(0, 0));
    EXPECT_EQ(number_at<double>(points, points.size() - 24), 1799.0);
    EXPECT_EQ(number_at<double>(vtk_array(file, "water_depth"), 0), 0.25);
    EXPECT_EQ(number_at<double>(vtk_array(file, "velocity"), 8), 3.0);
    EXPECT_TRUE(std::isnan(number_at<double>(vtk_array(file, "bed_height"), 401 * 8)));
    EXPECT_EQ(number_at<std::uint8_t>(vtk_array(file, "vtkGhostType"), 401), 2);
    EXPECT_NE(file.find(">60</DataArray>"), std::string::npos);
    EXPECT_LT(file.size(), 400U * 300 * 30) << "of 81 bytes a point";
}

TEST(Vtk, ASeriesTellsItsRecordsAndTheirParts) {
    const std::string text =
        pvd_file(std::vector<VtkMoment>{{1.5, {"a.vts", "b.vts", "c.vtp"}}, {2.5, {"d.vts"}}});
    EXPECT_NE(text.find("records: 2"), std::string::npos);
    EXPECT_NE(text.find("timestep=\"1.5\" part=\"2\" file=\"c.vtp\""), std::string::npos);
    EXPECT_NE(text.find("timestep=\"2.5\" part=\"0\" file=\"d.vts\""), std::string::npos);
}

TEST(Vtk, ASectionHasItsFieldsAndItsPaths) {
    SnapshotSection section;
    section.dx = 0.5;
    section.dz = 0.25;
    section.fields = {{"velocity_x", "", "m/s", Grid(4, 3, 5.0)},
                      {"velocity_z", "", "m/s", Grid(4, 3, 1.0)},
                      {"vorticity", "", "s-1", Grid(4, 3, 7.0)}};
    section.curves = {{"bed_height", "", "m", {0.1, 0.3, 0.1, 0.1}}};
    section.paths = {
        {40.0, {0.0, 0.1, 0.2}, {0.0, 0.2, 0.1}}, {20.0, {}, {}}, {10.0, {1, 2}, {3, 4}}};
    const std::string air = vts_section_file(section, 2.0, 1.0);
    EXPECT_NE(air.find("WholeExtent=\"0 3 0 0 0 2\""), std::string::npos);
    const std::string points = vtk_array(air, "points");
    EXPECT_EQ(number_at<double>(points, points.size() - 24), 1.5);
    EXPECT_EQ(number_at<double>(points, points.size() - 8), 0.5);
    EXPECT_EQ(number_at<double>(vtk_array(air, "velocity"), 16), 1.0) << "upward";
    EXPECT_EQ(number_at<double>(vtk_array(air, "vorticity"), 8), 7.0);
    EXPECT_EQ(vtk_array(air, "vtkGhostType"), std::string("\2\2\2\2\0\2\0\0\0\0\0\0", 12));
    const std::string paths = vtp_paths_file(section, 2.0, 1.0);
    EXPECT_NE(paths.find("NumberOfPoints=\"5\" NumberOfLines=\"2\""), std::string::npos);
    EXPECT_EQ(number_at<std::int64_t>(vtk_array(paths, "offsets"), 8), 5);
    EXPECT_EQ(number_at<double>(vtk_array(paths, "launch_angle"), 8), 10.0);
}

TEST(ColouredMesh, IsAPlyAndAnObjFile) {
    const Mesh mesh = height_mesh(ragged_bed(3, 2, 0.0), 1.0, 1000).top;
    std::vector<PointColour> colours(mesh.points.size(), PointColour{0, 51, 255});
    const std::string ply = ply_file(mesh, colours);
    EXPECT_TRUE(ply.starts_with("ply\nformat binary_little_endian 1.0\n"));
    const std::size_t body = ply.find("end_header\n") + 11;
    EXPECT_EQ(ply.size() - body, 15 * mesh.points.size() + 13 * mesh.triangles.size());
    EXPECT_EQ(number_at<float>(ply, body), 1.0F);
    EXPECT_EQ(number_at<std::uint8_t>(ply, body + 13), 51);
    const std::string obj = obj_file(mesh, colours);
    EXPECT_NE(obj.find("v 1 1.5 50 0.0000 0.2000 1.0000\n"), std::string::npos) << obj;
    EXPECT_NE(obj.find("\nf 1 2 4\n"), std::string::npos) << obj;
}

}  // namespace
}  // namespace fumon::test
