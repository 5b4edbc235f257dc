#pragma once

#include <string>
#include <vector>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// Where the pixels of a picture lie on a map: the centre of the pixel in column i and row j from
/// the top is at x = west + (i + 0.5)·pixel_x, y = north − (j + 0.5)·pixel_y, in the unit of the
/// reference system.
struct MapFrame {
    double west = 0.0;
    double north = 0.0;
    double pixel_x = 1.0;
    double pixel_y = 1.0;
    std::string crs;  ///< as WKT; empty where it is unknown
};

/// That of a picture of camera.projection = "map". Throws KeyError, of the key that asks for it,
/// where the camera looks otherwise or the bed lies nowhere on a map.
MapFrame map_frame(const View& view, const Snapshot& snapshot, const char* key);

/// A file that stands beside a picture: picture.png gets picture.pgw and picture.png.aux.xml,
/// picture.jpg picture.jgw and picture.jpg.aux.xml.
struct WorldFile {
    std::string ending;  ///< ".pgw", ".png.aux.xml", in the place of the picture's
    std::string text;
};

/// The world file of six lines, and the auxiliary file of GDAL with the reference system, which
/// QGIS and ArcGIS read too; `ending`: the picture's.
std::vector<WorldFile> world_files(const MapFrame& frame, const std::string& ending = ".png");

}  // namespace fumon
