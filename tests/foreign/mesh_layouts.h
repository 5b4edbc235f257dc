#pragma once

#include <netcdf.h>

#include <filesystem>
#include <string>
#include <vector>

#include "foreign/foreign_layouts.h"

namespace fumon::test {

/// As D-Flow FM writes its map files (Delft3D FM user manual, "Map file format UGRID", of the UGRID
/// conventions 1.0): two squares of 10 m beside each other and a triangle of 10 m on the right,
/// corners filled up, levels and depths at faces, the bed at faces and nodes. Two records; faces
/// count from `start`.
inline void write_delft3d_fm(const std::filesystem::path& file, int start = 1,
                             const std::string& mesh = "mesh2d") {
    const NetcdfMaker maker(file);
    const auto named = [&](const char* name) { return mesh + "_" + name; };
    const int nodes = maker.dimension(named("nNodes").c_str(), 7);
    const int faces = maker.dimension(named("nFaces").c_str(), 3);
    const int corners = maker.dimension(named("nMax_face_nodes").c_str(), 4);
    const int time = maker.dimension("time", 2);
    maker.text(NC_GLOBAL, "source", "D-Flow FM 1.2.131");
    const int topology = maker.variable(mesh.c_str(), NC_INT, {});
    maker.text(topology, "cf_role", "mesh_topology");
    maker.number(topology, "topology_dimension", NC_INT, {2});
    maker.text(topology, "node_coordinates", named("node_x") + " " + named("node_y"));
    maker.text(topology, "face_node_connectivity", named("face_nodes"));
    maker.text(topology, "face_dimension", named("nFaces"));
    const auto over = [&](const char* name, const std::vector<int>& dimensions,
                          const std::string& unit, const std::string& standard_name) {
        return described(maker, named(name).c_str(), dimensions, unit, standard_name);
    };
    const int x = over("node_x", {nodes}, "m", "projection_x_coordinate");
    const int y = over("node_y", {nodes}, "m", "projection_y_coordinate");
    const int z = over("node_z", {nodes}, "m", "altitude");
    const int centre = over("face_x", {faces}, "m", "projection_x_coordinate");
    const int connectivity = maker.variable(named("face_nodes").c_str(), NC_INT, {faces, corners});
    maker.number(connectivity, "_FillValue", NC_INT, {-999});
    maker.number(connectivity, "start_index", NC_INT, {static_cast<double>(start)});
    const int t = described(maker, "time", {time}, "seconds since 2001-01-01 00:00:00 +00:00");
    const int bl = over("flowelem_bl", {faces}, "m", "altitude");
    const int s0 = over("s0", {time, faces}, "m", "sea_surface_height");
    const int s1 = over("s1", {time, faces}, "m", "sea_surface_height");
    const int depth = over("waterdepth", {time, faces}, "m", "sea_floor_depth_below_sea_surface");
    const int ucx = over("ucx", {time, faces}, "m s-1", "sea_water_x_velocity");
    for (const int variable : {s1, depth}) maker.number(variable, "_FillValue", NC_FLOAT, {-999});
    maker.values(x, {7}, {1000, 1010, 1020, 1000, 1010, 1020, 1030});
    maker.values(y, {7}, {2000, 2000, 2000, 2010, 2010, 2010, 2000});
    maker.values(z, {7}, {5, 5, 5, 5, 5, 5, 5});
    maker.values(centre, {3}, {1005, 1015, 1023});
    std::vector<double> numbers{0, 1, 4, 3, 1, 2, 5, 4, 2, 6, 5};
    for (double& number : numbers) number += start;
    numbers.push_back(-999);
    maker.values(connectivity, {3, 4}, numbers);
    maker.values(t, {2}, {0, 3600});
    maker.values(bl, {3}, {1, 2, 3});
    maker.values(s0, {2, 3}, {9, 9, 9, 9, 9, 9});
    maker.values(s1, {2, 3}, {3, 3, 3, 4, 4, 4});
    maker.values(depth, {2, 3}, {2, 1, 0, 3, 2, 1});
    maker.values(ucx, {2, 3}, {.5, .25, 0, 1, .5, .25});
}

/// As SFINCS writes the map of a quadtree (sfincs_ncoutput.F90, ncoutput_quadtree_map_init): a
/// square of 20 m whose right side is two squares of 10 m, nodes from 1, values at faces.
inline void write_sfincs_quadtree(const std::filesystem::path& file) {
    const NetcdfMaker maker(file);
    maker.text(NC_GLOBAL, "Producer", "SFINCS model: Super-Fast INundation of CoastS");
    const int nodes = maker.dimension("nmesh2d_node", 8);
    const int faces = maker.dimension("nmesh2d_face", 3);
    const int corners = maker.dimension("max_nmesh2d_face_nodes", 4);
    const int time = maker.dimension("time", 2);
    const int timemax = maker.dimension("timemax", 1);
    const int topology = maker.variable("mesh2d", NC_INT, {});
    maker.text(topology, "cf_role", "mesh_topology");
    maker.text(topology, "node_coordinates", "mesh2d_node_x mesh2d_node_y");
    maker.text(topology, "face_node_connectivity", "mesh2d_face_nodes");
    const int x = described(maker, "mesh2d_node_x", {nodes}, "m");
    const int y = described(maker, "mesh2d_node_y", {nodes}, "m");
    const int connectivity = maker.variable("mesh2d_face_nodes", NC_INT, {faces, corners});
    maker.number(connectivity, "start_index", NC_INT, {1});
    const int t = described(maker, "time", {time}, "seconds since 2019-08-31 14:00:00", "time");
    const int zb = described(maker, "zb", {faces}, "m", "altitude");
    const int zs =
        described(maker, "zs", {time, faces}, "m", "sea_surface_height_above_mean_sea_level");
    maker.number(zs, "_FillValue", NC_FLOAT, {-99999});
    const int zsmax = described(maker, "zsmax", {timemax, faces}, "m");
    maker.values(x, {8}, {0, 20, 30, 20, 30, 0, 20, 30});
    maker.values(y, {8}, {0, 0, 0, 10, 10, 20, 20, 20});
    maker.values(connectivity, {3, 4}, {1, 2, 7, 6, 2, 3, 5, 4, 4, 5, 8, 7});
    maker.values(t, {2}, {0, 1800});
    maker.values(zb, {3}, {0, 1, 2});
    maker.values(zs, {2, 3}, {1, -99999, -99999, 3, 3, -99999});
    maker.values(zsmax, {1, 3}, {3, 3, -99999});
}

/// As ANUGA writes an .sww (anuga.file.sww, Write_sww.store_header and store_triangulation): two
/// triangles of a square of 10 m whose bed rises to the east, .5 m of water over it and none in the
/// north-east; coordinates from the corner (300, 400), times without a unit.
inline void write_anuga(const std::filesystem::path& file, double starttime = 0.0) {
    const NetcdfMaker maker(file, NC_64BIT_OFFSET);
    maker.text(NC_GLOBAL, "institution", "Geoscience Australia");
    maker.number(NC_GLOBAL, "xllcorner", NC_DOUBLE, {300});
    maker.number(NC_GLOBAL, "yllcorner", NC_DOUBLE, {400});
    maker.number(NC_GLOBAL, "starttime", NC_DOUBLE, {starttime});
    const int volumes = maker.dimension("number_of_volumes", 2);
    const int vertices = maker.dimension("number_of_vertices", 3);
    const int points = maker.dimension("number_of_points", 4);
    const int steps = maker.dimension("number_of_timesteps", 2);
    const int of_volumes = maker.variable("volumes", NC_INT, {volumes, vertices});
    const int x = maker.variable("x", NC_FLOAT, {points});
    const int y = maker.variable("y", NC_FLOAT, {points});
    const int elevation = maker.variable("elevation", NC_FLOAT, {points});
    const int time = maker.variable("time", NC_DOUBLE, {steps});
    const int stage = maker.variable("stage", NC_FLOAT, {steps, points});
    const int xmomentum = maker.variable("xmomentum", NC_FLOAT, {steps, points});
    maker.values(of_volumes, {2, 3}, {0, 1, 2, 1, 3, 2});
    maker.values(x, {4}, {0, 10, 0, 10});
    maker.values(y, {4}, {0, 0, 10, 10});
    maker.values(elevation, {4}, {0, 1, 0, 1});
    maker.values(time, {2}, {0, 7200});
    maker.values(stage, {2, 4}, {.5, 1.5, .5, 1, 1.5, 2.5, 1.5, 2});
    maker.values(xmomentum, {2, 4}, {.5, .5, .5, 0, .5, .5, .5, .5});
}

/// As SCHISM writes out2d_*.nc (its manual, "Outputs"; UGRID): a triangle and a quadrangle on five
/// nodes in degrees, the bed a depth that grows downward.
inline void write_schism(const std::filesystem::path& file) {
    const NetcdfMaker maker(file);
    const int nodes = maker.dimension("nSCHISM_hgrid_node", 5);
    const int faces = maker.dimension("nSCHISM_hgrid_face", 2);
    const int corners = maker.dimension("nMaxSCHISM_hgrid_face_nodes", 4);
    const int time = maker.dimension("time", 2);
    const int topology = maker.variable("SCHISM_hgrid", NC_CHAR, {});
    maker.text(topology, "cf_role", "mesh_topology");
    maker.text(topology, "node_coordinates", "SCHISM_hgrid_node_x SCHISM_hgrid_node_y");
    maker.text(topology, "face_node_connectivity", "SCHISM_hgrid_face_nodes");
    const int x = described(maker, "SCHISM_hgrid_node_x", {nodes}, "degrees_east", "longitude");
    const int y = described(maker, "SCHISM_hgrid_node_y", {nodes}, "degrees_north", "latitude");
    const int connectivity = maker.variable("SCHISM_hgrid_face_nodes", NC_INT, {faces, corners});
    maker.number(connectivity, "start_index", NC_INT, {1});
    maker.number(connectivity, "_FillValue", NC_INT, {-1});
    const int t = described(maker, "time", {time}, "seconds since 2021-05-01 00:00:00 +0000");
    const int depth = described(maker, "depth", {nodes}, "m");
    maker.text(depth, "positive", "down");
    const int level = described(maker, "elevation", {time, nodes}, "m");
    maker.values(x, {5}, {10.000, 10.001, 10.002, 10.000, 10.001});
    maker.values(y, {5}, {45.000, 45.000, 45.000, 45.001, 45.001});
    maker.values(connectivity, {2, 4}, {1, 2, 5, 4, 2, 3, 5, -1});
    maker.values(t, {2}, {3600, 7200});
    maker.values(depth, {5}, {4, 4, 4, 4, 4});
    maker.values(level, {2, 5}, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1});
}

}  // namespace fumon::test
