#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace fumon {

enum class VectorShape { points, lines, areas };

/// East and north, in a reference system's coordinates.
using VectorPoint = std::array<double, 2>;

/// A thing of a vector layer. Parts are points one by one, lines, or the rings of areas, holes
/// among them (even-odd).
struct VectorFeature {
    VectorShape shape = VectorShape::lines;
    std::vector<std::vector<VectorPoint>> parts;
    std::string label;  ///< the value of the field that was asked for
};

struct VectorLayer {
    std::vector<VectorFeature> features;  ///< those that have a geometry
    std::string crs;                      ///< WKT 2; empty where the file names none
};

/// What of a vector file to read.
struct VectorQuery {
    std::string name;   ///< the layer; empty: the only one
    std::string where;  ///< a condition on its fields, as in SQL; empty: all features
    std::string label;  ///< a field; empty: none
    long long most_points = 20'000'000;
    bool trusted = true;  ///< else formats that name no other file: GeoJSON, FlatGeobuf
};

/// Reads a layer of a vector file (GeoJSON, GeoPackage, shapefile, FlatGeobuf, KML, GML) by GDAL;
/// curves become lines, heights and measures are left out. Throws InputError without the file's
/// name where it cannot be read, or has too many points, geometry collections or surfaces;
/// KeyError for "name", "where" or "label" where it has no such layer or field, or several and none
/// is named. Longitude or easting is first, whatever the system says.
VectorLayer read_vector_layer(const std::filesystem::path& file, const VectorQuery& query);

}  // namespace fumon
