// Results on triangles and polygons, laid on grids.

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "files/netcdf/netcdf_input.h"
#include "foreign/mesh/mesh_grid.h"
#include "foreign/mesh_layouts.h"
#include "foreign/mesh_maps.h"
#include "foreign/open_run.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

class MeshRun : public ::testing::Test {
  protected:
    TemporaryFolder folder;
    std::filesystem::path path = folder / "map.nc";

    [[nodiscard]] ForeignRun open(double cell = 0.0) const {
        ForeignQuery query;
        query.cell_size = cell;
        return open_foreign_run(path.string(), query);
    }
    [[nodiscard]] std::string refusal() const {
        return message_of<InputError>([&] {
            const ForeignRun run = open();
            for (std::size_t i = 0; i < run.times.times.size(); ++i) (void)foreign_snapshot(run, i);
        });
    }
};

double water_at(const Snapshot& snapshot, int x, int y) {
    return (*field_of(snapshot.fields, "water_depth"))(x, y);
}

double speed_at(const Snapshot& snapshot, int x, int y) {
    return (*field_of(snapshot.fields, "velocity_x"))(x, y);
}

void expect_delft3d_fm(const ForeignRun& run) {
    EXPECT_EQ(run.model, "Delft3D FM");
    EXPECT_DOUBLE_EQ(run.scale.dx, 5.0);
    ASSERT_EQ(run.nx, 6);
    ASSERT_EQ(run.ny, 2);
    EXPECT_DOUBLE_EQ(run.scale.place->west, 1000.0);
    EXPECT_DOUBLE_EQ(run.scale.place->south, 2000.0);
    EXPECT_EQ(run.times.date(run.times.times[1]), "2001-01-01 01:00 UTC");
    const Snapshot last = foreign_snapshot(run, 1);
    EXPECT_DOUBLE_EQ(last.bed(1, 1), 1.0);
    EXPECT_DOUBLE_EQ(last.bed(2, 0), 2.0);
    EXPECT_DOUBLE_EQ(last.bed(4, 0), 3.0);
    EXPECT_DOUBLE_EQ(water_at(last, 0, 1), 3.0);
    EXPECT_DOUBLE_EQ(water_at(last, 3, 1), 2.0);
    EXPECT_DOUBLE_EQ(water_at(last, 4, 0), 1.0);
    EXPECT_DOUBLE_EQ(speed_at(last, 0, 0), 1.0);
    ASSERT_FALSE(last.nodata.empty());
    EXPECT_EQ(last.nodata(5, 1), 1);
    EXPECT_EQ(last.nodata(3, 1), 0);
}

TEST_F(MeshRun, PolygonsOfDelft3DFm) {
    write_delft3d_fm(path);
    expect_delft3d_fm(open());
}

TEST_F(MeshRun, FacesMayCountFromZeroAndAMeshHaveAnyName) {
    write_delft3d_fm(path, 0, "Grid");
    expect_delft3d_fm(open());
}

TEST_F(MeshRun, TheNoteTellsCellsAndTheErrorOfVolume) {
    write_delft3d_fm(path);
    const ForeignRun run = open();
    ASSERT_EQ(run.notes.size(), 2U);
    EXPECT_EQ(run.notes[0],
              "3 faces on 7 nodes, laid on 6 x 2 cells of 5 m, half the mesh's median edge "
              "(--cell-size)");
    EXPECT_EQ(run.notes[1], "the cells hold 525 m³ of water in record 2, -4.5 % against the mesh");
    EXPECT_EQ(open(0.5).notes[0], "3 faces on 7 nodes, laid on 60 x 20 cells of 0.5 m");
}

