#pragma once

#include <string>

namespace fumon {

/// Where a grid lies on the Earth, in the unit of its coordinate reference system: metres, feet or
/// degrees. The grid's rows run east and its columns north (row 0 is the southernmost), whatever
/// the order in its file.
struct GeoReference {
    double west = 0.0;     ///< x of the grid's western edge
    double south = 0.0;    ///< y of the grid's southern edge
    double dx = 1.0;       ///< cell size eastward
    double dy = 1.0;       ///< cell size northward
    bool degrees = false;  ///< x is a longitude, y a latitude
    std::string crs{};     ///< the coordinate reference system as WKT; empty where it is unknown

    friend bool operator==(const GeoReference&, const GeoReference&) = default;
};

}  // namespace fumon