TEST_F(MeshRun, TheQuadtreeOfSfincs) {
    write_sfincs_quadtree(path);
    const ForeignRun run = open(5.0);
    EXPECT_EQ(run.model, "SFINCS");
    EXPECT_EQ(run.nx, 6);
    EXPECT_EQ(run.ny, 4);
    EXPECT_EQ(run.times.date(run.times.times[1]), "2019-08-31 14:30 UTC");
    const Snapshot last = foreign_snapshot(run, 1);
    EXPECT_TRUE(last.nodata.empty());
    EXPECT_DOUBLE_EQ(water_at(last, 3, 3), 3.0);
    EXPECT_DOUBLE_EQ(water_at(last, 4, 1), 2.0);
    EXPECT_DOUBLE_EQ(water_at(last, 4, 2), 0.0);
    EXPECT_DOUBLE_EQ(last.bed(5, 3), 2.0);
}

TEST_F(MeshRun, TrianglesOfAnugaAreLinear) {
    path = folder / "run.sww";
    write_anuga(path);
    const ForeignRun run = open(1.0);
    EXPECT_EQ(run.model, "ANUGA");
    EXPECT_EQ(run.nx, 10);
    EXPECT_EQ(run.times.unit, "min");
    EXPECT_DOUBLE_EQ(run.times.times[1], 120.0);
    EXPECT_DOUBLE_EQ(run.scale.place->west, 300.0);
    EXPECT_DOUBLE_EQ(run.scale.place->south, 400.0);
    const Snapshot first = foreign_snapshot(run, 0);
    EXPECT_NEAR(first.bed(2, 7), 0.25, 1e-6);
    EXPECT_NEAR(water_at(first, 2, 2), 0.5, 1e-6);
    EXPECT_NEAR(speed_at(first, 2, 2), 1.0, 1e-6);
    // In the triangle with a dry corner: .05 of the way from it for each metre.
    EXPECT_NEAR(water_at(first, 9, 9), 0.05, 1e-6);
    EXPECT_NEAR(first.bed(9, 9), 0.95, 1e-6);
}

TEST_F(MeshRun, NodesWithoutABedHoldNoWater) {
    path = folder / "run.sww";
    write_anuga(path);
    const std::string whole = open(1.0).notes.back();
    {
        int file = 0;
        int elevation = 0;
        const std::size_t last = 3;
        const double none = -9999.0;
        must(nc_open(path.c_str(), NC_WRITE, &file));
        must(nc_inq_varid(file, "elevation", &elevation));
        must(nc_put_var1_double(file, elevation, &last, &none));
        must(nc_close(file));
    }
    const std::string note = open(1.0).notes.back();
    const auto volume = [](const std::string& text) {
        return std::stod(text.substr(std::string("the cells hold ").size()));
    };
    EXPECT_LT(volume(note), volume(whole)) << note;
}

TEST_F(MeshRun, AnugaMayBeginAtADate) {
    path = folder / "run.sww";
    write_anuga(path, 1.6e9);
    const ForeignRun run = open();
    EXPECT_EQ(run.times.date(run.times.times[0]), "2020-09-13 12:26:40 UTC");
}

TEST_F(MeshRun, SchismInDegrees) {
    write_schism(path);
    const ForeignRun run = open();
    EXPECT_EQ(run.model, "SCHISM");
    EXPECT_EQ(run.find(Quantity::bed)->name, "depth");
    EXPECT_TRUE(run.scale.place->degrees);
    EXPECT_DOUBLE_EQ(run.scale.place->west, 10.0);
    EXPECT_NEAR(run.nx * run.scale.dx, 157.7, run.scale.dx);
    EXPECT_NEAR(run.ny * run.scale.dy, 111.1, run.scale.dy);
    const Snapshot last = foreign_snapshot(run, 1);
    EXPECT_DOUBLE_EQ(last.bed(0, 0), -4.0);
    EXPECT_NEAR(water_at(last, 1, 1), 5.0, 1e-6);
}

TEST_F(MeshRun, WhatIsWrongIsOneLine) {
    write_delft3d_fm(path, -1);
    EXPECT_EQ(refusal(), "");  // counts from −1
    {
        const NetcdfMaker maker(path);
        const int network = maker.variable("network1d", NC_INT, {});
        maker.text(network, "cf_role", "mesh_topology");
        maker.text(network, "node_coordinates", "x y");
    }
    EXPECT_EQ(refusal(), path.string() +
                             ": holds a network of lines and no mesh with faces; name the file of "
                             "the model's map of two dimensions");
    {
        const NetcdfMaker maker(path);
        const int mesh = maker.variable("mesh2d", NC_INT, {});
        maker.text(mesh, "cf_role", "mesh_topology");
        maker.text(mesh, "node_coordinates", "x y");
        maker.text(mesh, "face_node_connectivity", "faces");
    }
    EXPECT_NE(refusal().find("its mesh mesh2d names the variable \"x\", which it has not"),
              std::string::npos);
}

TEST_F(MeshRun, PartitionsAreNotOneMesh) {
    write_delft3d_fm(folder / "part_0000_map.nc");
    write_sfincs_quadtree(folder / "part_0001_map.nc");
    const std::string message = message_of<InputError>([&] {
        const ForeignRun run = open_foreign_run((folder / "part_*_map.nc").string());
        for (std::size_t i = 0; i < run.times.times.size(); ++i) (void)foreign_snapshot(run, i);
    });
    EXPECT_NE(message.find("all files of a run need the same mesh; join partitions first"),
              std::string::npos)
        << message;
}

TEST_F(MeshRun, AMapOverTheFacesTwiceIsReadOnceInAFurtherFile) {
    write_delft3d_fm(path);
    {
        const NetcdfMaker maker(folder / "other.nc");
        const int faces = maker.dimension("mesh2d_nFaces", 3);
        const int s1 = maker.variable("mesh2d_s1", NC_DOUBLE, {faces, faces});
        maker.values(s1, {3, 3}, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    }
    const NetcdfLock lock;
    const NetcdfInput first(path);
    const auto mesh = lay_mesh(first, *find_mesh(first), 5.0);
    const NetcdfInput second(folder / "other.nc");
    ForeignMap map;
    map.variable.name = "mesh2d_s1";
    map.place = MapPlace::faces;
    map.side = "mesh2d_nFaces";
    EXPECT_EQ(mesh->values(second, map, 0), (std::vector<double>{1, 4, 7}));
}

TEST_F(MeshRun, AStartIndexThatIsNoNumberIsFoundByTheNodes) {
    write_delft3d_fm(path);
    {
        int file = 0;
        int connectivity = 0;
        const double none = std::nan("");
        must(nc_open(path.c_str(), NC_WRITE, &file));
        must(nc_inq_varid(file, "mesh2d_face_nodes", &connectivity));
        must(nc_redef(file));
        must(nc_put_att_double(file, connectivity, "start_index", NC_DOUBLE, 1, &none));
        must(nc_close(file));
    }
    expect_delft3d_fm(open());
}

TEST(MeshGrid, CellsTileAMeshWithoutGaps) {
    // A square of 8 × 8 m in triangles around a node off all rows, and a concave polygon beside it.
    FaceMesh mesh;
    mesh.x = {0, 8, 8, 0, 3.3, 16, 16, 12};
    mesh.y = {0, 0, 8, 8, 4.7, 0, 8, 4};
    mesh.corners = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 5, 7, 6, 2};
    mesh.ends = {3, 6, 9, 12, 17};
    const MeshGrid grid(mesh, 1.0);
    ASSERT_EQ(grid.nx(), 16);
    ASSERT_EQ(grid.ny(), 8);
    const std::vector<double> faces{1, 2, 3, 4, 5};
    const Grid values = grid.of_faces(faces);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) EXPECT_TRUE(std::isfinite(values(x, y))) << x << ", " << y;
    }
    EXPECT_DOUBLE_EQ(values(9, 4), 5.0);
    EXPECT_TRUE(std::isnan(values(14, 4)));  // in the notch
    EXPECT_DOUBLE_EQ(grid.integral_of_faces(std::vector<double>(5, 1.0)), 112.0);
    const Grid plane = grid.of_nodes(mesh.x);  // a plane is kept
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) EXPECT_NEAR(plane(x, y), x + 0.5, 1e-5);
    }
}

}  // namespace
}  // namespace fumon::test
